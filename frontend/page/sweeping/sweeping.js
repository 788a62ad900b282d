// @ts-check

import { typable } from "../../format/number.js";
import { say } from "../../format/words.js";
import { sweepOf, sweptBy, writeSweep } from "../../state/sweep.js";
import { make } from "../../widgets/elements.js";
import { byTestId, find } from "../../widgets/find.js";
import { calm } from "../../widgets/motion.js";
import { nameSweepButton } from "../../widgets/sweep-buttons.js";
import { courseOf, createRun, placeAt, spanOf, stepOn } from "./course.js";
import { createDetails } from "./details.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/sweep.js").Sweep} Sweep
 */

/** What a collision is shown for: where it changes by another hand, the sweep is over. */
const SUBJECT = /** @type {const} */ (["collision", "impact", "spin_share", "scene", "step"]);

/** Keys that lead to a control without doing anything, and those that press its own button. */
const HARMLESS = ["Tab", "Shift"];
const PRESSING = ["Enter", " "];

/**
 * What goes there and back by itself: a slider, moved as a hand moves it, until one touches anything.
 * Where nothing is to move by itself, each press is a step.
 * @param {import("../../scenes/scene.js").Page} page
 * @param {ReturnType<typeof import("../../widgets/sweep-buttons.js").mountSweepButtons>} takePresses
 * @param {ReturnType<typeof import("../../scenes/explorer/trails.js").createTrails>} trails
 * @returns {import("../../scenes/scene.js").Scene}
 */
export function mountSweeping({ present, set }, takePresses, trails) {
  const said = byTestId("said");
  const more = make("button", "sweep-more", "⋯");
  const details = createDetails(more, {
    onChange: (sweep, change) => set({ sweep }, run.isRunning() ? { dragging: true } : change),
    onAway() {
      halt();
      find(`[data-sweep="${present().sweep?.key}"]`).focus();
      set({ sweep: null });
    },
  });
  const run = createRun({
    course: () => course(),
    onShare: move,
    onEnd: halt,
    nextFrame: (task) => requestAnimationFrame(task),
  });
  /** The slider that is ready, once it is there. @type {{button: HTMLButtonElement, slider: HTMLInputElement} | null} */
  let ready = null;
  let shown = "";
  /** Whether what changes is the sweep's own doing. */
  let isOwn = false;
  /** Whether what is shown came of it. */
  let isTrailing = false;
  /** The way that the last step went. @type {import("./course.js").Place["way"] | null} */
  let way = null;
  /** @type {import("../../api/answers.js").Trace | null} */
  let trace = null;

  more.type = "button";
  more.dataset.testid = "sweep-more";
  // Once it has been told what is shown.
  queueMicrotask(() => takePresses(press));

  /** @returns {import("./course.js").Course} */
  function course() {
    const sweep = /** @type {Sweep} */ (present().sweep);
    return courseOf(sweep, /** @type {any} */ (sweptBy(sweep.key)).scale);
  }

  /** Where the slider is, as a share of it. */
  function share() {
    return ready && ready.slider.valueAsNumber / Number(ready.slider.max);
  }

  /** @param {HTMLElement} button */
  function press(button) {
    const { sweep } = present();
    const isAnother = sweep?.key !== button.dataset.sweep;
    if (run.isRunning()) {
      halt();
      return;
    }
    if (isAnother) {
      way = null;
      set({ sweep: sweepOf(button.dataset.sweep ?? "") }, { dragging: true });
      trails.clear();
    }
    isTrailing = true;
    leaveTrail();
    (calm.matches ? step : begin)();
  }

  function begin() {
    const { button, slider } = /** @type {NonNullable<typeof ready>} */ (ready);
    const { from, to } = /** @type {Sweep} */ (present().sweep);
    const values = { symbol: button.dataset.symbol ?? "", from: typable(from), to: typable(to) };
    // Its steps would be seen in a narrow range.
    slider.dataset.step = slider.step;
    slider.step = "any";
    button.dataset.playing = "";
    button.setAttribute("aria-label", say("sweep.pause", values));
    button.title = say("sweep.pause", values);
    said.textContent = say("sweep.started", values);
    addEventListener("pointerdown", haltFor, true);
    addEventListener("keydown", haltFor, true);
    document.addEventListener("visibilitychange", halt);
    run.start(share() ?? 0);
  }

  function step() {
    const from = placeAt(share() ?? 0, course());
    const next = stepOn({ ...from, way: way ?? from.way }, course());
    way = next.way;
    move(next.share);
    settleDown("sweep.stepped");
  }

  /** As a hand that drags. @param {number} to a share */
  function move(to) {
    if (ready) {
      ready.slider.value = String(Number((to * Number(ready.slider.max)).toPrecision(4)));
      tell("input");
    }
  }

  /** @param {"input" | "change"} kind of what a hand on the slider does */
  function tell(kind) {
    isOwn = true;
    ready?.slider.dispatchEvent(new Event(kind));
    isOwn = false;
  }

  /** The value stays as it is, one step for all of it. @param {string} key of what is said */
  function settleDown(key) {
    tell("change");
    const symbol = ready?.button.dataset.symbol ?? "";
    said.textContent = say(key, { symbol, value: ready?.slider.ariaValueText ?? "" });
  }

  /** Ends what runs, if anything does. */
  function rest() {
    run.stop();
    removeEventListener("pointerdown", haltFor, true);
    removeEventListener("keydown", haltFor, true);
    document.removeEventListener("visibilitychange", halt);
    if (ready && "step" in ready.slider.dataset) {
      const { button, slider } = ready;
      slider.step = slider.dataset.step ?? "1";
      delete slider.dataset.step;
      delete button.dataset.playing;
      nameSweepButton(button, button.dataset.sweep ?? "", button.dataset.symbol ?? "");
      return true;
    }
    return false;
  }

  function halt() {
    if (rest()) {
      settleDown("sweep.stopped");
    }
  }

  /** Any touch and any key but those of the sweep itself. @param {Event} event */
  function haltFor(event) {
    const target = /** @type {Node} */ (event.target);
    const key = event instanceof KeyboardEvent ? event.key : null;
    const isPress = target === ready?.button && (key === null || PRESSING.includes(key));
    const isOfCard = [more, details.element].some((part) => part.contains(target));
    if (!isPress && !isOfCard && !HARMLESS.includes(key ?? "")) {
      halt();
    }
  }

  function leaveTrail() {
    const at = share();
    if (isTrailing && trace && at !== null) {
      trails.add(trace, at, spanOf(course()));
    }
  }

  /** Finds the slider, which may come later than its sweep, and marks the range. @param {Sweep | null} sweep */
  function show(sweep) {
    const wanted = sweep ? writeSweep(sweep) : "";
    if (wanted === shown && (!sweep || ready?.button.isConnected)) {
      return;
    }
    shown = wanted;
    const button = /** @type {HTMLButtonElement | null} */ (
      document.querySelector(`[data-sweep="${sweep?.key}"]`)
    );
    if (button !== (ready?.button ?? null)) {
      moveTo(button);
    }
    if (ready && sweep) {
      const { from, to } = course();
      ready.slider.style.setProperty("--low", String(Math.min(from, to)));
      ready.slider.style.setProperty("--high", String(Math.max(from, to)));
      details.show(sweep, ready.button.dataset.symbol ?? "");
    }
  }

  /** To another slider, or none. @param {HTMLButtonElement | null} button */
  function moveTo(button) {
    const parent = button?.parentElement;
    ready?.slider.removeAttribute("data-swept");
    more.remove();
    details.element.remove();
    ready = null;
    if (button && parent) {
      const slider = /** @type {HTMLInputElement} */ (find("[type=range]", parent));
      ready = { button, slider };
      slider.dataset.swept = "";
      slider.after(more, details.element);
    }
  }

  return {
    show(state, previous, { isWorkedOut }) {
      const isForeign =
        !isOwn && !isWorkedOut && SUBJECT.some((key) => state[key] !== previous?.[key]);
      if (isForeign && previous) {
        rest();
        isTrailing = false;
        trails.clear();
      }
      if (state.sweep?.key !== previous?.sweep?.key) {
        rest();
      }
      show(state.sweep);
    },

    follow() {},

    settle(answer, _, isPresent) {
      // While it runs, what is a moment late is as good.
      if (isPresent || run.isRunning()) {
        trace = answer.trace;
        leaveTrail();
      }
    },

    forget() {},
    pictures: {},
  };
}
