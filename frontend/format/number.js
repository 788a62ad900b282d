// @ts-check

import { decimalMark } from "./words.js";

const MINUS = "\u2212";
const NARROW_SPACE = "\u202f";
const SUPERSCRIPTS = {
  "-": "⁻",
  0: "⁰",
  1: "¹",
  2: "²",
  3: "³",
  4: "⁴",
  5: "⁵",
  6: "⁶",
  7: "⁷",
  8: "⁸",
  9: "⁹",
};

/** What stands where a number does not exist. */
export const ABSENT = "–";

/**
 * A power of ten with its exponent raised: `10⁻¹⁴`.
 * @param {number} exponent
 */
export function powerOfTen(exponent) {
  const raised = [...String(exponent)].map((c) => SUPERSCRIPTS[/** @type {"0"} */ (c)]);
  return `10${raised.join("")}`;
}

/** Digits as the page writes them: with a real minus sign and the decimal mark of its language. @param {string} text */
function inPrint(text) {
  return text.replace("-", MINUS).replace(".", decimalMark());
}

/**
 * A number to so many significant digits, with a real minus sign and, far from one, a power of ten.
 * @param {number | null | undefined} value
 */
export function significant(value, digits = 4) {
  if (value === null || value === undefined || Number.isNaN(value)) {
    return ABSENT;
  }
  if (!Number.isFinite(value)) {
    return value > 0 ? "∞" : `${MINUS}∞`;
  }
  if (value === 0) {
    return "0";
  }
  const [mantissa, exponent] = value.toExponential(digits - 1).split("e");
  const power = Number(exponent);
  if (power < -3 || power > 5) {
    return `${inPrint(mantissa)}${NARROW_SPACE}×${NARROW_SPACE}${powerOfTen(power)}`;
  }
  return inPrint(value.toFixed(Math.max(0, digits - 1 - power)));
}

/**
 * A number to two decimals, as much as a map tells of it.
 * @param {number} value
 */
export function approximate(value) {
  const text = value.toFixed(2);
  return inPrint(Number(text) === 0 ? text.replace("-", "") : text);
}

/**
 * The short form of a tick or a letter: no trailing zeros.
 * @param {number} value
 */
export function brief(value) {
  const magnitude = Math.abs(value);
  if (value !== 0 && (magnitude < 1e-3 || magnitude >= 1e5)) {
    const [mantissa, exponent] = value.toExponential(2).split("e");
    const factor = Number(mantissa);
    const power = powerOfTen(Number(exponent));
    return factor === 1
      ? power
      : `${inPrint(String(factor))}${NARROW_SPACE}×${NARROW_SPACE}${power}`;
  }
  return inPrint(String(Number(value.toPrecision(3))));
}

/**
 * A share as a percentage; only what is exactly nothing or everything is shown as such.
 * @param {number} share 0 … 1
 */
export function percentage(share) {
  if (!Number.isFinite(share)) {
    return ABSENT;
  }
  const percent = 100 * share;
  let digits = percent.toFixed(1);
  if (share > 0 && percent < 0.05) {
    digits = "< 0.1";
  } else if (share < 1 && percent >= 99.95) {
    digits = "> 99.9";
  } else if (share === 0 || share === 1) {
    digits = String(percent);
  }
  return `${inPrint(digits)}${NARROW_SPACE}%`;
}

/**
 * An upper bound of an error: one digit, rounded up so that it stays a bound.
 * @param {number | null | undefined} bound
 */
export function errorBound(bound) {
  if (bound === null || bound === undefined || Number.isNaN(bound)) {
    return ABSENT;
  }
  if (bound === 0) {
    return "±0";
  }
  let power = Math.floor(Math.log10(bound));
  let digit = Math.ceil(bound / 10 ** power - 1e-9);
  if (digit >= 10) {
    digit = 1;
    power += 1;
  }
  if (power >= -3) {
    return `±${inPrint(String(Number((digit * 10 ** power).toPrecision(1))))}`;
  }
  return `±${digit === 1 ? "" : `${digit}${NARROW_SPACE}×${NARROW_SPACE}`}${powerOfTen(power)}`;
}

/**
 * A duration in the unit that suits it.
 * @param {number | null | undefined} milliseconds
 */
export function duration(milliseconds) {
  if (milliseconds === null || milliseconds === undefined || !Number.isFinite(milliseconds)) {
    return ABSENT;
  }
  if (milliseconds < 0.1) {
    return inUnit(1000 * milliseconds, "µs");
  }
  return milliseconds < 1000 ? inUnit(milliseconds, "ms") : inUnit(milliseconds / 1000, "s");
}

/**
 * @param {number} value
 * @param {string} unit
 */
function inUnit(value, unit) {
  return `${inPrint(String(Number(value.toPrecision(2))))}${NARROW_SPACE}${unit}`;
}

/**
 * α as it is spoken of: that of homogeneous spheres is 2/7.
 * @param {number} alpha
 */
export function alphaInWords(alpha) {
  return alpha === 2 / 7 ? "2/7" : brief(alpha);
}

/** So many characters fit into a number field. */
const LONGEST_PLAIN = 9;

/**
 * What a number field shows: plain digits that can be typed again, with the decimal mark of the page.
 * @param {number} value
 */
export function typable(value) {
  const short = String(Number(value.toPrecision(6)));
  const full = Number(short) === value ? short : String(value);
  const scientific = value.toExponential().replace("+", "");
  const digits = full.length > LONGEST_PLAIN && scientific.length < full.length ? scientific : full;
  return digits.replace(".", decimalMark());
}

/** @type {[number, string][]} */
const PREFIXES = [
  [1e6, "M"],
  [1e3, "k"],
  [1, ""],
  [1e-3, "m"],
  [1e-6, "µ"],
  [1e-9, "n"],
];

/**
 * A quantity in the multiple of its unit that reads best.
 * @param {number} value
 * @param {string} unit
 * @param {number} [digits]
 */
export function inUnits(value, unit, digits = 4) {
  const found = PREFIXES.find(([factor]) => Math.abs(value) >= factor);
  const isFar = Math.abs(value) >= 1e9;
  const [factor, prefix] = found && !isFar ? found : [1, ""];
  return `${significant(value / factor, digits)} ${prefix}${unit}`;
}
