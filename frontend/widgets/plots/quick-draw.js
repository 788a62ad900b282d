// @ts-check

import { heatPixels, heatPlace } from "../../figures/heat-image.js";
import { barPlaces, differInMarksOnly, linePath, pixelScale } from "../../figures/pixels.js";
import { write } from "../write.js";

/**
 * Moves the marks of a plot to where a new figure has them, if its axes stay. `Plotly.react` works out
 * everything anew and takes five times as long, too much for every step of a drag on a small machine.
 * When the drag is over, Plotly draws what has been moved here, and puts its own house in order.
 *
 * @typedef {import("../../figures/plot-area.js").Figure} Figure
 *
 * @param {HTMLElement} element
 * @param {Figure} drawn what Plotly has drawn there
 * @param {Figure} shown what it shows since
 * @param {Figure} next
 * @returns {boolean} whether that could be done
 */
export function quickDraw(element, drawn, shown, next) {
  if (!differInMarksOnly(shown, next)) {
    return false;
  }
  const all = drawn.data.map(marksOf(element));
  if (!all.every((marks, i) => isEnough(marks, next.data[i]))) {
    return false;
  }
  const scale = pixelScale(next.layout);
  const ticks = (/** @type {Figure} */ { layout: { xaxis, yaxis } }) =>
    JSON.stringify(
      [xaxis, yaxis].map(({ range, tickvals, ticktext }) => [range, tickvals, ticktext]),
    );
  const isMoved = ticks(shown) !== ticks(next);
  if (isMoved) {
    moveTicks(element, "x", next.layout, scale);
    moveTicks(element, "y", next.layout, scale);
  }
  for (const [i, marks] of all.entries()) {
    if (isMoved || !isSame(shown.data[i], next.data[i])) {
      MOVES[kindOf(next.data[i])](next.data[i], marks, scale);
    }
  }
  return true;
}

/**
 * Moves the ticks of an axis that are within its range, with their words.
 * @param {HTMLElement} element
 * @param {"x" | "y"} name
 * @param {Figure["layout"]} layout
 * @param {import("../../figures/pixels.js").PixelScale} scale
 */
function moveTicks(element, name, layout, scale) {
  const { range, tickvals, ticktext } = layout[`${name}axis`];
  const shown = [...tickvals.keys()].filter(
    (i) => tickvals[i] >= range[0] && tickvals[i] <= range[1],
  );
  const all = (/** @type {string} */ marks) =>
    element.querySelectorAll(`.${name}axislayer-above > ${marks}`);
  for (const marks of [all(`path.${name}tick`), all(`g.${name}tick > text`)]) {
    for (const [i, mark] of marks.entries()) {
      const place = scale[name](tickvals[shown[i]]);
      const { l, t } = layout.margin;
      const moved = name === "x" ? `${l + place},0` : `0,${t + place}`;
      mark.setAttribute("transform", `translate(${moved})`);
    }
  }
  for (const [i, mark] of all(`g.${name}tick > text`).entries()) {
    write(mark, ticktext[shown[i]]);
  }
}

/**
 * Whether a trace is drawn from the very arrays that are drawn, as what is pinned is.
 * @param {Record<string, any>} shown
 * @param {Record<string, any>} next
 */
function isSame(shown, next) {
  return next.mode === "lines" && shown.x === next.x && shown.y === next.y;
}

/** @typedef {"bar" | "heatmap" | "scatter"} Kind */

/** @param {Record<string, any>} trace @returns {Kind} */
function kindOf({ type }) {
  return type === "bar" || type === "heatmap" ? type : "scatter";
}

/**
 * @typedef {object} Marks
 * @property {Element[]} lines
 * @property {Element[]} points
 * @property {Element[]} texts
 */

/** Where Plotly has the marks of a trace, from its group on. */
const SELECTORS = {
  bar: { traces: ".barlayer > .trace", points: "g.point", texts: "g.point > text" },
  heatmap: { traces: ".heatmaplayer > .hm", points: "image" },
  scatter: {
    traces: ".scatterlayer > .trace",
    lines: ".js-line",
    points: "path.point",
    texts: "g.textpoint",
  },
};

/**
 * Plotly keeps one group for each trace, in their order, by layers of one type; none for one that was
 * empty when it was drawn.
 * @param {HTMLElement} element
 * @returns {(trace: Record<string, any>) => Marks}
 */
function marksOf(element) {
  const all = (/** @type {Kind} */ kind) => element.querySelectorAll(SELECTORS[kind].traces);
  const groups = { bar: all("bar"), heatmap: all("heatmap"), scatter: all("scatter") };
  const taken = { bar: 0, heatmap: 0, scatter: 0 };
  return (trace) => {
    const kind = kindOf(trace);
    /** @type {{lines?: string, points: string, texts?: string}} */
    const { lines, points, texts } = SELECTORS[kind];
    const isThere = kind === "heatmap" || trace.x.length > 0;
    const group = isThere ? groups[kind][taken[kind]] : undefined;
    taken[kind] += isThere ? 1 : 0;
    const marks = (/** @type {string | undefined} */ selector) =>
      group && selector ? [...group.querySelectorAll(selector)] : [];
    return { lines: marks(lines), points: marks(points), texts: marks(texts) };
  };
}

/**
 * Whether there is one of each kind to begin with, from which more can be made.
 * @param {Marks} marks
 * @param {Record<string, any>} trace
 */
function isEnough({ lines, points, texts }, { type, mode, text, x, zsmooth }) {
  if (type === "heatmap") {
    // Without smoothing, a browser that cannot show the pixels of an image as squares is given larger ones.
    const image = /** @type {SVGImageElement | undefined} */ (points[0]);
    return image !== undefined && (zsmooth || image.style.imageRendering !== "");
  }
  if (mode === "lines") {
    return lines.length > 0;
  }
  return x.length === 0 || (points.length > 0 && (!text || texts.length > 0));
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
function moveBars(trace, { points, texts }, scale) {
  // Plotly leaves out the word of a bar that is narrower than its pixels.
  const [word] = texts;
  const places = barPlaces(/** @type {any} */ (trace), scale);
  for (const [i, point] of made(points, places.length).entries()) {
    const { path, middle } = places[i];
    const outline = /** @type {SVGPathElement} */ (point.querySelector("path"));
    outline.setAttribute("d", path);
    // The opacity is in the colour here; Plotly keeps the two apart.
    outline.style.fill = trace.marker.color[i];
    outline.style.fillOpacity = "1";
    if (word) {
      const text =
        point.querySelector("text") ?? point.appendChild(/** @type {Element} */ (word.cloneNode()));
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
    // Plotly has a path for each piece of a line; here one has all of them.
    const [line] = made(lines, 1);
    line.setAttribute("d", linePath(/** @type {any} */ (trace), scale));
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

/**
 * @param {Record<string, any>} trace
 * @param {Marks} marks
 * @param {import("../../figures/pixels.js").PixelScale} scale
 */
function moveHeat(trace, { points: [image] }, scale) {
  const map = /** @type {import("../../figures/heat-image.js").HeatMap} */ (trace);
  const canvas = document.createElement("canvas");
  [canvas.width, canvas.height] = [map.z[0].length, map.z.length];
  const pixels = new ImageData(heatPixels(map), canvas.width, canvas.height);
  canvas.getContext("2d")?.putImageData(pixels, 0, 0);
  // Plotly's own, in its namespace: another one would be shown in place of all that Plotly draws later
  const address = [...image.attributes].find(({ localName }) => localName === "href");
  /** @type {Attr} */ (address).value = canvas.toDataURL();
  for (const [name, value] of Object.entries(heatPlace(map, scale))) {
    image.setAttribute(name, String(value));
  }
}

const MOVES = { bar: moveBars, heatmap: moveHeat, scatter: moveScatter };
