// @ts-check

import { say as words } from "../format/words.js";
import { markLanguage } from "../widgets/elements.js";

/**
 * A line that says something for as long as it is true, or until it is closed, and is not there otherwise.
 * @param {HTMLElement} line in a frame of its own, where its button to close it is
 */
export function mountMessage(line) {
  const frame = /** @type {HTMLElement} */ (line.parentElement);
  const close = document.createElement("button");
  let truth = "";
  let language = "";
  close.type = "button";
  close.className = "message-close";
  close.setAttribute("aria-label", words("messages.close"));
  close.addEventListener("click", () => show(""));
  frame.append(close);

  /** @param {string} text */
  function show(text) {
    frame.hidden = text === "";
    markLanguage(line, language);
    if (line.textContent !== text) {
      line.textContent = text;
    }
  }

  return {
    /**
     * @param {string} text
     * @param {string} [spoken] its language, where it is not that of the page
     */
    say(text, spoken = "") {
      truth = text;
      language = spoken;
      show(text);
    },

    /** Something has happened: what was closed and is still true is said again. */
    remind: () => show(truth),

    clear() {
      truth = "";
      show("");
    },
  };
}
