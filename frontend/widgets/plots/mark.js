// @ts-check

import { typeset } from "../typeset.js";

/** @typedef {import("../../state/scales.js").Place} Place */

/** Where what is beyond the axes lies, by how far right and up. @type {Record<string, string>} */
const ARROWS = {
  "-1 0": "←",
  "1 0": "→",
  "0 1": "↑",
  "0 -1": "↓",
  "-1 1": "↖",
  "1 1": "↗",
  "1 -1": "↘",
  "-1 -1": "↙",
};

/**
 * Moves the mark of a picture, which is laid over it: a ring, with lines through it or none. What is
 * beyond an axis has no ring, as if it were at its end, but an arrow and its value.
 * @param {HTMLElement} element
 */
export function createMark(element) {
  const label = document.createElement("span");
  label.className = "beyond";
  label.hidden = true;
  element.append(label);

  return {
    /**
     * @param {Place} place
     * @param {{x: string, y: string}} words what is marked has along each axis
     */
    show({ x, y, beyond }, words) {
      element.style.setProperty("--x", String(x));
      element.style.setProperty("--y", String(1 - y));
      element.toggleAttribute("data-placed", true);
      element.toggleAttribute("data-beyond-x", beyond.x !== 0);
      element.toggleAttribute("data-beyond-y", beyond.y !== 0);
      const told = [beyond.x !== 0 ? words.x : "", beyond.y !== 0 ? words.y : ""].filter(Boolean);
      label.hidden = told.length === 0;
      if (told.length > 0) {
        typeset(label, `${told.join(", ")} ${ARROWS[`${beyond.x} ${beyond.y}`]}`);
      }
    },

    hide() {
      element.removeAttribute("data-placed");
    },
  };
}
