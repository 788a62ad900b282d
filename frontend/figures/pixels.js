// @ts-check

/**
 * Where the marks of a figure lie in pixels: what Plotly works out when it draws them, for those who
 * move marks that it has drawn.
 *
 * @typedef {import("./plot-area.js").Figure} Figure
 * @typedef {{x: (value: number) => number, y: (value: number) => number}} PixelScale
 */

/**
 * @param {Figure["layout"]} layout
 * @returns {PixelScale}
 */
export function pixelScale({ width, height, margin, xaxis, yaxis }) {
  return {
    x: along(xaxis.range, width - margin.l - margin.r),
    y: along([...yaxis.range].reverse(), height - margin.t - margin.b),
  };
}

/**
 * Whether two figures have axes of one kind, with as many ticks and the zero at the same place, and
 * differ only in the marks of their traces: how many there are, where they lie and what is written on
 * them. Ticks are marks as well, and move with the end of their axis.
 * @param {Figure} a
 * @param {Figure} b
 */
export function differInMarksOnly(a, b) {
  return (
    frameOf(a.layout) === frameOf(b.layout) &&
    a.data.length === b.data.length &&
    a.data.every((trace, i) => looksOf(trace) === looksOf(b.data[i]))
  );
}

/**
 * The path of a line, as SVG writes it, with a gap where its y is not a number.
 * @param {{x: ArrayLike<number>, y: ArrayLike<number>}} trace
 * @param {PixelScale} scale
 */
export function linePath({ x, y }, scale) {
  let path = "";
  let pen = "M";
  for (let i = 0; i < x.length; i += 1) {
    if (Number.isNaN(y[i])) {
      pen = "M";
    } else {
      path += `${pen}${scale.x(x[i])},${scale.y(y[i])}`;
      pen = "L";
    }
  }
  return path;
}

/**
 * The outline of each bar and its middle.
 * @param {Record<"x" | "y" | "width" | "base", number[]>} trace
 * @param {PixelScale} scale
 */
export function barPlaces({ x, y, width, base }, scale) {
  return x.map((middle, i) => {
    const left = scale.x(middle - width[i] / 2);
    const right = scale.x(middle + width[i] / 2);
    const [bottom, top] = [scale.y(base[i]), scale.y(base[i] + y[i])];
    return { path: `M${left},${bottom}V${top}H${right}V${bottom}Z`, middle: (left + right) / 2 };
  });
}

/**
 * @param {[number, number] | number[]} range
 * @param {number} length
 */
function along([from, to], length) {
  const factor = length / (to - from);
  return (/** @type {number} */ value) => Math.round(100 * factor * (value - from)) / 100;
}

/** @param {Figure["layout"]} layout */
function frameOf({ width, height, margin, font, xaxis, yaxis }) {
  const axes = [xaxis, yaxis].map(({ range, ticktext, title, showgrid }) => {
    // lines of a grid, and words that are set in several pieces, stay as they are
    const isFixed = showgrid || ticktext.some((/** @type {string} */ word) => word.includes("<"));
    const zero = (range[0] / range[1]).toFixed(9);
    return [title, ...(isFixed ? [range, ticktext] : [zero, ticktext.length])];
  });
  return JSON.stringify([width, height, margin, font, axes]);
}

/** What of a trace moves with its marks, by its type. @type {Record<string, string[]>} */
const MOVABLE = {
  scatter: ["x", "y", "text"],
  // which differ in nothing else than their colours
  bar: ["x", "y", "width", "base", "text", "marker"],
  heatmap: ["z", "x0", "dx", "y0", "dy", "zmin", "zmax", "colorscale"],
};

/**
 * What of a trace does not come and go with its marks: all but their places, texts and values.
 * @param {Record<string, any>} trace
 */
function looksOf(trace) {
  const movable = MOVABLE[trace.type ?? "scatter"] ?? [];
  const fixed = Object.entries(trace).filter(([key]) => !movable.includes(key));
  return JSON.stringify([fixed, "text" in trace]);
}
