// @ts-check

import { IMPACT_PARAMETERS } from "./impact.js";
import { PARAMETERS, parseNumber, SPIN_SHARE } from "./parameters.js";

/**
 * How a slider goes there and back by itself.
 * @typedef {object} Sweep
 * @property {string} key of its parameter
 * @property {number} from
 * @property {number} to the end that it goes to first, above or below the other
 * @property {number} seconds there and back
 * @property {boolean} once, or until it is stopped
 */

const USUAL_SECONDS = 8;
const MOST_SECONDS = 600;

/** What has a slider, by its name in the address. */
const SWEPT = [...PARAMETERS, ...IMPACT_PARAMETERS, SPIN_SHARE];

/** @param {string} key */
export const sweptBy = (key) => SWEPT.find((parameter) => parameter.key === key);

/**
 * The usual sweep of a parameter, over the whole of its slider; null where there is none.
 * @param {string} key
 * @returns {Sweep | null}
 */
export function sweepOf(key) {
  const scale = sweptBy(key)?.scale;
  return scale
    ? { key, from: scale.min, to: scale.max, seconds: USUAL_SECONDS, once: false }
    : null;
}

/**
 * That of an address: the parameter's name, then the range, seconds and `once` as far as they are not
 * the usual ones; null where it makes no sense.
 * @param {string} text
 * @returns {Sweep | null}
 */
export function readSweep(text) {
  const [key, ...parts] = text.split(",");
  const usual = sweepOf(key);
  const numbers = parts.slice(0, 3).map(parseNumber);
  if (!usual || parts.length > 4 || numbers.includes(null) || (parts[3] ?? "once") !== "once") {
    return null;
  }
  const [from = usual.from, to = usual.to, seconds = USUAL_SECONDS] = /** @type {number[]} */ (
    numbers
  );
  const isWithin = [from, to].every((end) => end >= usual.from && end <= usual.to);
  return isWithin && from !== to && seconds >= 1 && seconds <= MOST_SECONDS
    ? { key, from, to, seconds, once: parts.length === 4 }
    : null;
}

/** The same as an address has it. @param {Sweep} sweep */
export function writeSweep(sweep) {
  const { key, from, to, seconds, once } = sweep;
  const usual = /** @type {Sweep} */ (sweepOf(key));
  const isWhole = from === usual.from && to === usual.to;
  const isUsual = seconds === usual.seconds && !once;
  const parts = [
    key,
    ...(isWhole && isUsual ? [] : [from, to]),
    ...(isUsual ? [] : [seconds]),
    ...(once ? ["once"] : []),
  ];
  // A plus would be a space in an address.
  return parts.join().replaceAll("+", "");
}
