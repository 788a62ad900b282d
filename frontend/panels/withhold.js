// @ts-check

import { find } from "./find.js";
import { typeset } from "./typeset.js";

/**
 * Says over a plot why there is none, or, with nothing to say, shows it again.
 * @param {HTMLElement} stage
 * @param {string} reason
 */
export function withhold(stage, reason) {
  stage.toggleAttribute("data-withheld", reason !== "");
  typeset(find(".withheld", stage), reason);
}
