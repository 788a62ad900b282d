// @ts-check

import { say } from "../../format/words.js";
import { textsOf } from "../../state/lesson.js";
import { make, told } from "../../widgets/elements.js";
import { inDigits } from "./digits.js";
import { sketchOf } from "./sketch.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("./predictions.js").Prediction} Prediction
 */

/** By how much a key moves the handle. */
const STEP = 0.05;

/**
 * What is asked before the pictures are shown: a handle on a gauge of ε_t, or sketches to choose from.
 * @param {Step} step
 * @param {(guess: Prediction["guess"]) => void} onCommit
 */
export function predictionForm(step, onCommit) {
  const { predict } = textsOf(step);
  const anyway = button("quiet", say("lesson.predict.anyway"), () => onCommit(null));
  anyway.dataset.testid = "predict-anyway";
  const asked = told("p", "lesson-asked", say(predict ?? ""));
  asked.id = "predict-asked";
  asked.dataset.testid = "predict-asked";
  const way = step.prediction?.kind === "gauge" ? gauge(onCommit) : [sketches(step, onCommit)];
  const form = make(
    "div",
    "predict",
    asked,
    ...way,
    make("div", "predict-foot", told("p", "", say("lesson.predict.covered")), anyway),
  );
  form.dataset.testid = "predict";
  form.setAttribute("role", "group");
  form.setAttribute("aria-labelledby", asked.id);
  return form;
}

/**
 * @param {(guess: number) => void} onCommit
 */
function gauge(onCommit) {
  const handle = make("input", "parameter-slider predict-handle");
  const value = make("output", "predict-value");
  Object.assign(handle, { type: "range", min: -1, max: 1, step: STEP, value: 0 });
  handle.setAttribute("aria-label", say("lesson.predict.handle"));
  handle.dataset.testid = "predict-handle";
  value.setAttribute("aria-hidden", "true");
  const follow = () => {
    const digits = inDigits(handle.valueAsNumber);
    value.textContent = digits;
    handle.setAttribute("aria-valuetext", digits);
  };
  handle.addEventListener("input", follow);
  follow();
  const commit = button("predict-commit", say("lesson.predict.commit"), () =>
    onCommit(handle.valueAsNumber),
  );
  commit.dataset.testid = "predict-commit";
  const ends = make(
    "div",
    "gauge-ends",
    told("span", "", say("result.least")),
    told("span", "", say("result.most")),
  );
  return [make("div", "predict-gauge", handle, value, ends), commit];
}

/**
 * @param {Step} step
 * @param {(guess: string) => void} onCommit
 */
function sketches(step, onCommit) {
  return make(
    "div",
    "predict-sketches",
    ...textsOf(step).sketches.map(({ sketch, path, text }) => {
      const choice = button("predict-sketch", "", () => onCommit(sketch));
      choice.append(sketchOf(path), told("span", "", say(text)));
      choice.dataset.sketch = sketch;
      return choice;
    }),
  );
}

/**
 * @param {string} className
 * @param {string} text
 * @param {() => void} onClick
 */
function button(className, text, onClick) {
  const element = told("button", className, text);
  element.type = "button";
  element.addEventListener("click", onClick);
  return element;
}

/**
 * A guess, or what came, in words.
 * @param {Step} step
 * @param {Prediction["guess"]} value
 */
export function inWords(step, value) {
  if (value === null) {
    return say("lesson.predict.none");
  }
  if (typeof value === "number") {
    return inDigits(value);
  }
  return say(textsOf(step).sketches.find(({ sketch }) => sketch === value)?.text ?? "");
}
