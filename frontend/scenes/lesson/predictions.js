// @ts-check

import { sameAccuracy } from "../../state/accuracy.js";
import { stepOf, STEPS } from "../../state/lesson.js";
import { sameCollision } from "../../state/parameters.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("../../state/lesson.js").Seen} Seen
 * @typedef {import("../../state/address/options.js").PageState} PageState
 */

/**
 * What was thought before the pictures of a step were shown, and what came: an ε_t or a sketch by its
 * name. No guess is null, and so is what has not come yet.
 * @typedef {{guess: number | string | null, came: number | string | null}} Prediction
 */

/**
 * The predictions of a lesson.
 * @param {ReturnType<typeof import("./record.js").createRecord>} record
 */
export function createPredictions(record) {
  /** What the server has last said of where a step starts. @type {Map<Step, number | string>} */
  const starts = new Map();

  return {
    /** Whether a state waits for a prediction, until which its pictures are covered. @param {PageState} state */
    isPending(state) {
      const step = stepOf(state.step);
      return (
        state.scene === "lesson" &&
        state.embed === "none" &&
        step.prediction !== undefined &&
        !record.of(step).prediction &&
        isAtStart(step, state)
      );
    },

    /** @param {Step} step */
    of: (step) => record.of(step).prediction,

    /** All of them, in the order of the lesson. */
    all: () =>
      STEPS.flatMap((step) => {
        const { prediction } = record.of(step);
        return prediction ? [{ step, ...prediction }] : [];
      }),

    /**
     * @param {Step} step
     * @param {Prediction["guess"]} guess
     */
    commit(step, guess) {
      record.note(step, { prediction: { guess, came: starts.get(step) ?? null } });
    },

    /**
     * What came, if it is of where the step starts.
     * @param {Step} step
     * @param {Seen} seen
     */
    note(step, seen) {
      const { prediction } = step;
      if (!prediction || !isAtStart(step, seen.state)) {
        return;
      }
      const came = prediction.kind === "gauge" ? seen.exact.epsilon_t : prediction.came(seen);
      starts.set(step, came);
      const known = record.of(step).prediction;
      if (known) {
        record.note(step, { prediction: { ...known, came } });
      }
    },
  };
}

/**
 * Whether a state is as a step sets it.
 * @param {Step} step
 * @param {Pick<PageState, "collision" | "accuracy">} state
 */
export function isAtStart({ setting }, { collision, accuracy }) {
  return sameCollision(setting.collision, collision) && sameAccuracy(setting.accuracy, accuracy);
}
