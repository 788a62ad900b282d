// @ts-check

import { say } from "../format/words.js";
import { sweepOf } from "../state/sweep.js";
import { calm } from "./motion.js";

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

/**
 * The play buttons of the sliders. What plays comes with the first press, and then takes them over.
 * @param {(patch: Partial<import("../state/address/options.js").PageState>, change: {dragging: boolean}) => void} set
 * @returns {(take: (button: HTMLElement) => void) => void} told of every press, also of one before it was there
 */
export function mountSweepButtons(set) {
  /** @type {HTMLElement | null} */
  let waiting = null;
  /** @param {HTMLElement} button */
  let press = (button) => {
    waiting = button;
    set({ sweep: sweepOf(button.dataset.sweep ?? "") }, { dragging: true });
  };
  document.addEventListener("click", ({ target }) => {
    const button = /** @type {Element} */ (target).closest("[data-sweep]");
    if (button) {
      press(/** @type {HTMLElement} */ (button));
    }
  });

  return (take) => {
    press = take;
    if (waiting) {
      take(waiting);
    }
  };
}
