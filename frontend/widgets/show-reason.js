// @ts-check

import { find } from "./find.js";
import { typeset } from "./typeset.js";

/**
 * Says over a plot why there is none, or, with nothing to say, shows it again.
 * @param {HTMLElement} stage
 * @param {string} reason
 * @param {string} [refusal] what the server says, which speaks English
 */
export function showReason(stage, reason, refusal = "") {
  stage.toggleAttribute("data-reason", reason !== "");
  const line = find(".reason", stage);
  line.replaceChildren();
  if (reason) {
    line.append(said(refusal ? `${reason}: ` : reason));
  }
  if (refusal) {
    const own = said(refusal);
    own.lang = "en";
    line.append(own);
  }
}

/** @param {string} text */
function said(text) {
  const element = document.createElement("span");
  typeset(element, text);
  return element;
}
