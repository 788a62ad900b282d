// @ts-check

import { between, notNegative, positive } from "./requirements.js";
import { powerScale, logScale } from "./scales.js";

/**
 * A parameter of the collision, named as the API names it.
 * @typedef {object} Parameter
 * @property {"kappa" | "mu_over_alpha" | "gt_over_gn" | "damping"} key
 * @property {string} [unit] of its values; a field takes any of the same dimension
 * @property {number} initial
 * @property {(value: number) => boolean} admits
 * @property {() => string} requirement what `admits` wants, in words
 * @property {import("./scales.js").Scale} scale of the slider; a value beyond its ends is still allowed
 * @property {number[]} ticks
 */

/**
 * The share of g_t that is spin, the rest of which is travel: g_t alone does not tell.
 * @type {Omit<Parameter, "key" | "ticks"> & {key: "spin_share"}}
 */
export const SPIN_SHARE = {
  key: "spin_share",
  initial: 0,
  admits: (value) => value >= 0 && value <= 1,
  requirement: between(0, 1),
  scale: powerScale(0, 1, 1),
};

/**
 * What the ball bounces off and how often it is followed; the partner is named as the API names it.
 * @type {{id: "wall" | "wall_twice" | "sphere", partner: "wall" | "sphere", times: 1 | 2}[]}
 */
export const BOUNCES = [
  { id: "wall", partner: "wall", times: 1 },
  { id: "wall_twice", partner: "wall", times: 2 },
  { id: "sphere", partner: "sphere", times: 1 },
];

/** That of an address; the usual one where there is none. @param {string} [id] */
export const bounceOf = (id) => BOUNCES.find((bounce) => bounce.id === id) ?? BOUNCES[0];

/** @typedef {{kappa: number, mu_over_alpha: number, gt_over_gn: number, damping: number}} Collision */

/** α of homogeneous spheres, Eq. 12. */
export const SOLID_ALPHA = 2 / 7;

/** Number of steps of a slider, one for each press of an arrow key. */
export const SLIDER_STEPS = 1000;

/** @type {Parameter[]} */
export const PARAMETERS = [
  {
    key: "kappa",
    initial: 63,
    admits: (value) => value > 0,
    requirement: positive,
    scale: logScale(0.1, 1000),
    ticks: [0.1, 1, 10, 100, 1000],
  },
  {
    key: "mu_over_alpha",
    initial: 1.4,
    admits: (value) => value >= 0,
    requirement: notNegative,
    scale: powerScale(0, 4, 1),
    ticks: [0, 1, 2, 3, 4],
  },
  {
    // Half of the paper's letters a … o lie below 0.5: the square root gives them half of the slider.
    key: "gt_over_gn",
    initial: 1.358,
    admits: (value) => value >= 0,
    requirement: notNegative,
    scale: powerScale(0, 4, 0.5),
    ticks: [0, 0.1, 0.5, 1, 2, 4],
  },
  {
    key: "damping",
    initial: 0,
    admits: (value) => value >= 0 && value <= 1e30,
    requirement: between(0, 1e30),
    scale: powerScale(0, 1.5, 0.5),
    ticks: [0, 0.1, 0.5, 1, 1.5],
  },
];

/**
 * @param {Collision} a
 * @param {Collision} b
 */
export function sameCollision(a, b) {
  return PARAMETERS.every(({ key }) => a[key] === b[key]);
}

/** @type {Collision} */
export const INITIAL_COLLISION = {
  kappa: PARAMETERS[0].initial,
  mu_over_alpha: PARAMETERS[1].initial,
  gt_over_gn: PARAMETERS[2].initial,
  damping: PARAMETERS[3].initial,
};

/**
 * The collision of an impact of bodies, and their α, to the digits that the page shows: those
 * beyond are rounding, and 2/7 stays 2/7.
 * @param {Collision & {alpha: number}} answer
 */
export function collisionOfImpact({ alpha, ...answer }) {
  const collision = Object.fromEntries(PARAMETERS.map(({ key }) => [key, rounded(answer[key])]));
  return {
    collision: /** @type {Collision} */ (collision),
    alpha: rounded(alpha) === rounded(SOLID_ALPHA) ? SOLID_ALPHA : rounded(alpha),
  };
}

/** @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(12));
}

/**
 * The finite number that a text of an address is, with a decimal point, or null.
 * @param {string} text
 */
export function parseNumber(text) {
  const isPlain = /^\s*[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?\s*$/i.test(text);
  const value = isPlain ? Number(text) : NaN;
  return Number.isFinite(value) ? value : null;
}

/**
 * The same of what is typed, where it is plainly a number: a comma or a point that might part thousands is
 * for `format/written.js` to look at, as is all else.
 * @param {string} text
 * @param {string} decimal mark of the language around the field
 */
export function parseTyped(text, decimal) {
  const plain = text.trim().replace("\u2212", "-");
  const mark = /[.,]/.exec(plain)?.[0] ?? decimal;
  const isPlain = mark === decimal || !/^[+-]?[1-9]\d{0,2}[.,]\d{3}(\D|$)/.test(plain);
  return isPlain ? parseNumber(plain.replace(",", ".")) : null;
}

/**
 * The slider's step nearest to a value.
 * @param {Pick<Parameter, "scale">} parameter
 * @param {number} value
 */
export function sliderStep(parameter, value) {
  const share = parameter.scale.toShare(value);
  return Math.round(SLIDER_STEPS * Math.min(1, Math.max(0, share)));
}

/**
 * The value at a slider's step, to four digits, so that it reads as it was meant.
 * @param {Pick<Parameter, "scale">} parameter
 * @param {number} step
 */
export function valueAtStep(parameter, step) {
  return Number(parameter.scale.fromShare(step / SLIDER_STEPS).toPrecision(4));
}
