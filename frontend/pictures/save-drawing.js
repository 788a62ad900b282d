// @ts-check

import { currentTheme } from "../widgets/theme.js";
import { downloadDrawn } from "./drawn.js";
import { TITLE_PIXELS } from "./save-picture.js";

export { savePicture } from "./save-picture.js";

/** What a style sheet gives a drawing; outside the page it has to carry it along. */
const CARRIED = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-linecap",
  "stroke-linejoin",
  "stroke-dasharray",
  "paint-order",
  "opacity",
  "font-family",
  "font-size",
  "font-style",
  "visibility",
  "display",
];

/**
 * Saves a drawing of the page itself, on the page's ground and under a title.
 * @param {SVGSVGElement} drawing
 * @param {import("./drawn.js").Saving & {title: string}} options with markup in the title, of which the drawing keeps the letters
 */
export async function saveDrawing(drawing, { title, ...options }) {
  const { paper, ink, sans } = currentTheme();
  const { width, height } = drawing.viewBox.baseVal;
  const whole = { width, height: height + TITLE_PIXELS };
  const copy = /** @type {SVGSVGElement} */ (drawing.cloneNode(true));
  carryStyle(drawing, copy);
  copy.setAttribute("y", String(TITLE_PIXELS));
  copy.setAttribute("width", String(width));
  copy.setAttribute("height", String(height));
  const elementOf = maker(drawing.namespaceURI);
  const frame = elementOf("svg", {
    viewBox: `0 0 ${whole.width} ${whole.height}`,
    width: String(whole.width),
    height: String(whole.height),
  });
  const ground = elementOf("rect", { width: "100%", height: "100%", fill: paper });
  const line = elementOf("text", {
    x: "8",
    y: "22",
    fill: ink,
    "font-family": sans,
    "font-size": "13",
  });
  line.textContent = title.replaceAll("<sub>", "_").replace(/<[^>]*>/g, "");
  frame.append(ground, line, copy);
  await downloadDrawn(new XMLSerializer().serializeToString(frame), whole, options);
}

/**
 * @param {Element} from
 * @param {Element} to its copy
 */
function carryStyle(from, to) {
  const style = getComputedStyle(from);
  for (const name of CARRIED) {
    to.setAttribute(name, style.getPropertyValue(name));
  }
  for (const [i, child] of [...from.children].entries()) {
    carryStyle(child, to.children[i]);
  }
}

/** @param {string | null} namespace */
function maker(namespace) {
  return (/** @type {string} */ name, /** @type {Record<string, string>} */ attributes) => {
    const element = document.createElementNS(namespace, name);
    for (const [key, value] of Object.entries(attributes)) {
      element.setAttribute(key, value);
    }
    return element;
  };
}
