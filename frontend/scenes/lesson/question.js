// @ts-check

import { say } from "../../format/words.js";
import { sameAccuracy } from "../../state/accuracy.js";
import { READINGS, textsOf } from "../../state/lesson.js";
import { sameCollision } from "../../state/parameters.js";
import { make } from "../../widgets/elements.js";
import { typeset } from "../../widgets/typeset.js";
import { inDigits } from "./digits.js";
import { inWords, predictionForm } from "./prediction-form.js";
import { isAtStart } from "./predictions.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("../../state/lesson.js").Seen} Seen
 * @typedef {import("../../state/address/options.js").PageState} PageState
 */

/**
 * The question of a step: options to choose from, or a goal for the collision; before it, in some, what
 * is to be predicted.
 * @param {HTMLElement} element
 * @param {ReturnType<typeof import("./record.js").createRecord>} record
 * @param {object} handlers
 * @param {() => void} handlers.onDone
 * @param {(step: Step, guess: import("./predictions.js").Prediction["guess"]) => void} handlers.onPredict
 */
export function mountLessonQuestion(element, record, { onDone, onPredict }) {
  const text = make("p", "lesson-asked");
  const guess = make("p", "lesson-guess");
  const answers = make("div", "lesson-answers");
  const verdict = make("strong", "");
  const reason = make("span", "");
  const feedback = make("p", "lesson-feedback", verdict, " ", reason);
  /** @type {Step | null} */
  let step = null;
  /** What the server has last said, and of what. @type {Seen | null} */
  let seen = null;
  /** @type {PageState | null} */
  let present = null;
  let isDragging = false;

  text.id = "lesson-asked";
  text.dataset.testid = "lesson-asked";
  answers.dataset.testid = "lesson-answers";
  feedback.dataset.testid = "lesson-feedback";
  feedback.setAttribute("role", "status");
  text.tabIndex = -1;
  guess.dataset.testid = "lesson-guess";
  element.setAttribute("role", "group");

  /**
   * @param {"right" | "wrong" | "there" | "open"} kind
   * @param {string} head
   * @param {string} because
   */
  function tell(kind, head, because) {
    element.dataset.verdict = kind;
    typeset(verdict, head);
    typeset(reason, because);
  }

  /**
   * @param {Step} asked
   */
  function drawOptions(asked) {
    const { question } = asked;
    if (question.kind !== "choice") {
      return;
    }
    const tried = record.of(asked).chosen;
    const last = tried.at(-1);
    for (const { option, text: key, reason: why } of textsOf(asked).options) {
      const button = optionButton(option);
      const isRight = option === question.right;
      const isTried = tried.includes(option);
      typeset(/** @type {HTMLElement} */ (button.lastElementChild), say(key));
      button.ariaPressed = String(option === last);
      button.toggleAttribute("data-tried", isTried);
      button.dataset.kind = isTried ? (isRight ? "right" : "wrong") : "open";
      if (option === last) {
        const head = say(isRight ? "lesson.right" : "lesson.wrong");
        tell(isRight ? "right" : "wrong", head, say(why));
      }
    }
    if (!last) {
      tell("open", "", "");
    }
  }

  /** @param {string} option @returns {HTMLButtonElement} that of the option, made if it is not there */
  function optionButton(option) {
    const there = answers.querySelector(`[data-option="${option}"]`);
    if (there) {
      return /** @type {HTMLButtonElement} */ (there);
    }
    const mark = make("span", "lesson-sign");
    mark.setAttribute("aria-hidden", "true");
    const button = make("button", "lesson-option", mark, make("span", ""));
    button.type = "button";
    button.dataset.option = option;
    button.addEventListener("click", () => choose(option));
    answers.append(button);
    return button;
  }

  /** @param {string} option */
  function choose(option) {
    if (!step || step.question.kind !== "choice") {
      return;
    }
    const { chosen, isDone } = record.of(step);
    const isRight = option === step.question.right;
    record.note(step, { chosen: [...chosen, option], isDone: isDone || isRight });
    drawOptions(step);
    onDone();
    feedback.scrollIntoView({ block: "nearest" });
  }

  /** How far the present collision is from the goal. */
  function judge() {
    if (!step || step.question.kind !== "goal") {
      return;
    }
    const { question } = step;
    const isSeen = seen !== null && present !== null && isOf(seen, present);
    if (isSeen && seen) {
      drawReadings(question.readings, seen);
    }
    const { verdicts } = textsOf(step);
    const outcome = isSeen && seen ? question.judge(seen) : "";
    if (outcome === "met" && isDragging) {
      tell("there", say("lesson.there"), "");
    } else if (outcome === "met") {
      record.note(step, { isDone: true });
      onDone();
      tell("right", say("lesson.reached"), say(verdicts.met));
    } else if (outcome && present && !isAtStart(step, present)) {
      // What was reached once stays answered; what is said is of the present collision.
      const head = record.of(step).isDone ? "lesson.noLonger" : "lesson.notYet";
      tell("wrong", say(head), say(verdicts[outcome]));
    } else {
      tell("open", "", say("lesson.try"));
    }
  }

  /**
   * @param {(keyof typeof READINGS)[]} names
   * @param {Seen} now
   */
  function drawReadings(names, now) {
    for (const [i, name] of names.entries()) {
      const there = answers.children[i] ?? answers.appendChild(make("span", "lesson-reading"));
      const value = inDigits(READINGS[name](now));
      typeset(/** @type {HTMLElement} */ (there), say(`lesson.readings.${name}`, { value }));
    }
  }

  return {
    /**
     * What is to be predicted, in place of the question.
     * @param {Step} next
     */
    ask(next) {
      step = null;
      const commit = (/** @type {import("./predictions.js").Prediction["guess"]} */ made) => {
        onPredict(next, made);
        text.focus();
      };
      const form = predictionForm(next, commit);
      element.dataset.kind = "prediction";
      element.dataset.verdict = "open";
      element.setAttribute("aria-labelledby", "predict-asked");
      element.replaceChildren(form);
    },

    /**
     * What was predicted, if anything was.
     * @param {Step} of
     * @param {import("./predictions.js").Prediction | null} prediction
     */
    recall(of, prediction) {
      const isMade = prediction !== null && prediction.guess !== null;
      guess.hidden = !isMade;
      if (isMade) {
        const [thought, came] = [prediction.guess, prediction.came].map((value) =>
          value === null ? "…" : inWords(of, value),
        );
        typeset(guess, say("lesson.predict.recall", { guess: thought, came }));
      }
    },

    /**
     * @param {Step} next
     */
    show(next) {
      const isAnother = next !== step;
      step = next;
      element.dataset.kind = step.question.kind;
      element.setAttribute("aria-labelledby", text.id);
      if (text.parentElement !== element) {
        element.replaceChildren(text, guess, answers, feedback);
      }
      typeset(text, say(textsOf(step).question));
      if (isAnother) {
        answers.replaceChildren();
        tell("open", "", "");
      }
      drawOptions(step);
      judge();
    },

    /** @param {PageState} state */
    follow(state) {
      present = state;
      feedback.toggleAttribute("data-stale", seen !== null && !isOf(seen, state));
    },

    /**
     * @param {Seen} now
     * @param {boolean} dragging a goal is reached only where one stops
     */
    settle(now, dragging) {
      seen = now;
      isDragging = dragging;
      feedback.removeAttribute("data-stale");
      judge();
    },
  };
}

/**
 * Whether an answer is of a state.
 * @param {Seen} seen
 * @param {PageState} state
 */
function isOf(seen, state) {
  return (
    sameCollision(seen.state.collision, state.collision) &&
    sameAccuracy(seen.state.accuracy, state.accuracy)
  );
}
