// @ts-check

import { currentTheme } from "../widgets/theme.js";

const CONFIG = { staticPlot: true, showSendToCloud: false };
/** Above the picture, for its title. */
export const TITLE_PIXELS = 34;
const SCALE_PIXELS = 52;
/** Beside a title and under a scale, where the plot itself has none. */
const LEAST_MARGIN = 10;
/** Coordinates of a plot's own frame, in which 0 and 1 are its edges. */
const IN_FRAME = { type: "line", xref: "x domain", yref: "y domain" };

/**
 * A crosshair, as shares from the left and from the top; beyond an axis it has no line.
 * @typedef {{x: number | null, y: number | null}} Crosshair
 */

/**
 * What a Plotly element shows, on the page's ground and under a title; null while it shows nothing.
 * @param {HTMLElement} element
 * @param {{title: string, place: Crosshair | null}} options
 * @returns {Promise<import("./drawn.js").Drawn | null>}
 */
export async function pictureOf(element, { place, title }) {
  const { data, layout } = /** @type {any} */ (element);
  if (!layout) {
    return null;
  }
  const theme = currentTheme();
  const head = TITLE_PIXELS * theme.unit;
  const isColored = data.some(hasColors);
  const side = isColored ? SCALE_PIXELS * theme.unit : 0;
  const least = LEAST_MARGIN * theme.unit;
  const [width, height] = [layout.width + side, layout.height + head];
  const line = { color: theme.ink, width: theme.unit };
  const figure = {
    data: data.map((/** @type {Record<string, any>} */ trace) => withScale(trace, theme)),
    layout: {
      ...layout,
      width,
      height,
      margin: {
        ...layout.margin,
        t: layout.margin.t + head,
        r: layout.margin.r + side,
        b: Math.max(layout.margin.b, least),
      },
      paper_bgcolor: theme.paper,
      plot_bgcolor: theme.paper,
      title: {
        text: title,
        x: Math.max(layout.margin.l, least) / width,
        xanchor: "left",
        y: 1 - (0.55 * head) / height,
        yanchor: "middle",
        font: { size: 13 * theme.unit, color: theme.ink },
      },
      shapes: [...(layout.shapes ?? []), ...crosshairLines(place ?? { x: null, y: null }, line)],
    },
    config: CONFIG,
  };
  const svg = await Plotly.toImage(figure, { format: "svg", width, height, imageDataOnly: true });
  return { svg, size: { width, height } };
}

/**
 * @param {Crosshair} place
 * @param {Record<string, any>} line
 */
function crosshairLines({ x, y }, line) {
  return [
    ...(x === null ? [] : [{ ...IN_FRAME, x0: x, x1: x, y0: 0, y1: 1, line }]),
    ...(y === null ? [] : [{ ...IN_FRAME, x0: 0, x1: 1, y0: 1 - y, y1: 1 - y, line }]),
  ];
}

/** @param {Record<string, any>} trace */
function hasColors({ type }) {
  return type === "heatmap" || type === "surface";
}

/**
 * A map with its scale of colours, which on the page is no part of the plot.
 * @param {Record<string, any>} trace
 * @param {import("../figures/theme.js").Theme} theme
 */
function withScale(trace, { unit, inkSoft }) {
  if (!hasColors(trace)) {
    return trace;
  }
  const colorbar = {
    thickness: 10 * unit,
    outlinewidth: 0,
    len: 1,
    ypad: 0,
    ...colorTicks(trace),
    tickfont: { size: 11 * unit, color: inkSoft },
  };
  return { ...trace, showscale: true, colorbar };
}

/**
 * Counts go by twos, errors by powers of ten; the last colour of counts may stand for more.
 * @param {Record<string, any>} trace
 */
function colorTicks({ name, z, zmin, zmax, cmin = zmin, cmax = zmax }) {
  if (name !== "switches") {
    return { dtick: name === "error" ? 2 : 0.5 };
  }
  const counts = Array.from({ length: (cmax - cmin) / 2 }, (_, i) => cmin + 1 + 2 * i);
  const isMore = z.some((/** @type {ArrayLike<number>} */ row) =>
    Array.prototype.some.call(row, (count) => count > cmax),
  );
  const words = counts.map((count, i) =>
    isMore && i === counts.length - 1 ? `≥ ${count}` : count,
  );
  return { tickvals: counts, ticktext: words };
}
