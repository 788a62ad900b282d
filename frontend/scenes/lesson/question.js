// @ts-check

import { ABSENT } from "../../format/number.js";
import { sameAccuracy } from "../../state/accuracy.js";
import { READINGS, textsOf } from "../../state/lesson.js";
import { sameCollision } from "../../state/parameters.js";
import { make } from "../../widgets/elements.js";
import { typeset } from "../../widgets/typeset.js";

/**
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("../../state/lesson.js").Seen} Seen
 * @typedef {import("../../state/url.js").PageState} PageState
 * @typedef {import("../../format/words.js").Say} Say
 */

/**
 * The question of a step: options to choose from, or a goal for the collision. What was answered is
 * remembered as long as the page is open.
 * @param {HTMLElement} element
 * @param {(step: Step) => void} onDone
 */
export function mountLessonQuestion(element, onDone) {
  const text = make("p", "lesson-asked");
  const answers = make("div", "lesson-answers");
  const verdict = make("strong", "");
  const reason = make("span", "");
  const feedback = make("p", "lesson-feedback", verdict, " ", reason);
  /** The options chosen so far, the last one last. @type {Map<Step, string[]>} */
  const chosen = new Map();
  /** The goals that were reached. @type {Set<Step>} */
  const reached = new Set();
  /** @type {Step | null} */
  let step = null;
  /** @type {Say | null} */
  let say = null;
  let language = "";
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
  element.setAttribute("role", "group");
  element.setAttribute("aria-labelledby", text.id);
  element.replaceChildren(text, answers, feedback);

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
   * @param {Say} speak
   */
  function drawOptions(asked, speak) {
    const { question } = asked;
    if (question.kind !== "choice") {
      return;
    }
    const tried = chosen.get(asked) ?? [];
    const last = tried.at(-1);
    for (const { option, text: key, reason: why } of textsOf(asked).options) {
      const button = optionButton(option);
      const isRight = option === question.right;
      const isTried = tried.includes(option);
      typeset(/** @type {HTMLElement} */ (button.lastElementChild), speak(key));
      button.ariaPressed = String(option === last);
      button.toggleAttribute("data-tried", isTried);
      button.dataset.kind = isTried ? (isRight ? "right" : "wrong") : "open";
      if (option === last) {
        const head = speak(isRight ? "lesson.right" : "lesson.wrong");
        tell(isRight ? "right" : "wrong", head, speak(why));
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
    if (!step || !say || step.question.kind !== "choice") {
      return;
    }
    chosen.set(step, [...(chosen.get(step) ?? []), option]);
    drawOptions(step, say);
    if (option === step.question.right) {
      onDone(step);
    }
    feedback.scrollIntoView({ block: "nearest" });
  }

  /** How far the present collision is from the goal. */
  function judge() {
    if (!step || !say || step.question.kind !== "goal") {
      return;
    }
    const { question } = step;
    const isSeen = seen !== null && present !== null && isOf(seen, present);
    if (isSeen && seen) {
      drawReadings(question.readings, seen, say);
    }
    const { verdicts } = textsOf(step);
    const outcome = isSeen && seen ? question.judge(seen) : "";
    if (outcome === "met" && !isDragging && !reached.has(step)) {
      reached.add(step);
      onDone(step);
    }
    if (reached.has(step)) {
      tell("right", say("lesson.reached"), say(verdicts.met));
    } else if (outcome === "met") {
      tell("there", say("lesson.there"), "");
    } else if (outcome && present && isMoved(step, present)) {
      tell("wrong", say("lesson.notYet"), say(verdicts[outcome]));
    } else {
      tell("open", "", say("lesson.try"));
    }
  }

  /**
   * @param {(keyof typeof READINGS)[]} names
   * @param {Seen} now
   * @param {Say} speak
   */
  function drawReadings(names, now, speak) {
    for (const [i, name] of names.entries()) {
      const there = answers.children[i] ?? answers.appendChild(make("span", "lesson-reading"));
      const value = inDigits(READINGS[name](now), language);
      typeset(/** @type {HTMLElement} */ (there), speak(`lesson.readings.${name}`, { value }));
    }
  }

  return {
    /**
     * @param {Step} next
     * @param {Say} speak
     * @param {string} spoken its language
     */
    show(next, speak, spoken) {
      const isAnother = next !== step;
      step = next;
      say = speak;
      language = spoken;
      element.dataset.kind = step.question.kind;
      typeset(text, say(textsOf(step).question));
      if (isAnother) {
        answers.replaceChildren();
        tell("open", "", "");
      }
      drawOptions(step, say);
      judge();
    },

    /** @param {PageState} state */
    follow(state) {
      present = state;
    },

    /**
     * @param {Seen} now
     * @param {boolean} dragging a goal is reached only where one stops
     */
    settle(now, dragging) {
      seen = now;
      isDragging = dragging;
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

/**
 * Whether something has been changed since the step began.
 * @param {Step} step
 * @param {PageState} state
 */
function isMoved({ setting }, { collision, accuracy }) {
  return !sameCollision(setting.collision, collision) || !sameAccuracy(setting.accuracy, accuracy);
}

/**
 * A number as it is written in a language, with a real minus sign.
 * @param {number | null} value
 * @param {string} language
 */
function inDigits(value, language) {
  if (value === null) {
    return ABSENT;
  }
  const digits = new Intl.NumberFormat(language, {
    maximumSignificantDigits: 4,
    // 37.200 on its own might be 37.2.
    useGrouping: false,
  });
  return digits.format(Math.abs(value) < ROUNDED_AWAY ? 0 : value).replace("-", "\u2212");
}

/** Below this a reading is shown as 0. */
const ROUNDED_AWAY = 1e-12;
