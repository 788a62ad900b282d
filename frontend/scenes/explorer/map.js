// @ts-check

import { mapFigure } from "../../figures/map-figure.js";
import { alphaInWords, typable } from "../../format/number.js";
import { say } from "../../format/words.js";
import { impactName, placeOnMap } from "../../state/map-view.js";
import { SOLID_ALPHA } from "../../state/parameters.js";
import { lettersOf } from "../../state/presets.js";
import { isBeyond } from "../../state/scales.js";
import { choose, chooseShape, onChoice } from "../../widgets/choices.js";
import { MAP_AXES, mountCrosshair } from "../../widgets/plots/crosshair.js";
import { byTestId, find } from "../../widgets/find.js";
import { createMapLegend } from "../../widgets/plots/map-legend.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { createSurface } from "../../widgets/plots/surface.js";
import { onThemeChange } from "../../widgets/theme.js";
import { NO_GHOSTS } from "./ghosts.js";

/**
 * The map with its crosshair, which is laid over the plot so that moving it draws nothing anew.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(place: Record<string, number>, change: import("../../state/store.js").Change) => void} handlers.onPlace
 * @param {(patch: Partial<import("../../state/address/options.js").PageState>) => void} handlers.onOption
 */
export function mountMap(element, { onPlace, onOption }) {
  const plotElement = find(".plot", element);
  let ghosts = NO_GHOSTS;
  const plot = createPlot(
    plotElement,
    (/** @type {Parameters<typeof mapFigure>[0]} */ map, theme, size) => {
      const figure = mapFigure(map, theme, size);
      figure.data.push(
        ...ghosts.marks(({ collision }) => placeOnMap(map.view, collision), figure, theme),
      );
      return figure;
    },
  );
  const legend = createMapLegend(find(".map-legend", element));
  const crosshair = mountCrosshair(find(".crosshair", element), MAP_AXES, onPlace);
  const surface = createSurface(find(".plot-stage", element));
  const alphaReset = byTestId("alpha-reset", element);
  /** @type {import("../../figures/map-figure.js").ShownMap | null} */
  let shown = null;
  /** @type {import("../../state/presets.js").Letter[]} */
  let letters = [];
  let chosen = "";
  /** @type {import("../../api/answers.js").CollisionAnswer | null} */
  let settled = null;

  function pointSurface() {
    if (shown && settled) {
      const { epsilon_t, switches } = settled;
      const place = placeOnMap(shown.view, settled.parameters);
      surface.point(isBeyond(place) ? null : { ...place, epsilon_t, switches });
    }
  }

  onChoice(element, onOption);

  alphaReset.addEventListener("click", () => onOption({ alpha: SOLID_ALPHA }));

  function drawLegend() {
    if (shown) {
      legend.draw(shown.quantity, shown.most ?? 0);
    }
  }
  onThemeChange(drawLegend);

  function drawFlat(quickly = false) {
    if (shown) {
      plot.show({ ...shown, letters }, quickly);
    }
  }

  return {
    legend,

    /** @param {typeof ghosts} next */
    showGhosts(next) {
      ghosts = next;
      if (element.dataset.shape === "flat") {
        drawFlat();
      }
    },

    /** @param {import("../../api/answers.js").Preset[]} presets among which the letters of Fig. 5 are */
    offer(presets) {
      letters = lettersOf(presets);
      if (shown && element.dataset.shape === "flat") {
        drawFlat();
      }
    },

    /**
     * @param {import("../../figures/map-figure.js").ShownMap} map
     * @param {"flat" | "surface"} shape
     * @param {boolean} quickly as one of many in a row
     */
    show(map, shape, quickly) {
      shown = map;
      element.dataset.shape = shape;
      if (shape === "surface") {
        pointSurface();
        surface.show(map);
      } else {
        surface.close();
        drawFlat(quickly);
      }
      drawLegend();
      crosshair.lieOn(map.view);
      plotElement.setAttribute("aria-label", described(map));
    },

    point: crosshair.point,

    /** @param {import("../../state/address/options.js").PageState} state */
    options({ map, scale, map_x, map_y, shape, alpha }) {
      const options = { map, scale, map_x, map_y };
      const wanted = JSON.stringify([options, shape, alpha]);
      if (wanted === chosen) {
        return;
      }
      chosen = wanted;
      choose(element, options);
      chooseShape(element, shape);
      alphaReset.hidden = alpha === SOLID_ALPHA;
      find("span", alphaReset).textContent = alphaInWords(alpha);
    },

    /**
     * What the server says of the present collision.
     * @param {import("../../api/answers.js").CollisionAnswer} result
     * @param {boolean} dragging
     */
    settle(result, dragging) {
      legend.point(result);
      if (!dragging) {
        settled = result;
        pointSurface();
      }
    },
  };
}

/** @param {import("../../figures/map-figure.js").ShownMap} map */
function described({ quantity, view: { kappa, gtOverGn, vertical } }) {
  return say(`map.described.${quantity}`, {
    left: typable(kappa.min),
    right: typable(kappa.max),
    impact: impactName(vertical),
    bottom: typable(gtOverGn.min),
    top: typable(gtOverGn.max),
  });
}
