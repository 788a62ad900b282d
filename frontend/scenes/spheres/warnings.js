// @ts-check

import { brief, significant } from "../../format/number.js";
import { isSaid, say } from "../../format/words.js";

/** @typedef {import("../../api/answers.js").Scaling["warnings"][number]} Warning */

/** So many digits have numbers that are estimates; the others have three. */
const ESTIMATES = 2;
const DIGITS = 3;

/**
 * Where the model is left, in the words of the page; what it does not know, as the server has it, which is
 * in English.
 * @param {Warning} warning
 */
export function warningInWords({ code, text, values }) {
  const isSlow = code === "oblique" && "tangential_velocity_m_s" in values;
  const key = `warnings.${isSlow ? "oblique_slow" : code}`;
  if (!isSaid(key)) {
    return { text, language: "en" };
  }
  const digits = code === "oblique" ? ESTIMATES : DIGITS;
  const { share, ...others } = values;
  const inWords = share === undefined ? values : { ...others, percent: share && 100 * share };
  const said = Object.entries(inWords).map(([name, value]) => [name, inDigits(value, digits)]);
  return { text: say(key, Object.fromEntries(said)), language: "" };
}

/** @param {number | null} value null where it is beyond the largest number @param {number} digits */
function inDigits(value, digits) {
  return value === null
    ? `> ${significant(Number.MAX_VALUE, 2)}`
    : brief(Number(value.toPrecision(digits)));
}
