// @ts-check

import { brief } from "../format/number.js";
import { PLOT_SYMBOLS } from "../format/symbols.js";
import { mapColoring } from "./map-figure.js";
import { baseLayout } from "./plot-area.js";
import { horizontalName, shareTicks } from "./share-axis.js";

/**
 * @typedef {import("./theme.js").Theme} Theme
 * @typedef {object} Place the present collision
 * @property {number} x share from the left
 * @property {number} y share from the bottom
 * @property {number} epsilon_t
 * @property {number | null} switches
 */

/** As many cells as turn smoothly where a processor does the work of a graphics card. */
const COLUMNS = 72;
const ROWS = 54;
const NO_MARGIN = { l: 0, r: 0, t: 0, b: 0 };

/**
 * What is needed of a map, of whatever its axes are.
 * @typedef {object} Surface
 * @property {import("../api/answers.js").MapGrid} grid
 * @property {{scale: "linear" | "log", vertical: keyof typeof PLOT_SYMBOLS, gtOverGn: import("../state/scales.js").Scale}} view
 * @property {{symbol: keyof typeof PLOT_SYMBOLS, alpha?: number, scale: import("../state/scales.js").Scale}} horizontal
 * @property {"epsilon_t" | "switches"} quantity
 * @property {number} [most] switches, up to which there are colours
 * @property {Place | null} place
 */

/**
 * The map as a surface, as in Figs. 2 and 3: the same grid, coarser.
 * @param {Surface} map
 * @param {Theme} theme
 * @param {import("./plot-area.js").Size} size
 * @returns {import("./plot-area.js").Figure}
 */
export function surfaceFigure({ grid, view, horizontal, quantity, most = 0, place }, theme, size) {
  const columns = spread(grid.kappa.length, COLUMNS);
  const rows = spread(grid.gt_over_gn.length, ROWS);
  const { zmin, zmax, colorscale } = mapColoring(quantity, most, theme.dark);
  return {
    data: [
      {
        name: quantity,
        type: "surface",
        x: columns.map((i) => i / (grid.kappa.length - 1)),
        y: rows.map((j) => j / (grid.gt_over_gn.length - 1)),
        z: rows.map((j) => columns.map((i) => grid[quantity][j][i])),
        cmin: zmin,
        cmax: zmax,
        colorscale,
        showscale: false,
        hoverinfo: "skip",
        contours: { x: QUIET, y: QUIET, z: QUIET },
        lighting: { ambient: 0.75, diffuse: 0.5, specular: 0.02, roughness: 0.9, fresnel: 0 },
      },
      presentPlace(place, quantity, theme),
    ],
    layout: {
      ...baseLayout(theme, size, NO_MARGIN),
      // A new grid does not turn the surface back.
      uirevision: "turned",
      scene: {
        uirevision: "turned",
        dragmode: "turntable",
        hovermode: false,
        aspectmode: "manual",
        aspectratio: { x: 1.25, y: 1.1, z: 0.65 },
        camera: { eye: eyeFor(size), center: { x: 0, y: 0, z: -0.14 } },
        xaxis: sceneAxis(theme, horizontalName(horizontal), {
          range: [0, 1],
          ...shareTicks(horizontal.scale, view.scale),
        }),
        yaxis: sceneAxis(theme, PLOT_SYMBOLS[view.vertical], {
          range: [0, 1],
          ...shareTicks(view.gtOverGn, view.scale),
        }),
        zaxis:
          quantity === "switches"
            ? sceneAxis(theme, "", { rangemode: "tozero", dtick: 2 })
            : sceneAxis(theme, PLOT_SYMBOLS.epsilon_t, restitutionTicks()),
      },
    },
  };
}

const QUIET = { highlight: false };

/**
 * Indices from 0 to the last, as even as may be, at most so many.
 * @param {number} length
 * @param {number} most
 */
function spread(length, most) {
  const count = Math.min(length, most);
  return Array.from({ length: count }, (_, i) => Math.round((i * (length - 1)) / (count - 1)));
}

/**
 * As near as the frame allows: its height decides, unless it is narrow.
 * @param {import("./plot-area.js").Size} size
 */
function eyeFor({ width, height }) {
  const distance = Math.min(2.1, Math.max(1.08, (1.45 * height) / width));
  return { x: 1.2 * distance, y: -1.45 * distance, z: 0.9 * distance };
}

/**
 * @param {Place | null} place
 * @param {"epsilon_t" | "switches"} quantity
 * @param {Theme} theme
 */
function presentPlace(place, quantity, theme) {
  const height = place?.[quantity] ?? null;
  const isThere = place !== null && height !== null;
  return {
    name: "present collision",
    type: "scatter3d",
    mode: "markers",
    x: isThere ? [place.x] : [],
    y: isThere ? [place.y] : [],
    z: isThere ? [height] : [],
    hoverinfo: "skip",
    marker: {
      size: 5 * theme.unit,
      color: theme.ink,
      line: { width: 2 * theme.unit, color: theme.paper },
    },
  };
}

/**
 * @param {Theme} theme
 * @param {string} text
 * @param {Record<string, any>} ticks
 */
function sceneAxis(theme, text, ticks) {
  return {
    ...ticks,
    title: { text, font: { size: 14 * theme.unit, color: theme.ink } },
    tickfont: { size: 11 * theme.unit, color: theme.inkSoft },
    showspikes: false,
    showbackground: false,
    zeroline: false,
    gridcolor: theme.grid,
    linecolor: theme.ruleStrong,
    showline: true,
  };
}

function restitutionTicks() {
  const tickvals = [-1, -0.5, 0, 0.5, 1];
  return { range: [-1, 1], tickvals, ticktext: tickvals.map(brief) };
}
