// @ts-check

import { brief, typable } from "../format/number.js";
import { PLAIN_SYMBOLS, SYMBOLS } from "../format/symbols.js";
import { parseParameter, SLIDER_STEPS, sliderStep, valueAtStep } from "../state/parameters.js";
import { find } from "./find.js";

/** After so many ms without a key, a number is taken for typed. */
const TYPING_PAUSE = 600;

/**
 * A slider, a number field and a reset for one parameter.
 * @param {HTMLElement} parent
 * @param {Omit<import("../state/parameters.js").Parameter, "key" | "initial"> & {key: keyof typeof PLAIN_SYMBOLS}} parameter
 * @param {(value: number, change: {dragging: boolean, inputTimeStamp: number}) => void} onChange
 */
export function mountParameterControl(parent, parameter, onChange) {
  const template = /** @type {HTMLTemplateElement} */ (find("#parameter-control"));
  const fragment = /** @type {DocumentFragment} */ (template.content.cloneNode(true));
  const root = find(".parameter", fragment);
  const slider = /** @type {HTMLInputElement} */ (find(".parameter-slider", root));
  const field = /** @type {HTMLInputElement} */ (find(".parameter-field", root));
  const reset = /** @type {HTMLButtonElement} */ (find(".parameter-reset", root));
  const problem = find(".parameter-problem", root);
  const hook = parameter.key.replaceAll("_", "-");
  const plainSymbol = PLAIN_SYMBOLS[parameter.key];
  let value = NaN;
  /** What a reset goes back to. */
  let usual = NaN;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;

  root.dataset.parameter = hook;
  find("label", root).setAttribute("for", `${hook}-field`);
  find(".parameter-symbol", root).innerHTML = SYMBOLS[parameter.key];
  find(".parameter-name", root).textContent = parameter.name;
  field.id = `${hook}-field`;
  field.dataset.testid = `${hook}-field`;
  problem.id = `${hook}-problem`;
  problem.dataset.testid = `${hook}-problem`;
  field.setAttribute("aria-describedby", problem.id);
  slider.dataset.testid = `${hook}-slider`;
  slider.setAttribute("aria-label", `${plainSymbol}, ${parameter.name}`);
  slider.max = String(SLIDER_STEPS);
  reset.dataset.testid = `${hook}-reset`;
  find(".parameter-ticks", root).append(...ticks(parameter));

  slider.addEventListener("input", (event) => {
    onChange(valueAtStep(parameter, slider.valueAsNumber), {
      dragging: true,
      inputTimeStamp: event.timeStamp,
    });
  });
  slider.addEventListener("change", (event) => {
    onChange(value, { dragging: false, inputTimeStamp: event.timeStamp });
  });
  field.addEventListener("input", (event) => {
    const typed = parseParameter(parameter, field.value);
    tellProblem(typed === null);
    clearTimeout(pause);
    if (typed !== null) {
      onChange(typed, { dragging: true, inputTimeStamp: event.timeStamp });
      pause = setTimeout(settle, TYPING_PAUSE);
    }
  });
  field.addEventListener("change", settle);
  field.addEventListener("blur", () => {
    tellProblem(false);
    field.value = typable(value);
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
      field.value = typable(value);
      tellProblem(false);
    }
  });
  reset.addEventListener("click", (event) => {
    onChange(usual, { dragging: false, inputTimeStamp: event.timeStamp });
    // The button has done its work and gives the focus up; a finger wants no keyboard on the screen.
    if (event.detail === 0) {
      field.focus();
    }
  });

  /** What was typed stands: it need not be left for that. */
  function settle() {
    clearTimeout(pause);
    onChange(value, { dragging: false, inputTimeStamp: performance.now() });
  }

  /** @param {boolean} wrong */
  function tellProblem(wrong) {
    field.setAttribute("aria-invalid", String(wrong));
    problem.textContent = wrong ? `${plainSymbol} must be ${parameter.requirement}` : "";
  }

  parent.append(root);
  return {
    /**
     * @param {number} next
     * @param {number} initial what a reset goes back to
     */
    show(next, initial) {
      value = next;
      if (initial !== usual) {
        usual = initial;
        reset.setAttribute("aria-label", `Reset ${plainSymbol} to ${typable(usual)}`);
        reset.title = `Back to ${typable(usual)}`;
      }
      slider.valueAsNumber = sliderStep(parameter, value);
      slider.setAttribute("aria-valuetext", typable(value));
      reset.disabled = value === usual;
      if (document.activeElement !== field) {
        field.value = typable(value);
        tellProblem(false);
      }
    },
    unmount() {
      clearTimeout(pause);
      root.remove();
    },
  };
}

/** @param {Pick<import("../state/parameters.js").Parameter, "ticks" | "scale">} parameter */
function ticks(parameter) {
  return parameter.ticks.map((tick) => {
    const mark = document.createElement("span");
    mark.textContent = brief(tick);
    mark.style.setProperty("--share", String(parameter.scale.toShare(tick)));
    return mark;
  });
}
