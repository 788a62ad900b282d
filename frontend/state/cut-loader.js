// @ts-check

import { createLatest } from "./latest.js";
import { axesMuOverAlpha, heldView, mapView, sameView } from "./map-view.js";

/** @typedef {import("../api/answers.js").CutWish} CutWish */

/** Points along the cut. */
export const FULL_CUT = 800;

/** While κ or μ/α is dragged: the trace goes first. */
export const QUICK_CUT = 200;

/** At most so often, in ms. */
const PAUSE = 50;

/**
 * The cut that belongs to a state: along the vertical axis of the map, at the present κ.
 * @template Cut
 * @param {object} options
 * @param {(wish: CutWish, signal: AbortSignal) => Promise<Cut>} options.load
 * @param {(cut: Cut, wish: CutWish) => void} options.onCut
 * @param {(error: unknown) => void} options.onError
 */
export function createCutLoader({ load, onCut, onError }) {
  /** @type {CutWish | null} */
  let asked = null;
  const latest = createLatest({ load, onAnswer: onCut, onError, pause: PAUSE });

  return {
    /**
     * @param {import("./url.js").PageState} state
     * @param {boolean} dragging
     */
    follow(state, dragging) {
      const { kappa } = state.collision;
      const view =
        dragging && asked ? heldView(asked.view, state.collision) : mapView(state.collision, state);
      const muOverAlpha = axesMuOverAlpha(view, state.collision);
      const isAsked =
        asked?.kappa === kappa &&
        asked.muOverAlpha === muOverAlpha &&
        sameView(asked.view, view) &&
        (dragging || asked.count === FULL_CUT);
      if (!isAsked) {
        asked = { kappa, muOverAlpha, view, count: dragging ? QUICK_CUT : FULL_CUT };
        latest.request(asked);
      }
    },

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      asked = null;
    },
  };
}
