// @ts-check

import { decimalMark, say, shortened } from "../format/words.js";

/** A number as a requirement names it. @param {number} value */
export function number(value) {
  return String(value).replace("+", "").replace(".", decimalMark());
}

/** A range of numbers. @param {number} least @param {number} most */
export const between = (least, most) => () =>
  say("requirements.between", { least: number(least), most: number(most) });

/** Any number above 0. */
export const positive = () => say("requirements.positive");

/** Any number but those below 0. */
export const notNegative = () => say("requirements.notNegative");

/**
 * What is wrong with a text, in words.
 * @param {string} name
 * @param {string} requirement
 * @param {string} text
 */
export function misfit(name, requirement, text) {
  return text
    ? say("misfits.found", { name, requirement, text: shortened(text) })
    : say("misfits.unmet", { name, requirement });
}

/**
 * The same of a number in an address, where no comma is a decimal mark.
 * @param {string} name
 * @param {string} requirement
 * @param {string} text
 */
export function misread(name, requirement, text) {
  return text.includes(",")
    ? say("misfits.comma", { name, requirement, text: shortened(text) })
    : misfit(name, requirement, text);
}
