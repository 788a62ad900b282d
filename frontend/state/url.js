// @ts-check

import { PLAIN_SYMBOLS } from "../format/symbols.js";
import { PARAMETERS, parseParameter } from "./parameters.js";
import { SCENES } from "./scenes.js";

/** The options that are words, each with what it may be; the first is the default. */
const WORDS = {
  map: ["epsilon_t", "switches"],
  scale: ["linear", "log"],
  map_x: ["kappa", "alpha_kappa"],
  map_y: ["gt_over_gn", "psi"],
  shape: ["flat", "surface"],
  energy: ["hidden", "shown"],
};

/** The same of the page around the pictures; they stand in the address only where they are not the first. */
const PAGE_WORDS = {
  scene: SCENES.map(({ id }) => id),
  theme: ["system", "light", "dark"],
  embed: ["none", "result", "force", "velocity", "map", "cut", "contact"],
};

const WORD_KEYS = /** @type {(keyof typeof WORDS)[]} */ (Object.keys(WORDS));

/**
 * What the page shows; it stands in the address bar in full.
 * @typedef {object} PageState
 * @property {import("./parameters.js").Collision} collision
 * @property {"epsilon_t" | "switches"} map the quantity the map shows
 * @property {"linear" | "log"} scale of the axes of map and cut
 * @property {"kappa" | "alpha_kappa"} map_x what the map's horizontal axis is labelled with
 * @property {"gt_over_gn" | "psi"} map_y what map and cut run over
 * @property {"flat" | "surface"} shape of the map
 * @property {"hidden" | "shown"} energy over time, with the velocity
 * @property {string} scene
 * @property {"system" | "light" | "dark"} theme
 * @property {string} embed the one panel to show without the rest of the page, or `none`
 */

/**
 * The state an address describes; what makes no sense there becomes the default and a problem in words.
 * @param {string} search
 * @returns {{state: PageState, problems: string[]}}
 */
export function readAddress(search) {
  const query = new URLSearchParams(search);
  /** @type {string[]} */
  const problems = [];
  /** @type {Record<string, number>} */
  const collision = {};
  for (const parameter of PARAMETERS) {
    const text = query.get(parameter.key);
    const value = text === null ? null : parseParameter(parameter, text);
    if (text !== null && value === null) {
      problems.push(
        `${PLAIN_SYMBOLS[parameter.key]} must be ${parameter.requirement}, not “${shortened(text)}”`,
      );
    }
    collision[parameter.key] = value ?? parameter.initial;
  }
  /** @type {Record<string, string>} */
  const words = {};
  for (const [key, allowed] of Object.entries({ ...WORDS, ...PAGE_WORDS })) {
    const text = query.get(key);
    if (text !== null && !allowed.includes(text)) {
      problems.push(`${key} must be ${allowed.join(" or ")}, not “${shortened(text)}”`);
    }
    words[key] = text !== null && allowed.includes(text) ? text : allowed[0];
  }
  return { state: /** @type {PageState} */ ({ collision, ...words }), problems };
}

/**
 * The address of a state, from its question mark on.
 * @param {PageState} state
 */
export function writeAddress({ collision, ...words }) {
  const query = new URLSearchParams();
  for (const { key } of PARAMETERS) {
    query.set(key, String(collision[key]));
  }
  for (const key of WORD_KEYS) {
    query.set(key, words[key]);
  }
  for (const [key, [usual]] of Object.entries(PAGE_WORDS)) {
    const word = words[/** @type {keyof typeof words} */ (key)];
    if (word !== usual) {
      query.set(key, word);
    }
  }
  return `?${query}`;
}

/** @param {string} text */
function shortened(text) {
  return text.length > 24 ? `${text.slice(0, 23)}…` : text;
}
