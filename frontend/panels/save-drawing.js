// @ts-check

import { download } from "./download.js";
import { BITMAP_SCALE, TITLE_PIXELS } from "./save-picture.js";
import { currentTheme } from "./theme.js";

/** What a style sheet gives a drawing; outside the page it has to carry it along. */
const CARRIED = [
  "fill",
  "stroke",
  "stroke-width",
  "stroke-linecap",
  "stroke-linejoin",
  "font-family",
  "font-size",
  "font-style",
  "visibility",
  "display",
];

/**
 * Saves a drawing of the page itself, on the page's ground and under a title.
 * @param {SVGSVGElement} drawing
 * @param {object} options
 * @param {"png" | "svg"} options.format
 * @param {string} options.title with markup, of which the drawing keeps the letters
 * @param {string} options.fileName
 */
export async function saveDrawing(drawing, { format, title, fileName }) {
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
  const picture = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(frame))}`;
  download(format === "svg" ? picture : await bitmapOf(picture, whole), fileName);
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

/**
 * @param {string} picture
 * @param {{width: number, height: number}} size
 */
async function bitmapOf(picture, { width, height }) {
  const image = new Image();
  image.src = picture;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = BITMAP_SCALE * width;
  canvas.height = BITMAP_SCALE * height;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL("image/png");
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
