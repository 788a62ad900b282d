// @ts-check

import { logScale, powerScale } from "./scales.js";

/**
 * What is to be asked of `/map` and how its axes lie.
 * @typedef {object} MapView
 * @property {"linear" | "log"} scale
 * @property {import("./scales.js").Scale} kappa
 * @property {import("./scales.js").Scale} gtOverGn
 */

/**
 * The usual axes, where the paper draws Figs. 3 and 4, and how far they may reach for a collision
 * beyond them: on a linear axis of thousands there is nothing to see.
 */
const AXES = {
  linear: { kappa: [0.1, 70], gtOverGn: [0.01, 4], reach: 10 },
  log: { kappa: [0.1, 1000], gtOverGn: [0.005, 5], reach: 1e9 },
};

/**
 * The axes of the map around a collision: the usual ones, or the next of 1, 2, 5, 10 … that reach it.
 * @param {import("./parameters.js").Collision} collision
 * @param {"linear" | "log"} scale
 * @returns {MapView}
 */
export function mapView(collision, scale) {
  const make = scale === "log" ? logScale : linearScale;
  const { kappa, gtOverGn, reach } = AXES[scale];
  const both = scale === "log";
  return {
    scale,
    kappa: make(...reaching(kappa, collision.kappa, reach, both)),
    gtOverGn: make(...reaching(gtOverGn, collision.gt_over_gn, reach, both)),
  };
}

/**
 * Whether two views ask for the same axes.
 * @param {MapView} a
 * @param {MapView} b
 */
export function sameView(a, b) {
  return (
    a.scale === b.scale &&
    a.kappa.min === b.kappa.min &&
    a.kappa.max === b.kappa.max &&
    a.gtOverGn.min === b.gtOverGn.min &&
    a.gtOverGn.max === b.gtOverGn.max
  );
}

/**
 * Where a collision stands on the map, as shares from the left and from the bottom.
 * @param {MapView} view
 * @param {import("./parameters.js").Collision} collision
 */
export function placeOnMap(view, collision) {
  const x = view.kappa.toShare(collision.kappa);
  const y = view.gtOverGn.toShare(collision.gt_over_gn);
  return { x: clamp(x), y: clamp(y), outside: isBeyond(x) || isBeyond(y) };
}

/**
 * The parameters at a place of the map, to four digits.
 * @param {MapView} view
 * @param {number} x share from the left
 * @param {number} y share from the bottom
 */
export function collisionAt(view, x, y) {
  return {
    kappa: Number(view.kappa.fromShare(clamp(x)).toPrecision(4)),
    gt_over_gn: Number(view.gtOverGn.fromShare(clamp(y)).toPrecision(4)),
  };
}

/**
 * @param {number} min
 * @param {number} max
 */
function linearScale(min, max) {
  return powerScale(min, max, 1);
}

/**
 * @param {number[]} usual
 * @param {number} value
 * @param {number} reach the factor by which an end may move out
 * @param {boolean} both whether the lower end moves too
 * @returns {[number, number]}
 */
function reaching([min, max], value, reach, both) {
  const high = value > max && value <= max * reach ? stepAbove(value) : max;
  const low = both && value < min && value >= min / reach ? 1 / stepAbove(1 / value) : min;
  return [low, high];
}

/** @param {number} value */
function stepAbove(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].find((factor) => factor * decade >= value) ?? 10;
  return Number((step * decade).toPrecision(1));
}

/**
 * Whether a place is beyond the frame by more than the eye sees.
 * @param {number} share
 */
function isBeyond(share) {
  return share < -0.01 || share > 1.01;
}

/** @param {number} share */
function clamp(share) {
  return Math.min(1, Math.max(0, share));
}
