// @ts-check

import { told, toldIn } from "./elements.js";
import { find } from "./find.js";

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
    line.append(told("span", "", refusal ? `${reason}: ` : reason));
  }
  if (refusal) {
    line.append(toldIn("en", "span", refusal));
  }
}
