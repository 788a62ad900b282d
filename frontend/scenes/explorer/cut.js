// @ts-check

import { CUT_MARGIN } from "../../figures/plot-area.js";
import { valueAt } from "../../figures/sample.js";
import { significant } from "../../format/number.js";
import {
  axesInWords,
  axesMuOverAlpha,
  gtOverGnAt,
  heightOf,
  placeOnMap,
} from "../../state/map-view.js";
import { lettersOf } from "../../state/presets.js";
import { placeWithin } from "../../state/scales.js";
import { followDrag } from "../../widgets/drag.js";
import { find } from "../../widgets/find.js";
import { createMark } from "../../widgets/mark.js";
import { layOver } from "../../widgets/overlay.js";
import { createPlot } from "../../widgets/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { cutFigure } from "./cut-figure.js";

/**
 * @typedef {Parameters<typeof cutFigure>[0]} ShownCut
 * @typedef {import("../../state/parameters.js").Collision} Collision
 */

/**
 * The cut with a mark at the present collision, which is laid over the plot so that moving it draws
 * nothing anew.
 * @param {HTMLElement} element
 * @param {(place: {gt_over_gn?: number}, change: import("../../state/store.js").Change) => void} onPlace
 */
export function mountCut(element, onPlace) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, (/** @type {ShownCut} */ subject, theme, size) => {
    const figure = cutFigure(subject, theme, size);
    range = figure.layout.yaxis.range;
    moveMark();
    return figure;
  });
  const stage = find(".plot-stage", element);
  const mark = find(".cut-mark", element);
  layOver(mark, CUT_MARGIN);
  const ring = createMark(mark);
  /** @type {[number, number]} */
  let range = [-1, 1];
  /** @type {ShownCut | null} */
  let shown = null;
  /** @type {import("../../state/presets.js").Letter[]} */
  let letters = [];
  /** @type {Collision | null} */
  let present = null;
  let epsilon = 0;
  let isOnCurve = false;
  let most = 0;

  followDrag(mark, {
    mark: () => (shown && present ? { x: placeOnMap(shown.view, present).y } : {}),
    onMove(x, _, change) {
      if (shown && present) {
        onPlace({ gt_over_gn: gtOverGnAt(shown.view, x, present.mu_over_alpha) }, change);
      }
    },
    onEnd: (change) => onPlace({}, change),
  });

  function moveMark() {
    if (!shown || !present) {
      return;
    }
    const [low, high] = range;
    const words = axesInWords(shown.view, present);
    ring.show(
      placeWithin(
        shown.view.gtOverGn.toShare(heightOf(shown.view.vertical, present)),
        (epsilon - low) / (high - low),
      ),
      {
        x: `${words.y}: ε_t = ${significant(epsilon)}`,
        y: `ε_t = ${significant(epsilon)}`,
      },
    );
  }

  /** @param {boolean} quickly */
  function draw(quickly) {
    if (shown) {
      plot.show({ ...shown, letters, most }, quickly);
    }
  }

  return {
    /**
     * @param {Omit<ShownCut, "letters" | "most">} next
     * @param {boolean} dragging
     */
    show(next, dragging) {
      shown = { ...next, letters, most };
      showReason(stage, "");
      draw(dragging);
      plotElement.setAttribute(
        "aria-label",
        `Coefficient of tangential restitution over g_t/g_n at κ = ${next.kappa}, with Coulomb's law and the limits of a stiff spring; the slider of g_t/g_n moves the mark.`,
      );
    },

    /** @param {string} reason */
    showReason: (reason) => showReason(stage, reason),

    /** @param {import("../../api/answers.js").Preset[]} presets among which the letters of Fig. 5 are */
    offer(presets) {
      letters = lettersOf(presets);
      draw(false);
    },

    /** The number of switches up to which the map has colours. @param {number} count */
    colorUpTo(count) {
      if (count !== most) {
        most = count;
        draw(false);
      }
    },

    /**
     * At once, at the height of the curve, if that is of this collision's κ and μ/α.
     * @param {Collision} collision
     */
    point(collision) {
      present = collision;
      isOnCurve =
        shown?.kappa === collision.kappa &&
        shown.muOverAlpha === axesMuOverAlpha(shown.view, collision) &&
        placeOnMap(shown.view, collision).beyond.y === 0;
      if (shown && isOnCurve) {
        epsilon = valueAt(shown.cut.epsilon_t, placeOnMap(shown.view, collision).y);
      }
      moveMark();
    },

    /**
     * At the height that the server gives, unless that is behind what the curve tells.
     * @param {{parameters: Collision, epsilon_t: number}} result
     */
    settle({ parameters, epsilon_t }) {
      if (!isOnCurve || parameters.gt_over_gn === present?.gt_over_gn) {
        epsilon = epsilon_t;
        moveMark();
      }
    },
  };
}
