// @ts-check

import { CUT_MARGIN } from "../../../figures/plot-area.js";
import { valueAt } from "../../../figures/sample.js";
import { significant } from "../../../format/number.js";
import { PLAIN_SYMBOLS } from "../../../format/symbols.js";
import { say } from "../../../format/words.js";
import {
  axesInWords,
  axesMuOverAlpha,
  heightOf,
  impactName,
  placeOnCut,
} from "../../../state/map-view.js";
import { lettersOf } from "../../../state/presets.js";
import { clamp, placeWithin } from "../../../state/scales.js";
import { choose, onChoice } from "../../../widgets/choices.js";
import { followDrag } from "../../../widgets/drag.js";
import { byTestId, find } from "../../../widgets/find.js";
import { createMark } from "../../../widgets/plots/mark.js";
import { layOver } from "../../../widgets/plots/overlay.js";
import { createPlot } from "../../../widgets/plots/plot.js";
import { showReason } from "../../../widgets/show-reason.js";
import { typeset } from "../../../widgets/typeset.js";
import { NO_GHOSTS } from "../ghosts.js";
import { cutFigure, hasStiffLimit } from "./cut-figure.js";

/**
 * @typedef {Parameters<typeof cutFigure>[0]} ShownCut
 * @typedef {Omit<ShownCut, "letters" | "most" | "vertical">} LoadedCut
 * @typedef {import("../../../state/parameters.js").Collision} Collision
 * @typedef {import("../../../state/address/options.js").PageState} PageState
 */

/**
 * The cut with a mark at the present collision, which is laid over the plot so that moving it draws
 * nothing anew.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(place: {gt_over_gn?: number, kappa?: number}, change: import("../../../state/store.js").Change) => void} handlers.onPlace
 * @param {(patch: Partial<PageState>) => void} handlers.onOption
 */
export function mountCut(element, { onPlace, onOption }) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, (/** @type {ShownCut} */ subject, theme, size) => {
    const figure = cutFigure(subject, theme, size);
    axis = figure.axis;
    moveMark();
    figure.data.push(
      ...ghosts.marks((ghost) => placeOf(subject, ghost, figure.axis), figure, theme),
    );
    return figure;
  });
  const stage = find(".plot-stage", element);
  const mark = find(".cut-mark", element);
  const title = find("h2", element);
  layOver(mark, CUT_MARGIN);
  const ring = createMark(mark);
  /** @type {import("./vertical-axis.js").VerticalAxis | null} */
  let axis = null;
  /** @type {LoadedCut | null} */
  let shown = null;
  /** @type {ShownCut["vertical"]} */
  let vertical = "linear";
  /** @type {import("../../../state/presets.js").Letter[]} */
  let letters = [];
  /** @type {Collision | null} */
  let present = null;
  let chosen = "";
  let epsilon = 0;
  let isOnCurve = false;
  let most = 0;
  let ghosts = NO_GHOSTS;

  onChoice(element, onOption);
  followDrag(mark, {
    mark: () => (shown && present ? { x: placeWithin(shareOf(shown, present), 0).x } : {}),
    onMove(x, _, change) {
      if (shown && present) {
        onPlace(placeOnCut(shown.view, shown.along, x, present.mu_over_alpha), change);
      }
    },
    onEnd: (change) => onPlace({}, change),
  });

  function moveMark() {
    if (!shown || !present || !axis) {
      return;
    }
    const { view, along } = shown;
    const words = axesInWords(view, present);
    const place = placeOf(shown, { collision: present, epsilon_t: epsilon }, axis);
    const height = `ε_t = ${significant(epsilon)}`;
    const there = along === "kappa" ? words.x : words.y;
    ring.show(place, { x: `${there}: ${height}`, y: height });
    mark.toggleAttribute("data-negative", vertical === "log" && epsilon < 0);
  }

  /** @param {boolean} quickly */
  function draw(quickly) {
    if (shown) {
      plot.show({ ...shown, vertical, letters, most }, quickly);
      find(".stiff-limit-key", element).toggleAttribute("data-absent", !hasStiffLimit(shown.cut));
      plotElement.setAttribute("aria-label", described(shown, vertical));
    }
  }

  return {
    /**
     * @param {LoadedCut} next
     * @param {boolean} dragging
     */
    show(next, dragging) {
      shown = next;
      showReason(stage, "");
      draw(dragging);
    },

    /** @param {string} refusal of the server */
    showRefusal: (refusal) => showReason(stage, say("cut.none"), refusal),

    /** @param {import("../../../api/answers.js").Preset[]} presets among which the letters of Fig. 5 are */
    offer(presets) {
      letters = lettersOf(presets);
      draw(false);
    },

    /** @param {typeof ghosts} next */
    showGhosts(next) {
      ghosts = next;
      draw(false);
    },

    /**
     * @param {number} count of switches, up to which the map has colours
     * @param {boolean} dragging
     */
    colorUpTo(count, dragging) {
      if (count !== most) {
        most = count;
        draw(dragging);
      }
    },

    /** @param {PageState} state */
    options({ cut_x, cut_y, map_y }) {
      const wanted = `${cut_x} ${cut_y} ${map_y}`;
      if (wanted === chosen) {
        return;
      }
      chosen = wanted;
      const impact = impactName(map_y);
      choose(element, { cut_x, cut_y });
      typeset(title, say("cut.title", { held: cut_x === "kappa" ? impact : PLAIN_SYMBOLS.kappa }));
      typeset(byTestId("cut-over-impact", element), impact);
      find(".negative-key", element).hidden = cut_y !== "log";
      vertical = cut_y;
      draw(false);
    },

    /**
     * At once, at the height of the curve, if that is of this collision's κ and μ/α.
     * @param {Collision} collision
     */
    point(collision) {
      present = collision;
      isOnCurve = shown !== null && isOf(shown, collision);
      if (shown && isOnCurve) {
        epsilon = valueAt(shown.cut.epsilon_t, clamp(shareOf(shown, collision)));
      }
      moveMark();
    },

    /**
     * At the height that the server gives, unless that is behind what the curve tells.
     * @param {{parameters: Collision, epsilon_t: number}} result
     */
    settle({ parameters, epsilon_t }) {
      const key = shown?.along ?? "gt_over_gn";
      if (!isOnCurve || parameters[key] === present?.[key]) {
        epsilon = epsilon_t;
        moveMark();
      }
    },
  };
}

/**
 * Where a collision stands along a cut.
 * @param {Pick<ShownCut, "view" | "along">} cut
 * @param {Collision} collision
 */
function shareOf({ view, along }, collision) {
  return along === "kappa"
    ? view.kappa.toShare(collision.kappa)
    : view.gtOverGn.toShare(heightOf(view.vertical, collision));
}

/**
 * Where a collision stands on the picture of a cut, with its own ε_t.
 * @param {Pick<ShownCut, "view" | "along">} cut
 * @param {import("../ghosts.js").Ghost} ghost
 * @param {import("./vertical-axis.js").VerticalAxis} axis
 */
function placeOf(cut, { collision, epsilon_t }, axis) {
  return placeWithin(shareOf(cut, collision), axis.share(epsilon_t));
}

/**
 * Whether a cut goes through a collision, within its axis.
 * @param {LoadedCut} cut
 * @param {Collision} collision
 */
function isOf({ view, along, held, muOverAlpha }, collision) {
  if (placeWithin(shareOf({ view, along }, collision), 0).beyond.x !== 0) {
    return false;
  }
  return along === "kappa"
    ? held === collision.gt_over_gn && muOverAlpha === collision.mu_over_alpha
    : held === collision.kappa && muOverAlpha === axesMuOverAlpha(view, collision);
}

/**
 * @param {LoadedCut} cut
 * @param {ShownCut["vertical"]} vertical
 */
function described({ along, held, view }, vertical) {
  const isOverKappa = along === "kappa";
  const impact = impactName(view.vertical);
  return say(`cut.described.${vertical}`, {
    over: isOverKappa ? PLAIN_SYMBOLS.kappa : impact,
    held: isOverKappa ? PLAIN_SYMBOLS.gt_over_gn : PLAIN_SYMBOLS.kappa,
    value: held,
    slider: PLAIN_SYMBOLS[along],
  });
}
