// @ts-check

import { typable } from "../../format/number.js";
import { say } from "../../format/words.js";
import { clamp, isBeyond, placeWithin } from "../../state/scales.js";
import { choose, chooseShape, onChoice } from "../../widgets/choices.js";
import { mountCrosshair } from "../../widgets/plots/crosshair.js";
import { byTestId, find } from "../../widgets/find.js";
import { createMapLegend } from "../../widgets/plots/map-legend.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { createSurface } from "../../widgets/plots/surface.js";
import { onThemeChange } from "../../widgets/theme.js";
import { velocityMapFigure } from "./velocity-map-figure.js";

/**
 * @typedef {import("../../api/answers.js").Scaling} Scaling
 * @typedef {import("../../api/answers.js").VelocityMap} VelocityMap
 * @typedef {ReturnType<typeof import("../../state/impact.js").velocityView>} VelocityView
 * @typedef {import("../../state/address/options.js").PageState} PageState
 */

/** @type {import("../../widgets/plots/crosshair.js").Axes<VelocityView, {normal: number, tangential: number}>} */
const AXES = {
  place(view, { normal, tangential }) {
    return placeWithin(view.normal.toShare(normal), view.tangential.toShare(tangential));
  },
  at: (view, x, y) => ({
    normal_velocity_m_s: Number(view.normal.fromShare(clamp(x)).toPrecision(4)),
    tangential_velocity_m_s: Number(view.tangential.fromShare(clamp(y)).toPrecision(4)),
  }),
  horizontal: "normal_velocity_m_s",
  vertical: "tangential_velocity_m_s",
  words: (_, { normal, tangential }) => ({
    x: `g_n = ${typable(normal)} m/s`,
    y: `g_t = ${typable(tangential)} m/s`,
  }),
};

/**
 * ε_t over the velocities of an impact, flat or in depth.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {Parameters<typeof mountCrosshair>[2]} handlers.onPlace
 * @param {(patch: Record<string, string>) => void} handlers.onOption
 */
export function mountVelocityMap(element, { onPlace, onOption }) {
  const plotElement = find(".plot", element);
  const stage = find(".plot-stage", element);
  const plot = createPlot(plotElement, velocityMapFigure);
  const surface = createSurface(stage);
  const legend = createMapLegend(byTestId("velocity-legend", element));
  const crosshair = mountCrosshair(find(".crosshair", element), AXES, onPlace);
  onThemeChange(() => legend.draw("epsilon_t", 0));
  /** @type {{map: VelocityMap, view: VelocityView} | null} */
  let shown = null;
  /** @type {Omit<Scaling, "epsilon_t"> & {epsilon_t: number | null} | null} */
  let settled = null;

  onChoice(element, onOption);

  function pointSurface() {
    if (shown && settled && settled.epsilon_t !== null) {
      const { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential } = settled;
      const place = AXES.place(shown.view, { normal, tangential });
      const { epsilon_t, switches } = settled;
      surface.point(isBeyond(place) ? null : { ...place, epsilon_t, switches });
    }
  }

  return {
    /** @param {PageState} state */
    options({ velocity_law, velocity_scale, shape }) {
      choose(element, { velocity_law, velocity_scale });
      chooseShape(element, shape);
    },

    point: crosshair.point,

    /**
     * @param {VelocityMap} map
     * @param {VelocityView} view
     * @param {PageState} state
     */
    show(map, view, { velocity_law, shape }) {
      const law = velocity_law === "coulomb" ? "coulomb" : "epsilon_t";
      shown = { map, view };
      showReason(stage, "");
      element.dataset.shape = shape;
      if (shape === "surface") {
        pointSurface();
        surface.show(inDepth(map, law, view));
      } else {
        surface.close();
        plot.show({ cells: map[law], view });
      }
      crosshair.lieOn(view);
      legend.draw("epsilon_t", 0);
      plotElement.setAttribute(
        "aria-label",
        say(`spheres.velocities.described.${law}`, { most: typable(view.most) }),
      );
    },

    /** Why there is none, the impact itself tells. */
    showReason: () => showReason(stage, say("spheres.velocities.none")),

    /**
     * What is known of the present impact.
     * @param {Scaling} scaling
     * @param {number | null} epsilon its ε_t by the law that is shown
     */
    settle(scaling, epsilon) {
      settled = { ...scaling, epsilon_t: epsilon };
      if (epsilon !== null) {
        legend.point({ epsilon_t: epsilon, switches: scaling.switches });
      }
      pointSurface();
    },
  };
}

/**
 * The map of velocities in the words of a surface.
 * @param {VelocityMap} map
 * @param {"epsilon_t" | "coulomb"} law
 * @param {VelocityView} view
 */
function inDepth(map, law, { normal, tangential, scale }) {
  const cells = map[law];
  return {
    grid: {
      kappa: map.normal_velocity_m_s,
      gt_over_gn: map.tangential_velocity_m_s,
      epsilon_t: cells,
      // Of these there is no picture over the velocities.
      switches: [],
    },
    view: {
      scale,
      vertical: /** @type {const} */ ("tangential_velocity"),
      gtOverGn: tangential,
    },
    horizontal: { symbol: /** @type {const} */ ("normal_velocity"), scale: normal },
    quantity: /** @type {const} */ ("epsilon_t"),
  };
}
