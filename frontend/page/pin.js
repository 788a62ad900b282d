// @ts-check

import { say } from "../format/words.js";
import { letterOf, withPin } from "../state/pins.js";
import { byTestId } from "../widgets/find.js";

/**
 * The button that pins the present collision, so that the next ones are seen beside it.
 * @param {Pick<import("../scenes/scene.js").Page, "present" | "set" | "say">} page
 */
export function mountPin({ present, set, say: tell }) {
  const button = byTestId("pin");
  button.addEventListener("click", () => {
    const { pins, collision } = present();
    const letter = letterOf(pins, collision);
    const next = withPin(pins, collision);
    if (letter || !next) {
      tell(letter ? say("result.pinnedAlready", { letter }) : say("result.pinsFull"));
      return;
    }
    set({ pins: next });
    byTestId("said").textContent = say("result.pinned", { letter: letterOf(next, collision) });
  });
}
