// @ts-check

import { typable } from "../../../format/number.js";
import { PIN_LETTERS } from "../../../state/pins.js";

/**
 * A collision that is pinned, and what the server said of it, once it did.
 * @typedef {object} Pinned
 * @property {number} index of its letter
 * @property {import("../../../state/parameters.js").Collision} collision
 * @property {import("../../../state/loading/collision-load.js").LoadedCollision | null} loaded
 */

/** None of them is a pattern that the pictures have already; in CSS pixels, long ones and gaps by turns. */
export const DASHES = ["13px,4px", "9px,3px,2px,3px", "9px,3px,2px,3px,2px,3px"];

/** @param {Pick<Pinned, "index">} pinned */
export const letterAt = ({ index }) => PIN_LETTERS[index];

/** A collision in a line. @param {import("../../../state/parameters.js").Collision} collision */
export function inALine({ kappa, mu_over_alpha, gt_over_gn, damping }) {
  const damped = damping > 0 ? `, η = ${typable(damping)}` : "";
  return `κ = ${typable(kappa)}, μ/α = ${typable(mu_over_alpha)}, g_t/g_n = ${typable(gt_over_gn)}${damped}`;
}
