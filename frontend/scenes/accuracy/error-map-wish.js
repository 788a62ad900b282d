// @ts-check

import { accuracyQuery, canAnswer, failingOf } from "../../state/accuracy.js";
import { isSame } from "../../state/loading/follower.js";
import { axesFor, sameAxes } from "../../state/map-view.js";

/**
 * @typedef {import("../../state/map-view.js").MapAxes} MapAxes
 * @typedef {import("../../state/map-view.js").Counts} Counts
 * @typedef {import("../../api/queries.js").ErrorMapWish} ErrorMapWish
 */

export const FULL_ERROR_MAP = { kappa: 200, gtOverGn: 150 };
const QUICK = { kappa: 60, gtOverGn: 45 };
/** A solver takes milliseconds for each. */
const FEW = { kappa: 24, gtOverGn: 18 };
/** Steps of one map: about a tenth of a second of the server. */
const MOST_STEPS = 3e8;

/**
 * The map of the error of the chosen method, on the axes of the map; null where it does not answer in all corners.
 * @param {Pick<import("../../state/address/options.js").PageState, "collision" | "accuracy" | "scale" | "map_y">} state
 * @param {boolean} dragging
 * @param {ErrorMapWish | null} asked before
 * @returns {ErrorMapWish | null}
 */
export function errorMapWish(state, dragging, asked) {
  const accuracy = failingOf(state.accuracy);
  const axes = axesFor(state, dragging, asked?.view);
  return coversAll(accuracy.method, axes)
    ? { ...axes, counts: countsFor(accuracy, dragging), accuracy: accuracyQuery(accuracy) }
    : null;
}

/** @param {ErrorMapWish} asked @param {ErrorMapWish} wish */
export function isEnoughErrorMap(asked, wish) {
  return (
    sameAxes(asked, wish) &&
    isSame(asked.accuracy, wish.accuracy) &&
    asked.counts.kappa >= wish.counts.kappa
  );
}

/**
 * @param {import("../../state/accuracy.js").Accuracy} accuracy
 * @param {boolean} dragging
 * @returns {Counts}
 */
function countsFor({ method, steps }, dragging) {
  if (method === "ode") {
    return FEW;
  }
  const counts = dragging ? QUICK : FULL_ERROR_MAP;
  if (method !== "timestep") {
    return counts;
  }
  const share = Math.sqrt(MOST_STEPS / (steps * counts.kappa * counts.gtOverGn));
  return share >= 1
    ? counts
    : {
        kappa: Math.max(FEW.kappa, Math.floor(share * counts.kappa)),
        gtOverGn: Math.max(FEW.gtOverGn, Math.floor(share * counts.gtOverGn)),
      };
}

/**
 * Whether a method answers in all corners of the axes.
 * @param {string} method
 * @param {MapAxes} axes
 */
function coversAll(method, { view: { kappa, gtOverGn, damping }, muOverAlpha }) {
  return [kappa.min, kappa.max].every((k) =>
    [gtOverGn.min, gtOverGn.max].every((gt) =>
      canAnswer(method, { kappa: k, mu_over_alpha: muOverAlpha, gt_over_gn: gt, damping }),
    ),
  );
}
