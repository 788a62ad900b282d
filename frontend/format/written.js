// @ts-check

import { powerOfTen, significant } from "./number.js";
import { kindOf, takenBy, unitOf } from "./units.js";
import { decimalMark, say, shortened } from "./words.js";

const NARROW_SPACE = "\u202f";

/**
 * What a text says: a value, two that it may mean, or why it says none; without words where it is simply
 * no number.
 * @typedef {{value: number} | {readings: {text: string, value: number}[]} | {refusal: string}} Reading
 */

/** Different signs for one thing, in the order in which they are replaced. @type {[RegExp, string][]} */
const SIGNS = [
  // marks of direction and of where a line may break
  [/[\u00ad\u200b-\u200f\u202a-\u202e\u2060-\u2069\ufeff]/g, ""],
  [/[\s\u00a0\u1680\u2000-\u200a\u202f\u205f\u3000~]+|\\[,;: ]/g, " "],
  [/\\(?:times|cdot)(?![a-z])/g, "*"],
  [/[{}$]|\\mathrm/g, ""],
  [/\*\*/g, "^"],
  [/[×·\u2022\u2217\u2219\u22c5\u2715]/g, "*"],
  [/[\u2010-\u2015\u2212\ufe58\ufe63]/g, "-"],
  [/[\u2044\u2215]/g, "/"],
  [/[’\u2018\u02bc\u2032]/g, "'"],
  [/µ/g, "μ"],
];

const RAISED = "⁰¹²³⁴⁵⁶⁷⁸⁹";

/**
 * A text in plain signs: 1.888 * 10^-4 N/m^2.
 * @param {string} text
 */
function inPlainSigns(text) {
  let plain = text
    .replace(/[\uff01-\uff5e]/g, (sign) => String.fromCharCode(sign.charCodeAt(0) - 0xfee0))
    .replace(/[⁺⁻⁰¹²³⁴-⁹]+/g, (signs) => `^${[...signs].map(lowered).join("")}`);
  for (const [sign, usual] of SIGNS) {
    plain = plain.replace(sign, usual);
  }
  return plain.trim();
}

/** @param {string} sign */
function lowered(sign) {
  return { "⁺": "+", "⁻": "-" }[sign] ?? String(RAISED.indexOf(sign));
}

/** A sign, digits with whatever stands between them, the rest. */
const NUMBER = /^([+-]?) ?(\d[\d.,'_ ]*|[.,]\d+)(.*)$/;

/** What may follow the digits, each with what it makes of them. @type {[RegExp, (found: string) => Factor[]][]} */
const FACTORS = [
  // d is Fortran's
  [/^[ed]([+-]?\d+)/i, (power) => [{ power: Number(power) }]],
  [/^[*x] ?10 ?\^ ?([+-]?\d+)/i, (power) => [{ power: Number(power) }]],
  // A power that has lost its raising: × 10⁻⁴ cannot be anything else, × 10¹² might be 1012.
  [/^[*x] ?10 ?(-\d+)/i, (power) => [{ power: Number(power) }]],
  [/^[*x] ?10(\d+)/i, (power) => [{ power: Number(power) }, { times: Number(`10${power}`) }]],
];

/** @typedef {{power?: number, times?: number}} Factor */

/**
 * What says of a value how large it may be or how far it may be off, and is none itself; by its signs, with
 * a digit beside them.
 * @type {[RegExp, string][]}
 */
const NO_VALUES = [
  [/^[<>≤≥\u2a7d\u2a7e] ?=? ?[-+.\d]/, "bound"],
  [/^(?:±|\+\/?-) ?[.\d]/, "margin"],
  [/\d ?(?:±|\+\/-) ?[.\d]|\d\(\d+\)/, "uncertain"],
];

/**
 * What a text says that is typed or pasted into a field of a quantity: as the page prints it, as papers,
 * programs and spreadsheets do.
 * @param {string} text
 * @param {object} field
 * @param {string} field.subject of a sentence that says what the field takes
 * @param {string} [field.unit] of its values; pure numbers have none
 * @param {string} [field.decimal] its decimal mark, that of the page
 * @returns {Reading}
 */
export function readWritten(text, { subject, unit = "", decimal = decimalMark() }) {
  const plain = inPlainSigns(text);
  const [, kind] = NO_VALUES.find(([signs]) => signs.test(plain)) ?? [];
  if (kind) {
    return { refusal: say(`fields.${kind}`, { text: shortened(text.trim()), subject }) };
  }
  const number = numberIn(plain, decimal);
  if (!number || /^[-+\d.,^*/]/.test(number.rest)) {
    return { refusal: "" };
  }
  const own = /** @type {import("./units.js").Unit} */ (unitOf(inPlainSigns(unit)));
  const given = number.rest === "" ? own : unitOf(number.rest);
  const name = number.rest
    .replaceAll("μ", "µ")
    .replace(/\^(-?\d+)/g, (_, power) => powerOfTen(Number(power)).slice("10".length));
  if (given?.dimension !== own.dimension) {
    const taken = takenBy(own);
    return {
      refusal: given
        ? say("fields.otherUnit", { unit: name, kind: kindOf(given), subject, taken })
        : say("fields.noUnit", { unit: name, subject, taken }),
    };
  }
  const ratio = (given.times * own.per) / (given.per * own.times);
  const readings = number.meanings.map(({ digits, power = 0, times = 1, by = 1 }) => ({
    text: [
      digits.replace(".", decimal),
      ...(times === 1 ? [] : ["×", times]),
      ...(power === 0 ? [] : ["×", powerOfTen(power)]),
      ...(name ? [name] : []),
    ].join(NARROW_SPACE),
    value: shifted(digits, times * ratio, by, power + given.power - own.power),
  }));
  if (!readings.every(({ value }) => Number.isFinite(value))) {
    const most = significant(Number.MAX_VALUE, 2);
    return { refusal: say("fields.beyond", { text: shortened(text.trim()), most }) };
  }
  return readings.length === 1 ? { value: readings[0].value } : { readings };
}

/**
 * Digits times a factor over a divisor, and a power of ten, which is not multiplied with: 20 mm are 0.02 m to
 * the last bit.
 * @param {string} digits
 * @param {number} factor
 * @param {number} divisor
 * @param {number} power
 */
function shifted(digits, factor, divisor, power) {
  if (factor === 1 && divisor === 1) {
    return Number(`${digits}e${power}`);
  }
  const [mantissa, exponent] = ((Number(digits) * factor) / divisor).toExponential().split("e");
  return Number(`${mantissa}e${Number(exponent) + power}`);
}

/**
 * The number that a text in plain signs begins with, in each of its meanings, and what follows it.
 * @param {string} plain
 * @param {string} decimal
 * @returns {{meanings: ({digits: string, by?: number} & Factor)[], rest: string} | null}
 */
function numberIn(plain, decimal) {
  const alone = /^([+-]?) ?10 ?\^ ?([+-]?\d+)(.*)$/.exec(plain);
  if (alone) {
    const [, sign, power, rest] = alone;
    return { meanings: [{ digits: `${sign}1`, power: Number(power) }], rest: rest.trim() };
  }
  const [, sign = "", written = "", after = ""] = NUMBER.exec(plain) ?? [];
  const numerals = numeralsOf(written.trim(), decimal);
  const rest = after.trim();
  const [, divisor, unit] = /^\/ ?(\d[\d.,]*)(.*)$/.exec(rest) ?? [];
  if (divisor !== undefined) {
    const divisors = numeralsOf(divisor, decimal);
    // Two questions at once are none that a button answers.
    return numerals.length === 1 && divisors.length === 1 && Number(divisors[0]) > 0
      ? { meanings: [{ digits: sign + numerals[0], by: Number(divisors[0]) }], rest: unit.trim() }
      : null;
  }
  /** @type {Factor[]} */
  let factors = [{}];
  let left = rest;
  for (const [sought, factorsOf] of FACTORS) {
    const found = sought.exec(rest);
    if (found) {
      factors = factorsOf(found[1]);
      left = rest.slice(found[0].length).trim();
      break;
    }
  }
  const meanings = numerals.flatMap((numeral) =>
    factors.map((factor) => ({ digits: sign + numeral, ...factor })),
  );
  return meanings.length > 0 ? { meanings, rest: left } : null;
}

/** Groups of three, counted from the decimal mark, by a sign that is never one itself. */
const SPACED =
  /^(?:\d+|\d{1,3}(?:([ '_])\d{3})(?:\1\d{3})*)(?:[.,](?:\d*|\d{3}(?:[ '_]\d{3})*(?:[ '_]\d{1,3})?))?$/;

/** Groups by a sign that might be the decimal mark: of three, or of two as in India. */
const GROUPED = /^\d{1,3}(?:([.,])\d{3})(?:\1\d{3})*$|^\d{1,2}(?:,\d{2})+,\d{3}$/;

/** One such group, which no decimal mark of its language begins; after a zero it is none. */
const MAYBE_GROUPED = /^[1-9]\d{0,2}[.,]\d{3}$/;

/**
 * The numerals that digits with marks between them may be, with a point as their decimal mark: none, one,
 * or two.
 * @param {string} written
 * @param {string} decimal
 * @returns {string[]}
 */
function numeralsOf(written, decimal) {
  if (/[ '_]/.test(written)) {
    return SPACED.test(written) ? [written.replace(/[ '_]/g, "").replace(",", ".")] : [];
  }
  const marks = written.match(/[.,]/g) ?? [];
  if (marks.length > 1) {
    const last = written.search(/[.,]\d*$/);
    const isMixed = marks.at(-1) !== marks[0];
    const whole = isMixed ? written.slice(0, last) : written;
    const isWhole = GROUPED.test(whole) && (!isMixed || !whole.includes(written[last]));
    const fraction = isMixed ? `.${written.slice(last + 1)}` : "";
    return isWhole ? [whole.replace(/[.,]/g, "") + fraction] : [];
  }
  const plain = written.replace(",", ".");
  return MAYBE_GROUPED.test(written) && marks[0] !== decimal
    ? [plain.replace(".", ""), plain]
    : plain === "" || plain === "."
      ? []
      : [plain];
}
