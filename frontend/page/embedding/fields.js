// @ts-check

import { make } from "../../widgets/elements.js";

/**
 * Boxes to tick under a name; those that are ticked stay so when they are offered anew.
 * @param {string} name
 */
export function createBoxes(name) {
  const element = make("fieldset", "builder-boxes", make("legend", "", name));
  const list = make("div", "");
  element.append(list);

  /** @returns {HTMLInputElement[]} */
  const boxes = () => [...list.querySelectorAll("input")];
  const ticked = () =>
    boxes()
      .filter((box) => box.checked && !box.closest("[hidden]"))
      .map(({ value }) => value);

  return {
    element,
    /** The values of those that are ticked, in their order. */
    ticked,

    /** @param {{value: string, label: HTMLElement[]}[]} items */
    offer(items) {
      const before = ticked();
      list.replaceChildren(
        ...items.map(({ value, label }) => {
          const box = Object.assign(make("input", ""), { type: "checkbox", value });
          box.checked = before.includes(value);
          return make("label", "", box, ...label);
        }),
      );
    },

    /** @param {string[]} values */
    tick(values) {
      boxes().forEach((box) => (box.checked = values.includes(box.value)));
    },

    /**
     * @param {string} value
     * @param {boolean} isThere
     */
    show(value, isThere) {
      const box = boxes().find((each) => each.value === value);
      box?.closest("label")?.toggleAttribute("hidden", !isThere);
    },
  };
}

/**
 * One of several, by a name.
 * @param {string} name
 * @param {[string, string][]} items value and text of each
 */
export function createSelect(name, items) {
  const field = make("select", "", ...items.map(([value, text]) => new Option(text, value)));
  return { field, label: make("label", "", name, field) };
}

/**
 * A whole number within bounds, by a name.
 * @param {string} name
 * @param {{least: number, most: number, usual: number}} bounds
 */
export function createSize(name, { least, most, usual }) {
  const field = Object.assign(make("input", ""), { type: "number", min: least, max: most });
  const put = (/** @type {number} */ value) => {
    field.value = String(Math.min(most, Math.max(least, Math.round(value))));
  };
  put(usual);
  field.addEventListener("change", () => put(field.valueAsNumber || usual));
  return { field, label: make("label", "", name, field), put, value: () => field.valueAsNumber };
}
