// @ts-check

import { ofVisits } from "../state/memory.js";
import { byTestId, find } from "../widgets/find.js";

/**
 * What to try first, said until it is sent away.
 */
export function mountFirstHint() {
  const element = byTestId("hint");
  let isAway = ofVisits.recall("hint") === "away";

  find("button", element).addEventListener("click", () => {
    isAway = true;
    element.hidden = true;
    ofVisits.remember("hint", "away");
    find("#controls").focus({ preventScroll: true });
  });

  return {
    /** @param {import("../state/address/options.js").PageState} state */
    show({ scene, embed }) {
      element.hidden = isAway || scene !== "explorer" || embed !== "none";
    },
  };
}
