// @ts-check

import { currentTheme } from "../widgets/theme.js";
import { filesOf } from "./drawn.js";
import { pictureOf, TITLE_PIXELS } from "./save-picture.js";

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
 * The picture of a panel as files; null while there is none.
 * @param {import("./panel-picture.js").PanelPicture} panel
 * @param {(address: string) => Promise<Blob>} loadFont
 */
export async function savedPicture({ drawn, title, place }, loadFont) {
  const element = drawn();
  const picture =
    element instanceof SVGSVGElement
      ? drawingOf(element, title())
      : await pictureOf(/** @type {HTMLElement} */ (element), { title: title(), place: place() });
  return picture && filesOf(picture, loadFont);
}

/**
 * A drawing of the page itself, on the page's ground and under a title.
 * @param {SVGSVGElement} drawing
 * @param {string} title with markup, of which the drawing keeps the letters
 * @returns {import("./drawn.js").Drawn}
 */
function drawingOf(drawing, title) {
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
  return { svg: new XMLSerializer().serializeToString(frame), size: whole };
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
