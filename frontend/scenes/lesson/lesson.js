// @ts-check

import { say, spokenLanguage } from "../../format/words.js";
import { USUAL_ACCURACY } from "../../state/accuracy.js";
import { stepOf, STEPS, textsOf } from "../../state/lesson.js";
import { writeAddress } from "../../state/address/writing.js";
import { make, setOrRemove, told } from "../../widgets/elements.js";
import { byTestId } from "../../widgets/find.js";
import { typeset } from "../../widgets/typeset.js";
import { mountHandout } from "./handout.js";
import { mountLessonQuestion } from "./question.js";
import { predictionSummary } from "./summary.js";
import { teacherNotes } from "./teacher-notes.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/lesson.js").Step} Step
 */

/**
 * The lesson, open: one step at a time, with its question, beside the pictures of the explorer.
 * @param {HTMLElement} element
 * @param {HTMLElement} handoutElement
 * @param {import("../scene.js").Page} page
 * @param {object} kept what the lesson remembers, and covers
 * @param {ReturnType<typeof import("./record.js").createRecord>} kept.record
 * @param {ReturnType<typeof import("./predictions.js").createPredictions>} kept.predictions
 * @param {ReturnType<typeof import("./glass.js").mountGlass>} kept.glass
 */
export function mountOpenLesson(element, handoutElement, { set }, { record, predictions, glass }) {
  const progress = make("p", "lesson-progress");
  const list = make("ol", "lesson-steps");
  const nav = make("nav", "lesson-contents", list);
  const title = make("h2", "lesson-title");
  const text = make("p", "lesson-text");
  const questionElement = make("div", "lesson-question");
  const previous = button("lesson-previous", () => turn(-1));
  const again = button("lesson-again", () => go(present?.step ?? "1"));
  const next = button("lesson-next", () => turn(1));
  const summary = make("section", "lesson-summary");
  const notes = make("aside", "lesson-notes");
  const notesBox = make("input", "");
  const notesLabel = make("span", "");
  const handoutButton = button("lesson-handout", () => set({ handout: "shown" }));
  const { links, marks } = stepLinks();
  /** @type {PageState | null} */
  let present = null;
  const language = spokenLanguage();
  let drawn = "";
  /** Whether the heading gets the focus, so that a reader goes on there. */
  let isTurning = false;

  const question = mountLessonQuestion(questionElement, record, {
    onDone: drawProgress,
    onPredict(step, guess) {
      predictions.commit(step, guess);
      glass.lay(false);
      draw();
    },
  });
  const gaugeMark = make("span", "gauge-guess");
  byTestId("gauge-mark").before(gaugeMark);
  const handout = mountHandout(handoutElement, () => {
    set({ handout: "hidden" });
    handoutButton.focus();
  });

  title.tabIndex = -1;
  previous.dataset.testid = "lesson-previous";
  next.dataset.testid = "lesson-next";
  again.dataset.testid = "lesson-again";
  handoutButton.dataset.testid = "lesson-handout";
  title.dataset.testid = "lesson-title";
  title.id = "lesson-title";
  progress.dataset.testid = "lesson-progress";
  notes.dataset.testid = "lesson-notes";
  summary.dataset.testid = "lesson-summary";
  notesBox.type = "checkbox";
  notesBox.dataset.testid = "lesson-notes-switch";
  notesBox.addEventListener("change", () => {
    set({ notes: notesBox.checked ? "shown" : "hidden" });
  });
  list.append(...links.map((link) => make("li", "", link)));
  element.setAttribute("aria-labelledby", title.id);
  element.replaceChildren(
    make("div", "lesson-head", nav, progress),
    title,
    text,
    questionElement,
    make("div", "lesson-turns", previous, again, next),
    summary,
    notes,
    make(
      "div",
      "lesson-tools",
      make("label", "lesson-switch", notesBox, notesLabel),
      handoutButton,
    ),
  );

  function stepLinks() {
    const all = STEPS.map((_, i) => {
      const mark = make("span", "lesson-mark");
      const link = make("a", "lesson-link", mark);
      link.addEventListener("click", (event) => {
        event.preventDefault();
        go(String(i + 1));
      });
      return { link, mark };
    });
    return { links: all.map(({ link }) => link), marks: all.map(({ mark }) => mark) };
  }

  /** @param {number} by */
  function turn(by) {
    const step = String(Number(present?.step) + by);
    if (stepOf(step)) {
      isTurning = true;
      go(step);
    } else {
      set({ scene: "explorer", accuracy: USUAL_ACCURACY });
    }
  }

  /** Sets what a step sets. @param {string} step */
  function go(step) {
    set({ step, ...stepOf(step).setting });
  }

  /** What does not depend on the collision. */
  function draw() {
    if (!present) {
      return;
    }
    const { step: number, notes: wish, handout: sheet, scene, theme } = present;
    const isPending = predictions.isPending(present);
    const wanted = JSON.stringify([number, wish, sheet, scene, theme, isPending]);
    if (wanted === drawn) {
      return;
    }
    drawn = wanted;
    const step = stepOf(number);
    const keys = textsOf(step);
    typeset(title, say(keys.title));
    typeset(text, say(keys.text));
    if (isPending) {
      question.ask(step);
    } else {
      question.show(step);
    }
    drawPrediction(step);
    for (const [part, key] of /** @type {const} */ ([
      [previous, "lesson.previous"],
      [again, "lesson.again"],
      [next, step === STEPS.at(-1) ? "lesson.finish" : "lesson.next"],
      [notesLabel, "lesson.notes.switch"],
      [handoutButton, "lesson.handout.open"],
    ])) {
      typeset(part, say(key));
    }
    previous.disabled = step === STEPS[0];
    nav.setAttribute("aria-label", say("lesson.contents"));
    notesBox.checked = wish === "shown";
    notes.hidden = wish !== "shown";
    notes.replaceChildren(
      told("h3", "", say("lesson.notes.title")),
      ...(notes.hidden ? [] : [teacherNotes(step, say)]),
    );
    // On the root and not found by :has(), for which Chromium works out all styles anew whenever
    // anything is put into the page, as Plotly does for each text that it measures.
    const root = document.documentElement.dataset;
    root.look = step.look.join(" ");
    root.steers = step.question.kind === "goal" ? step.question.steers.join(" ") : "";
    drawProgress();
    handout.show(present, say, language);
  }

  /** What was predicted, and what came: of this step, and at the end of all. @param {Step} step */
  function drawPrediction(step) {
    const prediction = predictions.of(step);
    const guess = prediction?.guess;
    question.recall(step, prediction);
    gaugeMark.hidden = typeof guess !== "number";
    gaugeMark.style.setProperty("--place", String((Number(guess) + 1) / 2));
    const all = step === STEPS.at(-1) ? predictions.all() : [];
    summary.hidden = all.length === 0;
    summary.replaceChildren(...(summary.hidden ? [] : predictionSummary(all)));
  }

  function drawProgress() {
    if (!present) {
      return;
    }
    const done = STEPS.filter((step) => record.of(step).isDone);
    const values = { step: present.step, count: done.length, of: STEPS.length };
    typeset(progress, say("lesson.progress", values));
    for (const [i, step] of STEPS.entries()) {
      const number = String(i + 1);
      const isHere = number === present.step;
      const state = { ...present, step: number, ...step.setting };
      const named = say("lesson.step", { step: number, title: say(textsOf(step).title) });
      links[i].href = writeAddress(state);
      links[i].toggleAttribute("data-done", done.includes(step));
      setOrRemove(links[i], "aria-current", isHere ? "step" : "");
      const label = done.includes(step) ? say("lesson.stepDone", { name: named }) : named;
      links[i].setAttribute("aria-label", label);
      links[i].title = label;
      marks[i].textContent = number;
    }
  }

  return {
    /** @param {PageState} state */
    show(state) {
      present = state;
      if (state.scene !== "lesson") {
        handout.hide();
        gaugeMark.hidden = true;
        drawn = "";
        return;
      }
      question.follow(state);
      draw();
      if (isTurning) {
        isTurning = false;
        title.focus();
        if (element.getBoundingClientRect().top < 0) {
          element.scrollIntoView();
        }
      }
    },

    /**
     * @param {import("../../state/loading/collision-load.js").LoadedCollision} answer of the present collision
     * @param {boolean} dragging
     */
    settle({ result, trace, isOffered }, dragging) {
      // Where nobody answers by the chosen method, what stands in is no answer to the question.
      if (present?.scene === "lesson" && trace && isOffered) {
        const seen = { state: present, exact: trace, shown: result };
        const step = stepOf(present.step);
        predictions.note(step, seen);
        question.settle(seen, dragging);
        question.recall(step, predictions.of(step));
      }
    },
  };
}

/**
 * @param {string} className
 * @param {() => void} onClick
 */
function button(className, onClick) {
  const element = make("button", `quiet ${className}`);
  element.type = "button";
  element.addEventListener("click", onClick);
  return element;
}
