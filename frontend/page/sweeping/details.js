// @ts-check

import { typable } from "../../format/number.js";
import { say } from "../../format/words.js";
import { between } from "../../state/requirements.js";
import { sweptBy } from "../../state/sweep.js";
import { make, told } from "../../widgets/elements.js";
import { createNumberField } from "../../widgets/number-field.js";

/** @typedef {import("../../state/sweep.js").Sweep} Sweep */

/** There and back, in seconds; an address may say others. */
const SECONDS = [4, 8, 16, 32];

/** Between the button and what it opens, in pixels. */
const GAP = 6;

/**
 * Range, time and how often, in a card that is made when it is first asked for.
 * @param {HTMLButtonElement} opener
 * @param {object} handlers
 * @param {(sweep: Sweep, change: import("../../state/store.js").Change) => void} handlers.onChange
 * @param {() => void} handlers.onAway
 */
export function createDetails(opener, { onChange, onAway }) {
  const element = make("div", "sweep-details");
  /** @type {Sweep | null} */
  let shown = null;
  let symbol = "";
  let filled = "";
  /** @type {(sweep: Sweep) => void} */
  let showSweep = () => {};
  element.popover = "auto";
  element.dataset.testid = "sweep-details";
  element.setAttribute("role", "group");
  opener.popoverTargetElement = element;
  opener.ariaExpanded = "false";

  element.addEventListener("beforetoggle", (event) => {
    if (/** @type {ToggleEvent} */ (event).newState === "open" && shown) {
      fill(shown);
    }
  });
  element.addEventListener("toggle", (event) => {
    const isOpen = /** @type {ToggleEvent} */ (event).newState === "open";
    opener.ariaExpanded = String(isOpen);
    if (isOpen) {
      place();
    }
  });
  // It closes the card alone, not what is presented.
  element.addEventListener("keydown", (event) => {
    if (event.key === "Escape") {
      event.stopPropagation();
    }
  });

  /** Over the sliders rather than the pictures, as far as the window goes. */
  function place() {
    const { right, top, bottom } = opener.getBoundingClientRect();
    const { width, height } = element.getBoundingClientRect();
    const isRoom = bottom + GAP + height <= innerHeight;
    element.style.left = `${Math.max(GAP, right - width)}px`;
    element.style.top = `${Math.max(GAP, isRoom ? bottom + GAP : top - GAP - height)}px`;
  }

  /** @param {Sweep} sweep */
  function fill(sweep) {
    if (filled === sweep.key) {
      return;
    }
    filled = sweep.key;
    const problem = make("p", "parameter-problem");
    problem.setAttribute("role", "alert");
    const from = end("from", "to", problem);
    const to = end("to", "from", problem);
    const seconds = make("select", "");
    const loop = make("input", "");
    const away = told("button", "quiet", say("sweep.away"));
    seconds.dataset.testid = "sweep-seconds";
    seconds.addEventListener("change", () => change({ seconds: Number(seconds.value) }));
    loop.type = "checkbox";
    loop.dataset.testid = "sweep-loop";
    loop.addEventListener("change", () => change({ once: !loop.checked }));
    away.type = "button";
    away.dataset.testid = "sweep-away";
    away.addEventListener("click", () => {
      element.hidePopover();
      onAway();
    });
    element.replaceChildren(
      told("p", "sweep-subject", say("sweep.details", { symbol })),
      make("div", "sweep-range", from.label, to.label),
      problem,
      labelled(say("sweep.time"), seconds),
      make("label", "", loop, say("sweep.loop")),
      away,
    );
    showSweep = (next) => {
      from.show(next.from);
      to.show(next.to);
      const offered = [...new Set([...SECONDS, next.seconds])].sort((a, b) => a - b);
      seconds.replaceChildren(
        ...offered.map(
          (each) => new Option(say("sweep.seconds", { seconds: typable(each) }), `${each}`),
        ),
      );
      seconds.value = String(next.seconds);
      loop.checked = !next.once;
    };
    showSweep(sweep);
  }

  /**
   * One end of the range.
   * @param {"from" | "to"} name
   * @param {"from" | "to"} other
   * @param {HTMLElement} problem
   */
  function end(name, other, problem) {
    const parameter = /** @type {any} */ (sweptBy(filled));
    const { min, max } = parameter.scale;
    const field = make("input", "parameter-field");
    const words = say(`sweep.${name}`);
    field.inputMode = "decimal";
    field.autocomplete = "off";
    field.dataset.testid = `sweep-${name}`;
    const number = createNumberField(
      field,
      problem,
      {
        ...parameter,
        symbol: words,
        admits: (value) => value >= min && value <= max && value !== shown?.[other],
        requirement: between(min, max),
      },
      (value, how) => change({ [name]: value ?? min }, how),
    );
    return {
      label: labelled(words, field),
      show: (/** @type {number} */ value) => number.show(value, false),
    };
  }

  /**
   * @param {Partial<Sweep>} patch
   * @param {import("../../state/store.js").Change} [how]
   */
  function change(patch, how = { dragging: false, inputTimeStamp: performance.now() }) {
    if (shown) {
      onChange({ ...shown, ...patch }, how);
    }
  }

  return {
    element,

    /** @param {Sweep} sweep @param {string} its the symbol of its parameter */
    show(sweep, its) {
      shown = sweep;
      symbol = its;
      const name = say("sweep.details", { symbol });
      opener.setAttribute("aria-label", name);
      opener.title = name;
      element.setAttribute("aria-label", name);
      if (filled === sweep.key) {
        showSweep(sweep);
      }
    },
  };
}

/** @param {string} words @param {HTMLElement} control */
function labelled(words, control) {
  return make("label", "", make("span", "", words), control);
}
