// @ts-check

import { say } from "../format/words.js";
import { sameAccuracy, USUAL_ACCURACY } from "../state/accuracy.js";
import { steersOf } from "../state/lesson.js";
import { ofVisits } from "../state/memory.js";
import { isPlain, isTwoFaced } from "../state/scenes.js";
import { byTestId } from "../widgets/find.js";

/** @typedef {import("../state/address/options.js").PageState} PageState */

/**
 * The plain and the expert face of the page, switched where the result says how exact it is.
 * @param {(patch: Partial<PageState>) => void} onOption
 */
export function mountFace(onOption) {
  const root = document.documentElement;
  const accuracy = byTestId("accuracy");
  const button = byTestId("face");
  let isPlainNow = true;

  button.addEventListener("click", () => {
    const face = isPlainNow ? "expert" : "plain";
    ofVisits.remember("face", face);
    onOption({ face });
  });

  return {
    /** @param {PageState} state */
    show(state) {
      isPlainNow = isPlain(state);
      root.toggleAttribute("data-plain", isPlainNow);
      const isFolded = isPlainNow && !needsAccuracy(state);
      accuracy.toggleAttribute("data-folded", isFolded);
      button.hidden = !isTwoFaced(state);
      const other = isFolded ? "page.face.howExact" : "page.face.expert";
      button.textContent = say(isPlainNow ? other : "page.face.plain");
    },
  };
}

/**
 * Whether the number shown is not the usual one, or a step of the lesson is about how it is got.
 * @param {PageState} state
 */
function needsAccuracy(state) {
  return !sameAccuracy(state.accuracy, USUAL_ACCURACY) || steersOf(state).includes("steps");
}
