// @ts-check

import { linkTo } from "../../state/address/bar.js";
import { STEPS, textsOf } from "../../state/lesson.js";
import { make, told } from "../../widgets/elements.js";
import { teacherNotes } from "./teacher-notes.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/lesson.js").Step} Step
 * @typedef {import("../../format/words.js").Say} Say
 */

/** Lines to write on. */
const LINES = 2;

/**
 * All steps of the lesson on paper: with room for the answers, and for teachers with their notes.
 * @param {HTMLElement} element
 * @param {() => void} onClose
 */
export function mountHandout(element, onClose) {
  let isShown = false;

  /** @param {boolean} isThere */
  function stand(isThere) {
    element.hidden = !isThere;
    document.documentElement.toggleAttribute("data-handout", isThere);
  }

  function hide() {
    isShown = false;
    stand(false);
    element.replaceChildren();
  }

  return {
    /**
     * @param {PageState} state
     * @param {Say} say
     * @param {string} language
     */
    show({ handout, notes }, say, language) {
      if (handout !== "shown") {
        hide();
        return;
      }
      const print = make("button", "quiet");
      const close = make("button", "quiet");
      const title = told("h2", "handout-title", say("lesson.handout.title"));
      const buttons = /** @type {const} */ ([
        [print, say("lesson.handout.print"), "handout-print", () => window.print()],
        [close, say("lesson.handout.close"), "handout-close", onClose],
      ]);
      for (const [button, text, hook, onClick] of buttons) {
        button.type = "button";
        button.textContent = text;
        button.dataset.testid = hook;
        button.addEventListener("click", onClick);
      }
      title.id = "handout-title";
      title.tabIndex = -1;
      stand(true);
      element.setAttribute("aria-labelledby", title.id);
      element.replaceChildren(
        make("div", "handout-tools", print, close),
        make(
          "div",
          "handout-sheet",
          title,
          told("p", "handout-intro", say("lesson.handout.intro")),
          make(
            "p",
            "handout-blanks",
            ...blanks([say("lesson.handout.name"), say("lesson.handout.date")]),
          ),
          ...STEPS.map((step, i) => stepOnPaper(step, i + 1, notes === "shown", say, language)),
          told("p", "handout-source", say("lesson.handout.source")),
        ),
      );
      if (!isShown) {
        isShown = true;
        title.focus();
      }
    },

    hide,
  };
}

/**
 * @param {Step} step
 * @param {number} number
 * @param {boolean} withNotes
 * @param {Say} say
 * @param {string} language
 */
function stepOnPaper(step, number, withNotes, say, language) {
  const keys = textsOf(step);
  const part = make(
    "section",
    "handout-step",
    make(
      "div",
      "handout-head",
      told("h3", "", say("lesson.step", { step: number, title: say(keys.title) })),
      make("span", "handout-link", addressOf(number, language)),
    ),
    told("p", "handout-text", say(keys.text)),
    ...(keys.predict ? guessFirst(say(keys.predict), say("lesson.handout.guess")) : []),
    told("p", "handout-question", say(keys.question)),
  );
  if (step.question.kind === "choice") {
    const options = keys.options.map(({ text }) => told("li", "", say(text)));
    part.append(make("ul", "handout-options", ...options));
    part.append(make("p", "handout-why", told("span", "", say("lesson.handout.why"))));
  } else {
    const found = [say("lesson.handout.found"), say("lesson.handout.reading")];
    part.append(make("p", "handout-blanks", ...blanks(found)));
  }
  part.append(...Array.from({ length: LINES }, () => make("div", "handout-line")));
  if (withNotes) {
    part.append(teacherNotes(step, say));
  }
  return part;
}

/**
 * What is to be written down before one looks.
 * @param {string} prompt
 * @param {string} name of the blank
 */
function guessFirst(prompt, name) {
  return [told("p", "handout-text", prompt), make("p", "handout-blanks", ...blanks([name]))];
}

/**
 * Names with room after each.
 * @param {string[]} names
 */
function blanks(names) {
  return names.map((name) => make("span", "handout-blank", told("span", "", name)));
}

/**
 * Where a step is found, in the language of the sheet.
 * @param {number} step
 * @param {string} language
 */
function addressOf(step, language) {
  const query = new URLSearchParams({ scene: "lesson", step: String(step), lang: language });
  const link = linkTo(`?${query}`);
  // whoever has the file has it in another folder
  return link.startsWith("file:") ? link.slice(link.lastIndexOf("/") + 1) : link;
}
