// @ts-check

import { splitSymbols } from "../format/symbols.js";

/** A number and its sign of percent are in one line. */
const UNBROKEN = "\u202f%";

/** @type {WeakMap<HTMLElement, string>} */
const written = new WeakMap();

/**
 * Writes a text of the server with its symbols set as symbols, unless it stands there already.
 * @param {HTMLElement} element
 * @param {string} text
 */
export function typeset(element, text) {
  if (written.get(element) === text) {
    return;
  }
  written.set(element, text);
  element.replaceChildren(...splitSymbols(text).flatMap(set));
}

/**
 * @param {ReturnType<typeof splitSymbols>[number]} piece
 * @returns {Node[]}
 */
function set({ plain, letter, index, power }) {
  if (power) {
    return [holding("sup", power)];
  }
  if (!letter) {
    return [document.createTextNode((plain ?? "").replaceAll(" %", UNBROKEN))];
  }
  return index ? [holding("var", letter), holding("sub", index)] : [holding("var", letter)];
}

/**
 * @param {string} name
 * @param {string} text
 */
function holding(name, text) {
  const element = document.createElement(name);
  element.textContent = text;
  return element;
}
