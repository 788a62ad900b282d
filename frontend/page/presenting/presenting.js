// @ts-check

import { say } from "../../format/words.js";
import { isPresented, PRESENTED, presentedIn } from "../../state/scenes.js";
import { told } from "../../widgets/elements.js";
import { byTestId } from "../../widgets/find.js";

/** @typedef {import("../../state/address/options.js").PageState} PageState */

/** So long, in ms, after the last movement of the hand the controls stay. */
const STAY = 3000;

/** The keys of a clicker, and those of a keyboard that do the same where nothing else has them. */
const STEPS = new Map([
  ["PageDown", 1],
  ["ArrowRight", 1],
  ["PageUp", -1],
  ["ArrowLeft", -1],
]);

/**
 * The page on a projector: large type, the pictures picked, controls that fade, and a clicker that
 * walks the lesson and the presets.
 * @param {import("../../scenes/scene.js").Page} page
 * @returns {import("../../scenes/scene.js").Scene}
 */
export function mountPresenting({ present, set }) {
  const root = document.documentElement;
  const tools = byTestId("presenting-tools");
  const pickers = /** @type {const} */ (["left", "right"]).map(picker);
  let isOn = false;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const turns = /** @type {const} */ ([
    [-1, "‹", "previous"],
    [1, "›", "next"],
  ]).map(([by, mark, name]) => {
    const turn = told("button", "quiet", mark);
    turn.dataset.testid = `presenting-${name}`;
    turn.setAttribute("aria-label", say(`presenting.${name}`));
    turn.title = say(`presenting.${name}`);
    turn.addEventListener("click", () => walk(by));
    return turn;
  });
  const end = told("button", "quiet", say("presenting.end"));
  end.dataset.testid = "presenting-end";
  end.title = say("presenting.endKey");
  end.addEventListener("click", leave);
  tools.append(...turns, ...pickers.map(({ label }) => label), end);
  tools.setAttribute("aria-label", say("presenting.tools"));
  document.addEventListener("fullscreenchange", () => {
    if (!document.fullscreenElement) {
      leave();
    }
  });
  addEventListener("keydown", onKey);
  for (const kind of ["pointermove", "pointerdown", "keydown"]) {
    addEventListener(kind, wake, { passive: true });
  }

  function leave() {
    if (isOn) {
      set({ presenting: "off" });
    }
  }

  /** @param {KeyboardEvent} event */
  function onKey(event) {
    if (!isOn || event.ctrlKey || event.metaKey || event.altKey) {
      return;
    }
    const isHeld = /** @type {Element} */ (event.target).matches?.("input, select, textarea");
    const by = STEPS.get(event.key);
    if (event.key === "Escape") {
      leave();
    } else if (by && (event.key.startsWith("Page") || !isHeld)) {
      event.preventDefault();
      walk(by);
    }
  }

  /** On or back: in the lesson by a step, of which a covered one is uncovered first; else by a preset. @param {number} by */
  function walk(by) {
    if (present().scene === "lesson") {
      const isCovered = by > 0 && root.hasAttribute("data-glass");
      const turn = by > 0 ? "lesson-next" : "lesson-previous";
      byTestId(isCovered ? "predict-anyway" : turn).click();
      return;
    }
    const presets = [
      .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-preset]")),
    ];
    const at = presets.findIndex((preset) => preset.ariaPressed === "true");
    const first = by > 0 ? 0 : presets.length - 1;
    presets.at(at < 0 ? first : (at + by) % presets.length)?.click();
  }

  /** The controls are there while somebody moves. */
  function wake() {
    clearTimeout(timer);
    root.removeAttribute("data-idle");
    if (isOn) {
      timer = setTimeout(() => root.toggleAttribute("data-idle", true), STAY);
    }
  }

  /** @param {"left" | "right"} side */
  function picker(side) {
    const select = document.createElement("select");
    select.dataset.testid = `presenting-${side}`;
    select.append(...PRESENTED.map((name) => new Option(say(`presenting.views.${name}`), name)));
    select.addEventListener("change", () => set({ [side]: select.value }));
    const label = told("label", "", say(`presenting.${side}`));
    label.append(select);
    return { side, select, label };
  }

  /** @param {PageState} state */
  function pick(state) {
    const picked = presentedIn(state);
    for (const panel of document.querySelectorAll("[data-panel]")) {
      const at = picked.indexOf(panel.getAttribute("data-panel") ?? "");
      panel.removeAttribute("data-picked");
      if (isOn && at >= 0) {
        panel.setAttribute("data-picked", at === 0 ? "left" : "right");
      }
    }
    root.toggleAttribute("data-alone", isOn && picked.length === 1);
    for (const { side, select, label } of pickers) {
      select.value = state[side];
      label.hidden = state.scene === "lesson";
    }
  }

  return {
    show(state) {
      const wasOn = isOn;
      isOn = isPresented(state);
      tools.hidden = !isOn;
      if (isOn || wasOn) {
        pick(state);
      }
      if (isOn !== wasOn) {
        root.toggleAttribute("data-presenting", isOn);
        wake();
      }
      if (!isOn && document.fullscreenElement) {
        document.exitFullscreen();
      }
    },
    follow() {},
    forget() {},
    pictures: {},
  };
}
