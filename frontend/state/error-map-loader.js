// @ts-check

import { accuracyQuery, canAnswer, failingOf } from "./accuracy.js";
import { createLatest } from "./latest.js";
import { axesMuOverAlpha, heldView, mapView, sameView } from "./map-view.js";

/** @typedef {import("./map-view.js").MapView} MapView */
/** @typedef {{kappa: number, gtOverGn: number}} Counts cells along each axis */
/** @typedef {{muOverAlpha: number, view: MapView, counts: Counts, accuracy: Record<string, string>}} ErrorMapWish */

const FULL = { kappa: 200, gtOverGn: 150 };
const QUICK = { kappa: 60, gtOverGn: 45 };
/** A solver takes milliseconds for each. */
const FEW = { kappa: 24, gtOverGn: 18 };
/** Steps of one map: about a tenth of a second of the server. */
const MOST_STEPS = 3e8;

/** At most so often, in ms. */
const PAUSE = 80;

/**
 * The map of the error of the chosen method, on the axes of the map.
 * @template Errors
 * @param {object} options
 * @param {(wish: ErrorMapWish, signal: AbortSignal) => Promise<Errors>} options.load
 * @param {(errors: Errors, wish: ErrorMapWish) => void} options.onErrors
 * @param {() => void} options.onNothing there is none for this method on these axes
 * @param {(error: unknown) => void} options.onError
 */
export function createErrorMapLoader({ load, onErrors, onNothing, onError }) {
  /** @type {ErrorMapWish | null} */
  let asked = null;
  const latest = createLatest({ load, onAnswer: onErrors, onError, pause: PAUSE });

  return {
    /**
     * @param {import("./url.js").PageState} state
     * @param {boolean} dragging
     */
    follow(state, dragging) {
      const { collision } = state;
      const accuracy = failingOf(state.accuracy);
      const view = dragging && asked ? heldView(asked.view, collision) : mapView(collision, state);
      const muOverAlpha = axesMuOverAlpha(view, collision);
      if (!coversAll(accuracy.method, view, muOverAlpha)) {
        asked = null;
        onNothing();
        return;
      }
      const wish = {
        muOverAlpha,
        view,
        counts: countsFor(accuracy, dragging),
        accuracy: accuracyQuery(accuracy),
      };
      if (!asked || !isEnough(asked, wish)) {
        asked = wish;
        latest.request(wish);
      }
    },

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      asked = null;
    },
  };
}

/**
 * Whether what was asked does for a wish: the same, in as many cells.
 * @param {ErrorMapWish} asked
 * @param {ErrorMapWish} wish
 */
function isEnough(asked, wish) {
  return (
    asked.muOverAlpha === wish.muOverAlpha &&
    sameView(asked.view, wish.view) &&
    JSON.stringify(asked.accuracy) === JSON.stringify(wish.accuracy) &&
    asked.counts.kappa >= wish.counts.kappa
  );
}

/**
 * @param {import("./accuracy.js").Accuracy} accuracy
 * @param {boolean} dragging
 * @returns {Counts}
 */
function countsFor({ method, steps }, dragging) {
  if (method === "ode") {
    return FEW;
  }
  const counts = dragging ? QUICK : FULL;
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
 * @param {MapView} view
 * @param {number} muOverAlpha
 */
function coversAll(method, { kappa, gtOverGn, damping }, muOverAlpha) {
  return [kappa.min, kappa.max].every((k) =>
    [gtOverGn.min, gtOverGn.max].every((gt) =>
      canAnswer(method, { kappa: k, mu_over_alpha: muOverAlpha, gt_over_gn: gt, damping }),
    ),
  );
}
