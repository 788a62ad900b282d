// @ts-check

import { axisTitle, baseLayout, CUT_MARGIN, plainAxis } from "../../figures/plot-area.js";
import { shareAxis } from "../../figures/share-axis.js";
import { brief } from "../../format/number.js";

const TICKS = [-1, -0.5, 0, 0.5, 1];

/**
 * ε_t over the tangential velocity at one normal velocity, beside Coulomb's law and what was measured.
 * @param {object} subject
 * @param {{epsilon_t: ArrayLike<number>, coulomb: ArrayLike<number>}} subject.curves
 * @param {import("../../state/scales.js").Scale} subject.tangential
 * @param {{share: number, epsilon_t: number}[]} subject.measured
 * @param {{share: number, epsilon_t: number} | null} subject.here
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function sphereCutFigure({ curves, tangential, measured, here }, theme, size) {
  const { unit } = theme;
  const within = measured.filter(({ share }) => share <= 1);
  const count = curves.epsilon_t.length;
  const x = Float64Array.from({ length: count }, (_, i) => i / (count - 1));
  const line = (
    /** @type {string} */ name,
    /** @type {ArrayLike<number>} */ y,
    /** @type {Record<string, any>} */ style,
  ) => ({ name, type: "scatter", mode: "lines", x, y, line: { simplify: false, ...style } });
  const points = (
    /** @type {string} */ name,
    /** @type {{share: number, epsilon_t: number}[]} */ all,
    /** @type {Record<string, any>} */ marker,
  ) => ({
    name,
    type: "scatter",
    mode: "markers",
    x: all.map(({ share }) => share),
    y: all.map((point) => point.epsilon_t),
    marker,
  });
  return {
    data: [
      line("coulomb", curves.coulomb, {
        color: theme.inkSoft,
        width: 1.25 * unit,
        dash: "6px,4px",
      }),
      line("epsilon_t", curves.epsilon_t, { color: theme.ink, width: 2 * unit }),
      // A trace without points is not drawn at all, and those to be moved are counted.
      ...(within.length > 0
        ? [
            points("measured", within, {
              size: 9 * unit,
              color: theme.methodEuler,
              symbol: "diamond",
            }),
          ]
        : []),
      points("present impact", here ? [here] : [], {
        size: 13 * unit,
        color: theme.paper,
        line: { width: 2.5 * unit, color: theme.ink },
      }),
    ],
    layout: {
      ...baseLayout(theme, size, CUT_MARGIN),
      xaxis: {
        ...shareAxis(theme, tangential, "linear"),
        title: axisTitle("<i>g</i><sub>t</sub> in m/s", 4, theme, 13),
      },
      yaxis: {
        ...plainAxis(theme, [-1.04, 1.04], TICKS, TICKS.map(brief)),
        title: axisTitle("<i>ε</i><sub>t</sub>", 2, theme, 13),
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
    },
  };
}
