// @ts-check

import { PLOT_SYMBOLS } from "../format/symbols.js";
import { restitutionStops, switchClasses, switchStops } from "./color-scales.js";
import { axisTitle, baseLayout, MAP_MARGIN } from "./plot-area.js";
import { horizontalName, shareAxis } from "./share-axis.js";

/**
 * A map and how it is to be seen.
 * @typedef {object} ShownMap
 * @property {import("../api/answers.js").MapGrid} grid
 * @property {import("../state/map-view.js").MapView} view
 * @property {import("../state/map-view.js").HorizontalAxis} horizontal
 * @property {"epsilon_t" | "switches"} quantity
 */

/**
 * The map of Figs. 3 and 4: ε_t or the number of switches over κ and g_t/g_n or ψ. Its axes are shares of
 * the view, 0 … 1, logarithmic or not, and only their ticks tell the values.
 * @param {ShownMap} map
 * @param {import("./theme.js").Theme} theme
 * @param {import("./plot-area.js").Size} size
 * @returns {import("./plot-area.js").Figure}
 */
export function mapFigure({ grid, view, horizontal, quantity }, theme, size) {
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
        ...mapColoring(grid, quantity, theme.dark),
        showscale: false,
        // Counts have no values between them.
        zsmooth: quantity === "epsilon_t" ? "fast" : false,
      },
    ],
    layout: {
      ...baseLayout(theme, size, MAP_MARGIN),
      xaxis: {
        ...shareAxis(theme, horizontal.scale, view.scale),
        title: axisTitle(horizontalName(horizontal), 6, theme),
      },
      yaxis: {
        ...shareAxis(theme, view.gtOverGn, view.scale),
        title: axisTitle(PLOT_SYMBOLS[view.vertical], 2, theme),
      },
    },
  };
}

/**
 * The most switches anywhere on a map.
 * @param {{switches: Int32Array[]}} grid
 */
export function mostSwitches({ switches }) {
  return switches.reduce((most, row) => row.reduce((a, b) => Math.max(a, b), most), 0);
}

/**
 * The colours of a quantity and the range they span.
 * @param {{switches: Int32Array[]}} grid
 * @param {"epsilon_t" | "switches"} quantity
 * @param {boolean} dark
 */
export function mapColoring(grid, quantity, dark) {
  if (quantity === "epsilon_t") {
    return { zmin: -1, zmax: 1, colorscale: restitutionStops(dark) };
  }
  const classes = switchClasses(mostSwitches(grid), dark);
  const zmin = classes[0].switches - 1;
  return { zmin, zmax: zmin + 2 * classes.length, colorscale: switchStops(classes) };
}
