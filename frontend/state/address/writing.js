// @ts-check

import { USUAL_ACCURACY } from "../accuracy.js";
import { IMPACT_PARAMETERS } from "../impact.js";
import { settingOf } from "../lesson.js";
import { PARAMETERS, SOLID_ALPHA, SPIN_SHARE } from "../parameters.js";
import { writePins } from "../pins.js";
import { writeSweep } from "../sweep.js";
import { PAGE_WORDS, LISTS, WORD_KEYS, USUAL_MATERIAL } from "./options.js";
import { readAddress } from "./reading.js";

/** @typedef {import("./options.js").PageState} PageState */

/**
 * The address of a state, from its question mark on.
 * @param {PageState} state
 */
export function writeAddress(state) {
  const { collision, alpha, spin_share, accuracy, impact, pins, sweep, ...words } = state;
  const query = new URLSearchParams();
  for (const { key } of PARAMETERS) {
    // What is not damped says nothing of damping.
    if (key !== "damping" || collision.damping > 0) {
      query.set(key, String(collision[key]));
    }
  }
  for (const key of WORD_KEYS) {
    query.set(key, words[key]);
  }
  if (alpha !== SOLID_ALPHA) {
    query.set("alpha", String(alpha));
  }
  if (spin_share !== SPIN_SHARE.initial) {
    query.set(SPIN_SHARE.key, String(spin_share));
  }
  const step = settingOf(words.scene, words.step).accuracy ?? USUAL_ACCURACY;
  for (const [name, usual] of Object.entries(USUAL_ACCURACY)) {
    const key = /** @type {keyof typeof accuracy} */ (name);
    if (accuracy[key] !== usual || accuracy[key] !== step[key]) {
      query.set(key, String(accuracy[key]));
    }
  }
  for (const [key, value] of Object.entries(impact)) {
    if (value !== null && value !== USUAL_MATERIAL) {
      query.set(key, String(value));
    }
  }
  for (const [key, [usual]] of Object.entries(PAGE_WORDS)) {
    const word = words[/** @type {keyof typeof words} */ (key)];
    if (word !== usual) {
      query.set(key, word);
    }
  }
  // Their commas and semicolons read better as they are.
  const lists = Object.entries(LISTS).map(([key, usual]) => {
    const list = words[/** @type {keyof typeof LISTS} */ (key)];
    return list === usual ? "" : `&${key}=${list}`;
  });
  const pinned = pins.length > 0 ? `&pins=${writePins(pins)}` : "";
  const swept = sweep ? `&sweep=${writeSweep(sweep)}` : "";
  return `?${query}${lists.join("")}${pinned}${swept}`;
}

/**
 * The state at an address of the server that leaves some options open: they stay as they are. A
 * collision is given whole, and a material without what was set by hand.
 * @param {PageState} present
 * @param {string} link from its question mark on
 * @returns {PageState}
 */
export function stateAt(present, link) {
  const options = new URLSearchParams(link);
  const query = new URLSearchParams(writeAddress(present));
  if (options.has("kappa")) {
    query.delete("damping");
  }
  if (options.has("material")) {
    IMPACT_PARAMETERS.forEach(({ key }) => query.delete(key));
  }
  options.forEach((value, key) => query.set(key, value));
  return readAddress(`?${query}`).state;
}

/**
 * Whether a state is what an address asks for. Real spheres have their collision from the velocities.
 * @param {PageState} state
 * @param {string} link
 */
export function isAt(state, link) {
  const target = readAddress(link).state;
  return [...new URLSearchParams(link).keys()].every((key) => {
    if (key in target.collision) {
      const name = /** @type {keyof PageState["collision"]} */ (key);
      return target.scene === "spheres" || target.collision[name] === state.collision[name];
    }
    const [wanted, found] = key in target.impact ? [target.impact, state.impact] : [target, state];
    return Reflect.get(wanted, key) === Reflect.get(found, key);
  });
}
