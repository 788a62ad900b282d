// @ts-check

/**
 * A range and how values are spread over it; shares run from 0 to 1 and beyond.
 * @typedef {object} Scale
 * @property {number} min
 * @property {number} max
 * @property {(value: number) => number} toShare
 * @property {(share: number) => number} fromShare
 */

/**
 * @param {number} min greater than 0
 * @param {number} max
 * @returns {Scale}
 */
export function logScale(min, max) {
  const span = Math.log(max / min);
  return {
    min,
    max,
    toShare: (value) => Math.log(value / min) / span,
    fromShare: (share) => min * Math.exp(share * span),
  };
}

/**
 * The same places under other numbers.
 * @param {Scale} scale
 * @param {number} factor greater than 0
 * @returns {Scale}
 */
export function relabelled(scale, factor) {
  return {
    min: factor * scale.min,
    max: factor * scale.max,
    toShare: (value) => scale.toShare(value / factor),
    fromShare: (share) => factor * scale.fromShare(share),
  };
}

/**
 * Shares grow as the given power of the distance from the lower end; 1 is linear.
 * @param {number} min
 * @param {number} max
 * @param {number} power
 * @returns {Scale}
 */
export function powerScale(min, max, power) {
  return {
    min,
    max,
    toShare(value) {
      const distance = (value - min) / (max - min);
      return Math.sign(distance) * Math.abs(distance) ** power;
    },
    fromShare: (share) => min + (max - min) * Math.max(0, share) ** (1 / power),
  };
}

/**
 * @param {number} min
 * @param {number} max
 */
export function linearScale(min, max) {
  return powerScale(min, max, 1);
}

/**
 * The next of 1, 2, 5, 10 … that is not below a value, for the end of an axis.
 * @param {number} value
 */
export function stepAbove(value) {
  const decade = 10 ** Math.floor(Math.log10(value));
  const step = [1, 2, 5, 10].find((factor) => factor * decade >= value) ?? 10;
  return Number((step * decade).toPrecision(1));
}

/** A share within its axis. @param {number} share */
export function clamp(share) {
  return Math.min(1, Math.max(0, share));
}

/**
 * A place within a picture, as shares from the left and from the bottom, and for each axis whether what
 * is there lies beyond an end of it: −1 before the first, 1 after the last.
 * @typedef {{x: number, y: number, beyond: {x: number, y: number}}} Place
 */

/**
 * Where a pair of shares is shown.
 * @param {number} x
 * @param {number} y
 * @returns {Place}
 */
export function placeWithin(x, y) {
  return { x: clamp(x), y: clamp(y), beyond: { x: sideBeyond(x), y: sideBeyond(y) } };
}

/** @param {Place} place */
export function isBeyond({ beyond }) {
  return beyond.x !== 0 || beyond.y !== 0;
}

/**
 * Beyond which end a share is, by more than the eye sees.
 * @param {number} share
 */
function sideBeyond(share) {
  if (share > 1.01) {
    return 1;
  }
  return share < -0.01 ? -1 : 0;
}
