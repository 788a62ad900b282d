// @ts-check

import { STEPS } from "../../state/lesson.js";
import { ofTab } from "../../state/memory.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("./predictions.js").Prediction} Prediction
 */

/**
 * What a reader has answered to a step.
 * @typedef {object} Answered
 * @property {boolean} isDone whether the question has been answered
 * @property {string[]} chosen options, the last one last
 * @property {Prediction | null} prediction
 */

const NAME = "lesson";

/** What was answered, remembered as long as the tab is open. */
export function createRecord() {
  const before = kept();
  const entries = new Map(STEPS.map((step) => [step, answered(before[step.id])]));

  return {
    /** @param {Step} step */
    of: (step) => /** @type {Answered} */ (entries.get(step)),

    /**
     * @param {Step} step
     * @param {Partial<Answered>} patch
     */
    note(step, patch) {
      entries.set(step, { ...answered(entries.get(step)), ...patch });
      const all = [...entries].map(([{ id }, entry]) => [id, entry]);
      ofTab.remember(NAME, JSON.stringify(Object.fromEntries(all)));
    },
  };
}

/** @returns {Record<string, any>} */
function kept() {
  try {
    return JSON.parse(ofTab.recall(NAME) ?? "") ?? {};
  } catch {
    return {};
  }
}

/**
 * An entry as it was kept; what is not as it should be counts for nothing.
 * @param {any} entry
 * @returns {Answered}
 */
function answered(entry) {
  const { isDone, chosen, prediction } = entry ?? {};
  return {
    isDone: isDone === true,
    chosen: Array.isArray(chosen) ? chosen.map(String) : [],
    prediction:
      prediction && typeof prediction === "object"
        ? { guess: prediction.guess ?? null, came: prediction.came ?? null }
        : null,
  };
}
