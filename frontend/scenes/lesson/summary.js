// @ts-check

import { say } from "../../format/words.js";
import { stepNumber, textsOf } from "../../state/lesson.js";
import { make, told } from "../../widgets/elements.js";
import { inWords } from "./prediction-form.js";
import { sketchOf } from "./sketch.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("./predictions.js").Prediction} Prediction
 */

/**
 * Pairs of what was thought and what came.
 * @param {({step: Step} & Prediction)[]} predictions
 */
export function predictionSummary(predictions) {
  return [
    told("h3", "", say("lesson.summary.title")),
    make(
      "ol",
      "pairs",
      ...predictions.map(({ step, guess, came }) =>
        make(
          "li",
          "pair",
          told("strong", "pair-step", stepNumber(step)),
          make("div", "pair-pictures", picture(step, guess, came)),
          line(say("lesson.summary.guess"), inWords(step, guess), "guess"),
          line(say("lesson.summary.came"), inWords(step, came), "came"),
        ),
      ),
    ),
  ];
}

/**
 * @param {string} name
 * @param {string} value
 * @param {string} mark
 */
function line(name, value, mark) {
  const sign = make("span", `pair-mark ${mark}`);
  return make("p", "pair-line", sign, told("span", "", name), " ", told("b", "", value));
}

/**
 * Both on one gauge, or the two sketches.
 * @param {Step} step
 * @param {Prediction["guess"]} guess
 * @param {Prediction["came"]} came
 */
function picture(step, guess, came) {
  if (step.prediction?.kind === "sketch") {
    const pathOf = (/** @type {unknown} */ name) =>
      textsOf(step).sketches.find(({ sketch }) => sketch === name)?.path ?? "";
    return make("div", "pair-sketches", sketchOf(pathOf(guess)), sketchOf(pathOf(came)));
  }
  const marks = [guess, came].map((value, i) => {
    const mark = make("span", `pair-mark ${i === 0 ? "guess" : "came"}`);
    mark.style.setProperty("--place", String((Number(value) + 1) / 2));
    mark.hidden = typeof value !== "number";
    return mark;
  });
  const gauge = make("div", "pair-gauge", ...marks);
  gauge.setAttribute("aria-hidden", "true");
  return gauge;
}
