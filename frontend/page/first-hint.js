// @ts-check

import { byTestId, find } from "../widgets/find.js";
import { recall, remember } from "./memory.js";

/**
 * What to try first, said until it is sent away.
 */
export function mountFirstHint() {
  const element = byTestId("hint");
  let isAway = recall("hint") === "away";

  find("button", element).addEventListener("click", () => {
    isAway = true;
    element.hidden = true;
    remember("hint", "away");
    find("#controls").focus({ preventScroll: true });
  });

  return {
    /** @param {import("../state/url.js").PageState} state */
    show({ scene, embed }) {
      element.hidden = isAway || scene !== "explorer" || embed !== "none";
    },
  };
}
