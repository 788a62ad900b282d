// @ts-check

import { barPlaces, differInPlacesOnly, linePath, pixelScale } from "../figures/pixels.js";

/**
 * Moves the marks of a plot to where a new figure has them, if that is all that has changed.
 * `Plotly.react` works out everything anew and takes five times as long, too much for every step of
 * a drag on a small machine. When the drag is over, it draws what has been moved here.
 *
 * @param {HTMLElement} element drawn by Plotly
 * @param {import("../figures/plot-area.js").Figure} shown what it shows
 * @param {import("../figures/plot-area.js").Figure} next
 * @returns {boolean} whether that could be done
 */
export function quickDraw(element, shown, next) {
  if (!differInPlacesOnly(shown, next)) {
    return false;
  }
  const drawn = next.data.map(marksOf(element));
  if (!drawn.every((marks, i) => isComplete(marks, next.data[i]))) {
    return false;
  }
  const scale = pixelScale(next.layout);
  for (const [i, marks] of drawn.entries()) {
    (next.data[i].type === "bar" ? moveBars : moveScatter)(next.data[i], marks, scale);
  }
  return true;
}

/**
 * @typedef {object} Marks
 * @property {Element[]} lines
 * @property {Element[]} points
 * @property {Element[]} texts
 */

/**
 * Plotly keeps one group for each trace, in their order, by layers of one type.
 * @param {HTMLElement} element
 * @returns {(trace: Record<string, any>) => Marks}
 */
function marksOf(element) {
  const groups = {
    bar: element.querySelectorAll(".barlayer > .trace"),
    scatter: element.querySelectorAll(".scatterlayer > .trace"),
  };
  const taken = { bar: 0, scatter: 0 };
  return ({ type }) => {
    const kind = type === "bar" ? "bar" : "scatter";
    const group = groups[kind][taken[kind]];
    taken[kind] += 1;
    const all = (/** @type {string} */ selector) => [...(group?.querySelectorAll(selector) ?? [])];
    return kind === "bar"
      ? { lines: [], points: all(".point"), texts: [] }
      : { lines: all(".js-line"), points: all("path.point"), texts: all(".textpoint > text") };
  };
}

/**
 * @param {Marks} marks
 * @param {Record<string, any>} trace
 */
function isComplete({ lines, points, texts }, { type, mode, x }) {
  const single = type === "bar" || mode.includes("markers") ? x.length : 0;
  return (
    lines.length === (mode === "lines" ? 1 : 0) &&
    points.length === single &&
    texts.length === (mode?.includes("text") ? x.length : 0)
  );
}

/**
 * @param {Record<string, any>} trace
 * @param {Marks} marks
 * @param {import("../figures/pixels.js").PixelScale} scale
 */
function moveBars(trace, { points }, scale) {
  const places = barPlaces(/** @type {any} */ (trace), scale);
  for (const [i, { path, middle }] of places.entries()) {
    points[i].querySelector("path")?.setAttribute("d", path);
    const text = points[i].querySelector("text");
    if (text) {
      const place = text.getAttribute("transform") ?? "";
      text.setAttribute("transform", place.replace(/\([^,]*,/, `(${middle},`));
      write(text, trace.text[i]);
    }
  }
}

/**
 * @param {Record<string, any>} trace
 * @param {Marks} marks
 * @param {import("../figures/pixels.js").PixelScale} scale
 */
function moveScatter(trace, { lines, points, texts }, scale) {
  lines[0]?.setAttribute("d", linePath(/** @type {any} */ (trace), scale));
  for (const [i, point] of points.entries()) {
    point.setAttribute("transform", `translate(${scale.x(trace.x[i])},${scale.y(trace.y[i])})`);
  }
  for (const [i, text] of texts.entries()) {
    text.setAttribute("x", String(scale.x(trace.x[i])));
    text.setAttribute("y", String(scale.y(trace.y[i])));
    write(text, trace.text[i]);
  }
}

/**
 * @param {Element} element
 * @param {string} text
 */
function write(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
