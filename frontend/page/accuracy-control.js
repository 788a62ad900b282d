// @ts-check

import { brief, powerOfTen } from "../format/number.js";
import { isSaid, say } from "../format/words.js";
import { knobOf, METHODS, nearestNotch, sameAccuracy } from "../state/accuracy.js";
import { byTestId, find } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/** @typedef {import("../state/accuracy.js").Accuracy} Accuracy */

/**
 * The method by name, and its knob as one slider from fast to exact.
 * @param {HTMLElement} element
 * @param {(patch: Partial<Accuracy>, change: import("../state/store.js").Change) => void} onChange
 */
export function mountAccuracyControl(element, onChange) {
  const choice = /** @type {HTMLSelectElement} */ (byTestId("method", element));
  const slider = /** @type {HTMLInputElement} */ (byTestId("accuracy-slider", element));
  const scale = find(".accuracy-scale", element);
  const value = byTestId("accuracy-value", element);
  const refusal = byTestId("accuracy-refusal", element);
  /** @type {Accuracy | null} */
  let shown = null;

  choice.append(...METHODS.map(({ id, title }) => new Option(title, id)));
  choice.addEventListener("change", (event) => {
    onChange({ method: choice.value }, { dragging: false, inputTimeStamp: event.timeStamp });
  });
  for (const kind of ["input", "change"]) {
    slider.addEventListener(kind, (event) => {
      const knob = knobOf(choice.value);
      if (knob) {
        onChange(
          { [knob.key]: knob.notches[slider.valueAsNumber] },
          { dragging: kind === "input", inputTimeStamp: event.timeStamp },
        );
      }
    });
  }

  return {
    /**
     * Where a method does not answer, the exact result stands in.
     * @param {string} reason for that by its key, none where the method answers
     */
    tell(reason) {
      typeset(refusal, isSaid(reason) ? say(reason) : "");
    },

    /** @param {Accuracy} accuracy */
    show(accuracy) {
      if (shown && sameAccuracy(shown, accuracy)) {
        return;
      }
      shown = accuracy;
      choice.value = accuracy.method;
      const knob = knobOf(accuracy.method);
      scale.toggleAttribute("hidden", !knob);
      value.textContent = "";
      if (knob) {
        const now = accuracy[knob.key];
        slider.max = String(knob.notches.length - 1);
        slider.valueAsNumber = nearestNotch(knob, now);
        const name = say(`knobs.${knob.key}`);
        slider.setAttribute("aria-label", say("accuracy.scaleOf", { name }));
        slider.setAttribute("aria-valuetext", `${name} ${now}`);
        value.textContent = inShort(knob.key, now);
      }
    },
  };
}

/**
 * @param {string} key
 * @param {number} value
 */
function inShort(key, value) {
  if (key === "steps") {
    return say("accuracy.steps", { steps: brief(value) });
  }
  const power = Math.log10(value);
  return say("accuracy.to", { error: Number.isInteger(power) ? powerOfTen(power) : brief(value) });
}
