// @ts-check

import { axisTitle, baseLayout, CUT_MARGIN, plainAxis } from "../../figures/plot-area.js";
import { shareAxis } from "../../figures/share-axis.js";
import { brief } from "../../format/number.js";
import { say } from "../../format/words.js";
import { velocityName } from "./velocity-map-figure.js";

const TICKS = [-1, -0.5, 0, 0.5, 1];

/**
 * ε_t over the tangential velocity at one normal velocity, beside Coulomb's law and what was measured.
 * @param {object} subject
 * @param {{epsilon_t: ArrayLike<number>, coulomb: ArrayLike<number>}} subject.curves
 * @param {import("../../state/scales.js").Scale} subject.tangential
 * @param {"linear" | "log"} subject.scale
 * @param {{share: number, epsilon_t: number}[]} subject.measured
 * @param {{share: number, epsilon_t: number, velocity: string} | null} subject.here
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function sphereCutFigure({ curves, tangential, scale, measured, here }, theme, size) {
  const { unit } = theme;
  const within = measured.filter(isOnAxis);
  const isHere = here !== null && isOnAxis(here);
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
      // At an axis, too, it is a whole ring.
      {
        ...points("present impact", isHere ? [here] : [], {
          size: 13 * unit,
          color: theme.paper,
          line: { width: 2.5 * unit, color: theme.ink },
        }),
        cliponaxis: false,
      },
      ...beyondTheAxis(here, measured.length - within.length, theme),
    ],
    layout: {
      ...baseLayout(theme, size, CUT_MARGIN),
      xaxis: {
        ...shareAxis(theme, tangential, scale),
        title: axisTitle(velocityName("t"), 4, theme, 13),
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

/**
 * What lies beyond the axis, in words at its end: the present impact at its height, and how many of the
 * measured ones.
 * @param {{share: number, epsilon_t: number, velocity: string} | null} here
 * @param {number} measured
 * @param {import("../../figures/theme.js").Theme} theme
 */
function beyondTheAxis(here, measured, theme) {
  const told = [
    ...(here && !isOnAxis(here) ? [atItsEnd(here)] : []),
    ...(measured > 0
      ? [{ end: 1, height: -0.9, text: say("marks.measuredBeyond", { count: measured }) }]
      : []),
  ];
  return told.length === 0
    ? []
    : [
        {
          name: "beyond the axis",
          type: "scatter",
          mode: "markers+text",
          marker: { size: 1, color: "rgba(0,0,0,0)" },
          x: told.map(({ end }) => end),
          y: told.map(({ height }) => height),
          text: told.map(({ text }) => text),
          textposition: told.map(({ end }) => (end === 1 ? "middle left" : "middle right")),
          textfont: { size: 11 * theme.unit, color: theme.ink },
          cliponaxis: false,
        },
      ];
}

/** @param {{share: number, epsilon_t: number, velocity: string}} here */
function atItsEnd({ share, epsilon_t, velocity }) {
  return share > 1
    ? { end: 1, height: epsilon_t, text: `${velocity} →` }
    : { end: 0, height: epsilon_t, text: `← ${velocity}` };
}

/** @param {{share: number}} place */
function isOnAxis({ share }) {
  return share >= -0.01 && share <= 1.01;
}
