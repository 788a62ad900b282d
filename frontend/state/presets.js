// @ts-check

import { sameCollision } from "./parameters.js";

/** @typedef {import("../api/answers.js").Preset} Preset */

/** Which panel of Fig. 5 a preset is, or null. @param {Preset} preset */
export function letterOf({ title }) {
  return /^Fig\.\s*5\s*([a-o])$/.exec(title)?.[1] ?? null;
}

/**
 * Whether a preset is of a collision.
 * @param {Preset} preset
 * @param {import("./parameters.js").Collision} collision
 */
export function isOf({ kappa, mu_over_alpha, gt_over_gn, damping }, collision) {
  return sameCollision({ kappa, mu_over_alpha, gt_over_gn, damping }, collision);
}
