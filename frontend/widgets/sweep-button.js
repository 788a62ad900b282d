// @ts-check

import { say } from "../format/words.js";

/** Whether nothing is to move by itself. */
export const calm = matchMedia("(prefers-reduced-motion: reduce)");

/**
 * Names the play button at the end of a slider.
 * @param {HTMLButtonElement} button
 * @param {string} key of the parameter
 * @param {string} symbol
 */
export function nameSweepButton(button, key, symbol) {
  button.dataset.sweep = key;
  button.dataset.symbol = symbol;
  button.title = say(calm.matches ? "controls.step" : "controls.sweep", { symbol });
  button.setAttribute("aria-label", button.title);
}
