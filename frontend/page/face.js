// @ts-check

import { say } from "../format/words.js";
import { sameAccuracy, USUAL_ACCURACY } from "../state/accuracy.js";
import { steersOf } from "../state/lesson.js";
import { ofVisits } from "../state/memory.js";
import { byTestId } from "../widgets/find.js";

/** @typedef {import("../state/url.js").PageState} PageState */

/** Scenes with a plain face; what the others are about are numbers that it leaves out. */
const TWO_FACED = ["explorer", "lesson"];

/**
 * The plain and the expert face of the page, switched where the result says how exact it is. Whoever
 * chose one finds it at the next visit; the lesson begins plain.
 * @param {(patch: Partial<PageState>) => void} onOption
 */
export function mountFace(onOption) {
  const root = document.documentElement;
  const accuracy = byTestId("accuracy");
  const button = byTestId("face");
  let isPlain = true;

  button.addEventListener("click", () => {
    const face = isPlain ? "expert" : "plain";
    ofVisits.remember("face", face);
    onOption({ face });
  });

  return {
    /** @param {PageState} state */
    show(state) {
      const { scene, face, embed } = state;
      const isTwoFaced = TWO_FACED.includes(scene) && embed === "none";
      isPlain = isTwoFaced && (face === "usual" ? usualFace(scene) : face) === "plain";
      root.toggleAttribute("data-plain", isPlain);
      const isFolded = isPlain && !needsAccuracy(state);
      accuracy.toggleAttribute("data-folded", isFolded);
      button.hidden = !isTwoFaced;
      const other = isFolded ? "page.face.howExact" : "page.face.expert";
      button.textContent = say(isPlain ? other : "page.face.plain");
    },
  };
}

/** @param {string} scene */
function usualFace(scene) {
  return scene !== "lesson" && ofVisits.recall("face") === "expert" ? "expert" : "plain";
}

/**
 * Whether the number shown is not the usual one, or a step of the lesson is about how it is got.
 * @param {PageState} state
 */
function needsAccuracy(state) {
  return !sameAccuracy(state.accuracy, USUAL_ACCURACY) || steersOf(state).includes("steps");
}
