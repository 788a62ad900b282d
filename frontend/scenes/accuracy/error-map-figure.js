// @ts-check

import { errorStops } from "../../figures/color-scales.js";
import { axisTitle, baseLayout, MAP_MARGIN } from "../../figures/plot-area.js";
import { horizontalName, shareAxis } from "../../figures/share-axis.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";

/** Between these powers of ten an error has a colour of its own. */
export const ERROR_DECADES = { low: -8, high: 0 };

/**
 * Where on the map a method is off, and by how many powers of ten.
 * @param {{errors: Float64Array[], view: import("../../state/map-view.js").MapView, horizontal: import("../../state/map-view.js").HorizontalAxis}} subject
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function errorMapFigure({ errors, view, horizontal }, theme, size) {
  const { low, high } = ERROR_DECADES;
  return {
    data: [
      {
        name: "error",
        type: "heatmap",
        z: errors.map((row) => Array.from(row, powerOf)),
        x0: 0,
        dx: 1 / (errors[0].length - 1),
        y0: 0,
        dy: 1 / (errors.length - 1),
        zmin: low,
        zmax: high,
        colorscale: errorStops(theme.dark),
        showscale: false,
        zsmooth: false,
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
 * The power of ten of an error; of none, that of the lowest colour. What is not known stays without.
 * @param {number} error
 */
function powerOf(error) {
  return Number.isNaN(error)
    ? null
    : Math.max(ERROR_DECADES.low, Math.log10(Math.max(Math.abs(error), Number.MIN_VALUE)));
}
