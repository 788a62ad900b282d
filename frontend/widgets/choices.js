// @ts-check

import { find } from "./find.js";

/**
 * Fills a fieldset with one button for each of several choices.
 * @param {HTMLElement} fieldset
 * @param {string} name
 * @param {{id: string, title: string}[]} items
 */
export function choices(fieldset, name, items) {
  fieldset.append(
    ...items.map(({ id, title }) => {
      const label = document.createElement("label");
      const input = document.createElement("input");
      const text = document.createElement("span");
      Object.assign(input, { type: "radio", name, value: id });
      text.textContent = title;
      label.append(input, text);
      return label;
    }),
  );
}

/**
 * Shows which of several choices are made.
 * @param {ParentNode} root
 * @param {Record<string, string>} made by the names of the choices
 */
export function choose(root, made) {
  for (const [name, value] of Object.entries(made)) {
    const choice = find(`[name="${name}"][value="${value}"]`, root);
    /** @type {HTMLInputElement} */ (choice).checked = true;
  }
}

/**
 * Shows whether a map is flat or in depth.
 * @param {ParentNode} root
 * @param {"flat" | "surface"} shape
 */
export function chooseShape(root, shape) {
  /** @type {HTMLInputElement} */ (find('[name="shape"]', root)).checked = shape === "surface";
}

/**
 * Tells what is chosen in an element; its only box to tick is that of a map in depth.
 * @param {HTMLElement} element
 * @param {(patch: Record<string, string>) => void} onOption
 */
export function onChoice(element, onOption) {
  element.addEventListener("change", (event) => {
    const { name, type, value, checked } = /** @type {HTMLInputElement} */ (event.target);
    onOption({ [name]: type !== "checkbox" || checked ? value : "flat" });
  });
}
