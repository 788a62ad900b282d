// @ts-check

import { PARAMETERS, parseNumber, sameCollision } from "./parameters.js";

/**
 * The collisions that are pinned, each at the place of its letter; a letter that is free among them
 * has none, so that the others keep theirs.
 * @typedef {(import("./parameters.js").Collision | null)[]} Pins
 */

/** As many as can be told apart in one picture. */
export const PIN_LETTERS = ["A", "B", "C"];

/**
 * The pins of an address: κ,μ/α,g_t/g_n or with η, parted by semicolons.
 * @param {string} text
 * @returns {{pins: Pins, wrong: string[]}} and what of the text makes no sense
 */
export function readPins(text) {
  const parts = text.split(";");
  const found = parts.slice(0, PIN_LETTERS.length).map(readPin);
  const wrong = parts.filter((part, i) => part !== "" && !found[i]);
  return { pins: trimmed(found), wrong };
}

/** @param {string} text */
function readPin(text) {
  const values = text.split(",").map(parseNumber);
  const isPin =
    (values.length === PARAMETERS.length - 1 || values.length === PARAMETERS.length) &&
    values.every((value, i) => value !== null && PARAMETERS[i].admits(value));
  const entries = PARAMETERS.map(({ key, initial }, i) => [key, values[i] ?? initial]);
  return isPin ? /** @type {Pins[number]} */ (Object.fromEntries(entries)) : null;
}

/** The same as an address has it. @param {Pins} pins */
export function writePins(pins) {
  return pins.map(writePin).join(";");
}

/** @param {Pins[number]} pin */
export function writePin(pin) {
  if (!pin) {
    return "";
  }
  const { kappa, mu_over_alpha, gt_over_gn, damping } = pin;
  const values = [kappa, mu_over_alpha, gt_over_gn, ...(damping > 0 ? [damping] : [])];
  // A plus would be a space in an address.
  return values.map((value) => String(value).replace("+", "")).join(",");
}

/**
 * With one more, at the first free letter; null where there is none.
 * @param {Pins} pins
 * @param {import("./parameters.js").Collision} collision
 * @returns {Pins | null}
 */
export function withPin(pins, collision) {
  const all = PIN_LETTERS.map((_, i) => pins[i] ?? null);
  const free = all.indexOf(null);
  return free < 0 ? null : trimmed(replaced(all, free, { ...collision }));
}

/** @param {Pins} pins @param {number} index @returns {Pins} */
export function withoutPin(pins, index) {
  return trimmed(replaced(pins, index, null));
}

/**
 * The letter that a collision has, or none.
 * @param {Pins} pins
 * @param {import("./parameters.js").Collision} collision
 */
export function letterOf(pins, collision) {
  return PIN_LETTERS[pins.findIndex((pin) => pin && sameCollision(pin, collision))] ?? "";
}

/** @param {Pins} pins @param {number} index @param {Pins[number]} by @returns {Pins} */
function replaced(pins, index, by) {
  return pins.map((pin, i) => (i === index ? by : pin));
}

/** @param {Pins} pins */
function trimmed(pins) {
  return pins.slice(
    0,
    pins.reduce((count, pin, i) => (pin ? i + 1 : count), 0),
  );
}
