// @ts-check

import { find } from "../../widgets/find.js";

/**
 * The glass over the pictures, the result and the controls: nothing under it can be read or reached,
 * by eye, by keyboard or by a screen reader.
 */
export function mountGlass() {
  const root = document.documentElement;

  return {
    /** @param {boolean} isThere */
    lay(isThere) {
      if (isThere === root.hasAttribute("data-glass")) {
        return;
      }
      root.toggleAttribute("data-glass", isThere);
      for (const part of [find("#controls"), ...document.querySelectorAll("[data-panel]")]) {
        part.toggleAttribute("inert", isThere);
      }
    },
  };
}
