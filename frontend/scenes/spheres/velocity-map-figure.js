// @ts-check

import { restitutionStops } from "../../figures/color-scales.js";
import { axisTitle, baseLayout, MAP_MARGIN } from "../../figures/plot-area.js";
import { shareAxis } from "../../figures/share-axis.js";
import { say } from "../../format/words.js";

/**
 * ε_t of one pair of bodies over the velocities of the impact, as in Figs. 1 and 2, in m/s.
 * @param {{cells: Float64Array[], view: ReturnType<typeof import("../../state/impact.js").velocityView>}} subject
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function velocityMapFigure({ cells, view }, theme, size) {
  return {
    data: [
      {
        name: "epsilon_t",
        type: "heatmap",
        z: cells,
        x0: 0,
        dx: 1 / (cells[0].length - 1),
        y0: 0,
        dy: 1 / (cells.length - 1),
        zmin: -1,
        zmax: 1,
        colorscale: restitutionStops(theme.dark),
        showscale: false,
        zsmooth: "fast",
      },
    ],
    layout: {
      ...baseLayout(theme, size, MAP_MARGIN),
      xaxis: {
        ...shareAxis(theme, view.normal, view.scale),
        title: axisTitle(velocityName("n"), 4, theme, 13),
      },
      yaxis: {
        ...shareAxis(theme, view.tangential, view.scale),
        title: axisTitle(velocityName("t"), 2, theme, 13),
      },
    },
  };
}

/** What an axis of velocities is, for Plotly. @param {"n" | "t"} index */
export function velocityName(index) {
  return say("spheres.velocities.axis", { velocity: `<i>g</i><sub>${index}</sub>` });
}
