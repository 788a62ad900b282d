// @ts-check

import { typable } from "../format/number.js";
import { PLAIN_SYMBOLS } from "../format/symbols.js";
import { decimalMark, say, shortened } from "../format/words.js";
import { parseTyped, SLIDER_STEPS, sliderStep, valueAtStep } from "../state/parameters.js";
import { misfit } from "../state/requirements.js";

/** After so many ms without a key, a number is taken for typed. */
const TYPING_PAUSE = 600;

/** So many characters stand in a field in the usual type. */
const USUAL_LENGTH = 7;

/**
 * A field that takes a number as people write it. What is plainly one counts while it is typed; all else,
 * with units, powers and marks between thousands, is read when typing pauses. What might be two numbers is
 * asked about, and until that is answered, what was before holds.
 * @param {HTMLInputElement} field
 * @param {HTMLElement} problem where it is said what is wrong
 * @param {Omit<import("../state/parameters.js").Parameter, "key" | "initial"> & {key: keyof typeof PLAIN_SYMBOLS, symbol?: string}} parameter with what it is called where that is not its symbol
 * @param {(value: number | null, change: import("../state/store.js").Change) => void} onChange told null for what is worked out of the others
 */
export function createNumberField(field, problem, parameter, onChange) {
  const { admits, unit } = parameter;
  const requirement = parameter.requirement();
  const symbol = parameter.symbol ?? PLAIN_SYMBOLS[parameter.key];
  const unmet = misfit(symbol, requirement, "");
  const name = say(`parameters.${parameter.key}`);
  const subject = unit ? say("fields.subject", { name }) : symbol;
  let value = NaN;
  let isWorkedOut = false;
  /** What was before anything was typed. @type {number | null} */
  let before = null;
  /** The text that is being read or asked about: it is left as it stands. @type {string | null} */
  let open = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;

  field.addEventListener("focus", () => {
    before = open === null ? present() : before;
  });
  field.addEventListener("input", (event) => {
    const typed = parseTyped(field.value, decimalMark());
    const isAllowed = typed !== null && admits(typed);
    open = null;
    tell(typed === null || isAllowed ? "" : unmet);
    if (isAllowed) {
      onChange(typed, { dragging: true, inputTimeStamp: event.timeStamp });
    }
    clearTimeout(pause);
    pause = setTimeout(settle, TYPING_PAUSE);
  });
  field.addEventListener("change", () => settle({ isDone: true }));
  // What was wrong with it is still to be read when the field is left.
  field.addEventListener("blur", () => {
    if (open === null) {
      write();
    }
  });
  field.addEventListener("keydown", (event) => {
    const direction = { ArrowUp: 1, ArrowDown: -1 }[event.key];
    if (direction) {
      event.preventDefault();
      const step = sliderStep(parameter, value) + direction * (event.shiftKey ? 10 : 1);
      onChange(valueAtStep(parameter, Math.min(SLIDER_STEPS, Math.max(0, step))), {
        dragging: false,
        inputTimeStamp: event.timeStamp,
      });
      restore();
    }
  });
  for (const element of [field, problem]) {
    element.addEventListener("keydown", (event) => {
      if (event.key === "Escape" && open !== null) {
        restore();
        field.focus();
      }
    });
  }

  /** What was typed stands: it need not be left for that. */
  async function settle({ isDone = false } = {}) {
    clearTimeout(pause);
    const text = field.value;
    if (text === open) {
      return;
    }
    const typed = parseTyped(text, decimalMark());
    if (text === typable(value) || typed !== null) {
      change(present());
      tell(typed === null || admits(typed) ? "" : unmet);
      return;
    }
    open = text;
    const reading = await import("../format/written.js")
      .then(({ readWritten }) => readWritten(text, { subject, unit }))
      .catch(() => ({ refusal: say("fields.unread", { text: shortened(text) }) }));
    // Typed on, or set by other means.
    if (open !== text) {
      return;
    }
    if ("readings" in reading) {
      ask(text, reading.readings);
    } else {
      take(reading, text);
      if (isDone || document.activeElement !== field) {
        write();
      }
    }
  }

  /**
   * @param {{value: number} | {refusal: string}} reading
   * @param {string} text that was read
   */
  function take(reading, text) {
    open = null;
    if ("refusal" in reading) {
      tell(reading.refusal || misfit(symbol, requirement, text));
    } else if (admits(reading.value)) {
      tell("");
      change(reading.value);
    } else {
      tell(unmet);
    }
  }

  /**
   * @param {string} text
   * @param {{text: string, value: number}[]} readings
   */
  function ask(text, readings) {
    if (present() !== before) {
      change(before);
    }
    tell("");
    open = text;
    field.value = text;
    problem.dataset.asks = "";
    problem.append(
      say("fields.which", { text: shortened(text) }),
      ...readings.map((reading) => {
        const button = document.createElement("button");
        button.type = "button";
        button.className = "chip";
        button.textContent = reading.text;
        button.addEventListener("click", (event) => {
          take(reading, text);
          write();
          // A finger wants no keyboard on the screen.
          if (event.detail === 0) {
            field.focus();
          }
        });
        return button;
      }),
    );
  }

  /** @param {number | null} next */
  function change(next) {
    onChange(next, { dragging: false, inputTimeStamp: performance.now() });
  }

  function present() {
    return isWorkedOut ? null : value;
  }

  function write() {
    field.value = typable(value);
    field.toggleAttribute("data-long", field.value.length > USUAL_LENGTH);
  }

  function restore() {
    open = null;
    tell("");
    write();
  }

  /** @param {string} words */
  function tell(words) {
    field.setAttribute("aria-invalid", String(words !== ""));
    problem.textContent = words;
    delete problem.dataset.asks;
  }

  return {
    present,

    /**
     * @param {number} next
     * @param {boolean} isOfOthers whether it is worked out of the others
     */
    show(next, isOfOthers) {
      if (next !== value || isOfOthers !== isWorkedOut) {
        open = null;
      }
      value = next;
      isWorkedOut = isOfOthers;
      if (open === null && document.activeElement !== field) {
        restore();
      }
    },
  };
}
