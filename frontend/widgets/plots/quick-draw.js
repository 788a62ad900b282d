// @ts-check

import { barPlaces, differInMarksOnly, linePath, pixelScale } from "../../figures/pixels.js";
import { write } from "../write.js";

/**
 * Moves the marks of a plot to where a new figure has them, if its axes stay. `Plotly.react` works out
 * everything anew and takes five times as long, too much for every step of a drag on a small machine.
 * When the drag is over, Plotly draws what has been moved here, and puts its own house in order.
 *
 * @param {HTMLElement} element drawn by Plotly
 * @param {import("../../figures/plot-area.js").Figure} shown what it shows
 * @param {import("../../figures/plot-area.js").Figure} next
 * @returns {boolean} whether that could be done
 */
export function quickDraw(element, shown, next) {
  if (!differInMarksOnly(shown, next)) {
    return false;
  }
  const drawn = next.data.map(marksOf(element));
  if (!drawn.every((marks, i) => isEnough(marks, next.data[i]))) {
    return false;
  }
  const scale = pixelScale(next.layout);
  for (const [i, marks] of drawn.entries()) {
    if (isSame(shown.data[i], next.data[i])) {
      continue;
    }
    (next.data[i].type === "bar" ? moveBars : moveScatter)(next.data[i], marks, scale);
  }
  return true;
}

/**
 * Whether a trace is drawn from the very arrays that are drawn, as what is pinned is.
 * @param {Record<string, any>} shown
 * @param {Record<string, any>} next
 */
function isSame(shown, next) {
  return next.mode === "lines" && shown.x === next.x && shown.y === next.y;
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
      ? { lines: [], points: all("g.point"), texts: all("g.point > text") }
      : { lines: all(".js-line"), points: all("path.point"), texts: all("g.textpoint") };
  };
}

/**
 * Whether there is one of each kind to begin with, from which more can be made.
 * @param {Marks} marks
 * @param {Record<string, any>} trace
 */
function isEnough({ lines, points, texts }, { mode, text, x }) {
  if (mode === "lines") {
    return lines.length === 1;
  }
  return x.length === 0 || (points.length > 0 && (!text || texts.length === points.length));
}

/**
 * The same marks, fewer or more of them.
 * @param {Element[]} marks
 * @param {number} count
 */
function made(marks, count) {
  for (const mark of marks.slice(count)) {
    mark.remove();
  }
  const copies = Array.from({ length: Math.max(0, count - marks.length) }, () => {
    const copy = /** @type {Element} */ (marks[0].cloneNode(true));
    marks[0].parentElement?.append(copy);
    return copy;
  });
  return [...marks.slice(0, count), ...copies];
}

/**
 * @param {Record<string, any>} trace
 * @param {Marks} marks
 * @param {import("../../figures/pixels.js").PixelScale} scale
 */
function moveBars(trace, { points }, scale) {
  const places = barPlaces(/** @type {any} */ (trace), scale);
  for (const [i, point] of made(points, places.length).entries()) {
    const { path, middle } = places[i];
    const outline = /** @type {SVGPathElement} */ (point.querySelector("path"));
    outline.setAttribute("d", path);
    // The opacity is in the colour here; Plotly keeps the two apart.
    outline.style.fill = trace.marker.color[i];
    outline.style.fillOpacity = "1";
    const text = point.querySelector("text");
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
 * @param {import("../../figures/pixels.js").PixelScale} scale
 */
function moveScatter(trace, { lines, points, texts }, scale) {
  if (trace.mode === "lines") {
    lines[0].setAttribute("d", linePath(/** @type {any} */ (trace), scale));
    return;
  }
  for (const [i, point] of made(points, trace.x.length).entries()) {
    point.setAttribute("transform", `translate(${scale.x(trace.x[i])},${scale.y(trace.y[i])})`);
  }
  for (const [i, group] of made(texts, trace.text ? trace.x.length : 0).entries()) {
    const text = /** @type {Element} */ (group.querySelector("text"));
    text.setAttribute("x", String(scale.x(trace.x[i])));
    text.setAttribute("y", String(scale.y(trace.y[i])));
    write(text, trace.text[i]);
  }
}
