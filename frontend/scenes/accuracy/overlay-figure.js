// @ts-check

import {
  baseLayout,
  forceReach,
  plainAxis,
  timeAxis,
  TRACE_MARGIN,
} from "../../figures/plot-area.js";

/** More steps than this make a line of their marks. */
const MOST_MARKS = 250;

/**
 * The force as a method in time steps has it, over the exact one.
 * @param {{trace: import("../../api/answers.js").Trace, stepped: import("../../api/answers.js").Stepped}} subject
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function overlayFigure({ trace, stepped }, theme, size) {
  const { unit } = theme;
  const forces = stepped.method_tangential_force_over_mu;
  const curve = (
    /** @type {string} */ name,
    /** @type {ArrayLike<number>} */ y,
    /** @type {Record<string, any>} */ line,
  ) => ({
    name,
    type: "scatter",
    mode: "lines",
    x: trace.time,
    y,
    line: { simplify: false, ...line },
  });
  const reach = forceReach(trace.normal_force, forces);
  const cap = { width: 1.25 * unit, color: theme.normalForce, dash: "5px,4px" };
  return {
    data: [
      curve("plus normal force", trace.normal_force, cap),
      curve(
        "minus normal force",
        trace.normal_force.map((force) => -force),
        cap,
      ),
      curve("exact force", trace.tangential_force_over_mu, {
        width: 2.25 * unit,
        color: theme.tangentialForce,
      }),
      {
        name: "force in time steps",
        type: "scatter",
        mode: forces.length > MOST_MARKS ? "lines" : "lines+markers",
        x: stepped.method_time,
        y: forces,
        line: { width: 1.25 * unit, color: theme.methodEuler, simplify: false },
        marker: { size: 5 * unit, color: theme.methodEuler },
      },
    ],
    layout: {
      ...baseLayout(theme, size, TRACE_MARGIN),
      xaxis: timeAxis(theme, trace.contact_duration),
      yaxis: {
        ...plainAxis(theme, [-reach, reach], [-1, 0, 1], ["−1", "0", "1"]),
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
    },
  };
}
