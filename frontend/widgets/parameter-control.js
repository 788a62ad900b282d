// @ts-check

import { brief, typable } from "../format/number.js";
import { PLAIN_SYMBOLS, SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import { SLIDER_STEPS, sliderStep, valueAtStep } from "../state/parameters.js";
import { find } from "./find.js";
import { createNumberField } from "./number-field.js";
import { nameSweepButton } from "./sweep-buttons.js";

/**
 * A slider with its play button, a number field and a reset for one parameter.
 * @param {HTMLElement} parent
 * @param {Omit<import("../state/parameters.js").Parameter, "key" | "initial"> & {key: keyof typeof PLAIN_SYMBOLS}} parameter
 * @param {(value: number | null, change: import("../state/store.js").Change) => void} onChange told null where a reset has it worked out of the others
 */
export function mountParameterControl(parent, parameter, onChange) {
  const template = /** @type {HTMLTemplateElement} */ (find("#parameter-control"));
  const fragment = /** @type {DocumentFragment} */ (template.content.cloneNode(true));
  const root = find(".parameter", fragment);
  const slider = /** @type {HTMLInputElement} */ (find(".parameter-slider", root));
  const field = /** @type {HTMLInputElement} */ (find(".parameter-field", root));
  const sweep = /** @type {HTMLButtonElement} */ (find(".sweep-play", root));
  const reset = /** @type {HTMLButtonElement} */ (find(".parameter-reset", root));
  const problem = find(".parameter-problem", root);
  const hook = parameter.key.replaceAll("_", "-");
  const plainSymbol = PLAIN_SYMBOLS[parameter.key];
  const bare = say(`parameters.${parameter.key}`);
  const name = parameter.unit ? `${bare}, ${parameter.unit}` : bare;
  /** What a reset goes back to. @type {number | null | undefined} */
  let usual;
  const number = createNumberField(field, problem, parameter, onChange);

  root.dataset.parameter = hook;
  find("label", root).setAttribute("for", `${hook}-field`);
  find(".parameter-symbol", root).innerHTML = SYMBOLS[parameter.key];
  find(".parameter-name", root).textContent = name;
  field.id = `${hook}-field`;
  field.dataset.testid = `${hook}-field`;
  problem.id = `${hook}-problem`;
  problem.dataset.testid = `${hook}-problem`;
  field.setAttribute("aria-describedby", problem.id);
  slider.dataset.testid = `${hook}-slider`;
  slider.setAttribute("aria-label", `${plainSymbol}, ${name}`);
  slider.max = String(SLIDER_STEPS);
  sweep.dataset.testid = `${hook}-sweep`;
  nameSweepButton(sweep, parameter.key, plainSymbol);
  reset.dataset.testid = `${hook}-reset`;
  find(".parameter-ticks", root).append(...ticks(parameter));

  slider.addEventListener("input", (event) => {
    onChange(valueAtStep(parameter, slider.valueAsNumber), {
      dragging: true,
      inputTimeStamp: event.timeStamp,
    });
  });
  slider.addEventListener("change", (event) => {
    onChange(number.present(), { dragging: false, inputTimeStamp: event.timeStamp });
  });
  reset.addEventListener("click", (event) => {
    onChange(usual ?? null, { dragging: false, inputTimeStamp: event.timeStamp });
    // The button has done its work and gives the focus up; a finger wants no keyboard on the screen.
    if (event.detail === 0) {
      field.focus();
    }
  });

  parent.append(root);
  return {
    /**
     * @param {number} value
     * @param {number | null} initial what a reset goes back to; null is worked out of the others
     * @param {boolean} [isWorkedOut] whether the value is
     */
    show(value, initial, isWorkedOut = false) {
      root.toggleAttribute("data-worked-out", isWorkedOut);
      if (initial !== usual) {
        usual = initial;
        const there = usual === null ? "bodies" : "value";
        const values = { symbol: plainSymbol, value: typable(usual ?? 0) };
        reset.setAttribute("aria-label", say(`controls.reset.${there}`, values));
        reset.title = say(`controls.back.${there}`, values);
      }
      slider.valueAsNumber = sliderStep(parameter, value);
      slider.setAttribute(
        "aria-valuetext",
        isWorkedOut ? say("controls.workedOut", { value: typable(value) }) : typable(value),
      );
      const inUnits = parameter.unit ? say("controls.inUnits", { unit: parameter.unit }) : "";
      field.title = isWorkedOut ? say("controls.ofBodies") : inUnits;
      number.show(value, isWorkedOut);
      reset.disabled = number.present() === usual;
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
