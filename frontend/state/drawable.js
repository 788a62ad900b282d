// @ts-check

import { say } from "../format/words.js";

/** `/trace` refuses more: nobody could see them. */
export const MOST_SWITCHES_DRAWN = 20_000;

/** Up to here no collision switches so often: there are at most √κ t_c/π, with t_c = 3.218. */
const ALWAYS_DRAWN = (Math.PI * MOST_SWITCHES_DRAWN) ** 2 / 3.3 ** 2;

/**
 * Whether a collision might switch too often for a trace, so that the number of its switches is to be
 * asked for first: a request that is refused leaves its mark in the browser's console.
 * @param {import("./parameters.js").Collision} collision
 */
export function mayBeTooStiffToDraw({ kappa }) {
  return kappa > ALWAYS_DRAWN;
}

/**
 * @param {{switches: number | null}} result of a collision that is not drawn
 */
export function whyNotDrawn({ switches }) {
  return switches === null ? say("trace.tooStiff") : say("trace.tooOften", { count: switches });
}
