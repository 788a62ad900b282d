// @ts-check

import { find } from "./find.js";
import { typeset } from "./typeset.js";

/**
 * Says over a plot why there is none, or, with nothing to say, shows it again.
 * @param {HTMLElement} stage
 * @param {string} reason
 */
export function showReason(stage, reason) {
  stage.toggleAttribute("data-reason", reason !== "");
  typeset(find(".reason", stage), reason);
}
