// @ts-check

import { find } from "../../widgets/find.js";

/** A curve drawn by hand over a line at zero. @param {string} path */
export function sketchOf(path) {
  const template = /** @type {HTMLTemplateElement} */ (find("#sketch"));
  const sketch = /** @type {Element} */ (template.content.firstElementChild?.cloneNode(true));
  find(".sketch-curve", sketch).setAttribute("d", path);
  return sketch;
}
