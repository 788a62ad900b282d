// @ts-check

import { brief } from "../format/number.js";
import { PLOT_SYMBOLS } from "../format/symbols.js";
import { restitutionStops, switchClasses, switchStops } from "./color-scales.js";
import { baseLayout, MAP_MARGIN, plainAxis } from "./plot-area.js";

/**
 * @typedef {import("../state/map-view.js").MapView} MapView
 * @typedef {import("../state/scales.js").Scale} Scale
 */

/**
 * The map of Figs. 3 and 4: ε_t or the number of switches over κ and g_t/g_n. Its axes are shares of
 * the view, 0 … 1, logarithmic or not, and only their ticks tell the values.
 * @param {{grid: import("../api/client.js").MapGrid, view: MapView, quantity: "epsilon_t" | "switches"}} map
 * @param {import("./theme.js").Theme} theme
 * @param {import("./plot-area.js").Size} size
 * @returns {import("./plot-area.js").Figure}
 */
export function mapFigure({ grid, view, quantity }, theme, size) {
  return {
    data: [
      {
        name: quantity,
        type: "heatmap",
        z: grid[quantity],
        x0: 0,
        dx: 1 / (grid.kappa.length - 1),
        y0: 0,
        dy: 1 / (grid.gt_over_gn.length - 1),
        ...coloring(grid, quantity, theme.dark),
        showscale: false,
        // Counts have no values between them.
        zsmooth: quantity === "epsilon_t" ? "fast" : false,
      },
    ],
    layout: {
      ...baseLayout(theme, size, MAP_MARGIN),
      xaxis: {
        ...shareAxis(theme, view.kappa, view.scale),
        title: {
          text: PLOT_SYMBOLS.kappa,
          standoff: 6 * theme.unit,
          font: { size: 14 * theme.unit, color: theme.ink },
        },
      },
      yaxis: {
        ...shareAxis(theme, view.gtOverGn, view.scale),
        title: {
          text: PLOT_SYMBOLS.gt_over_gn,
          standoff: 2 * theme.unit,
          font: { size: 14 * theme.unit, color: theme.ink },
        },
      },
    },
  };
}

/**
 * The most switches anywhere on a map.
 * @param {import("../api/client.js").MapGrid} grid
 */
export function mostSwitches({ switches }) {
  return switches.reduce((most, row) => row.reduce((a, b) => Math.max(a, b), most), 0);
}

/**
 * @param {import("../api/client.js").MapGrid} grid
 * @param {"epsilon_t" | "switches"} quantity
 * @param {boolean} dark
 */
function coloring(grid, quantity, dark) {
  if (quantity === "epsilon_t") {
    return { zmin: -1, zmax: 1, colorscale: restitutionStops(dark) };
  }
  const classes = switchClasses(mostSwitches(grid), dark);
  return { zmin: -1, zmax: 2 * classes.length - 1, colorscale: switchStops(classes) };
}

/**
 * @param {import("./theme.js").Theme} theme
 * @param {Scale} scale
 * @param {"linear" | "log"} kind
 */
function shareAxis(theme, scale, kind) {
  const values = kind === "log" ? decades(scale) : evenTicks(scale);
  return plainAxis(
    theme,
    [0, 1],
    values.map((value) => scale.toShare(value)),
    values.map(brief),
  );
}

/** @param {Scale} scale */
function decades({ min, max }) {
  const first = Math.ceil(Math.log10(min) - 1e-9);
  const last = Math.floor(Math.log10(max) + 1e-9);
  const every = Math.ceil((last - first + 1) / 7);
  const count = Math.floor((last - first) / every) + 1;
  return Array.from({ length: count }, (_, i) => Number(`1e${first + every * i}`));
}

/** @param {Scale} scale */
function evenTicks({ min, max }) {
  const rough = (max - min) / 6;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((factor) => factor * decade >= rough) ?? 10) * decade;
  const count = Math.floor(max / step + 1e-9);
  const rounds = Array.from({ length: count }, (_, i) => Number(((i + 1) * step).toPrecision(12)));
  return [min, ...rounds.filter((value) => value - min > step / 2)];
}
