// @ts-check

import { axisTitle, baseLayout, plainAxis } from "../../figures/plot-area.js";
import { brief } from "../../format/number.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";
import { say } from "../../format/words.js";

/**
 * ε_t along g_t/g_n for one friction; the same ψ stand at the same places of every curve.
 * @typedef {{muOverAlpha: number, gtOverGn: ArrayLike<number>, psi: ArrayLike<number>, epsilonT: ArrayLike<number>}} FrictionCurve
 */

const MARGIN = { l: 60, r: 14, t: 6, b: 46 };
/** Of the height, for the space between both plots and the lower axis' title. */
const GAP = 0.28;
const TICKS = [-1, 0, 1];
/** Where curves lie on each other, the ones below look out at both sides. */
const WIDTHS = [7, 4, 1.5];

/** The colour of each curve, in the order of the curves. */
export const COLLAPSE_COLORS = /** @type {const} */ (["methodTable", "methodEuler", "ink"]);

/**
 * The same collisions over g_t/g_n, a curve for each friction, and over ψ, where they are one.
 * @param {FrictionCurve[]} curves
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function collapseFigure(curves, theme, size) {
  const farthest = Math.max(...curves.map(({ psi }) => psi[psi.length - 1]));
  const vertical = { ...plainAxis(theme, [-1.05, 1.05], TICKS, TICKS.map(brief)) };
  const title = axisTitle(PLOT_SYMBOLS.epsilon_t, 2, theme);
  const zero = { zeroline: true, zerolinecolor: theme.grid, zerolinewidth: 1 };
  return {
    data: curves.flatMap(({ muOverAlpha, gtOverGn, psi, epsilonT }, i) => {
      const curve = {
        type: "scatter",
        mode: "lines",
        y: epsilonT,
        line: {
          color: theme[COLLAPSE_COLORS[i]],
          width: 1.75 * theme.unit,
          simplify: false,
        },
      };
      return [
        { ...curve, name: `μ/α = ${brief(muOverAlpha)}`, x: gtOverGn },
        {
          ...curve,
          name: say("paper.collapse.overPsi", { name: `μ/α = ${brief(muOverAlpha)}` }),
          x: psi,
          xaxis: "x2",
          yaxis: "y2",
          line: { ...curve.line, width: WIDTHS[i] * theme.unit },
        },
      ];
    }),
    layout: {
      ...baseLayout(theme, size, MARGIN),
      xaxis: {
        ...even(theme, 4),
        title: axisTitle(PLOT_SYMBOLS.gt_over_gn, 2, theme),
        anchor: "y",
      },
      yaxis: { ...vertical, ...zero, title, domain: [0.5 + GAP / 2, 1] },
      xaxis2: {
        ...even(theme, Math.round(farthest)),
        title: axisTitle(PLOT_SYMBOLS.psi, 2, theme),
        anchor: "y2",
      },
      yaxis2: { ...vertical, ...zero, title, domain: [0, 0.5 - GAP / 2] },
    },
  };
}

/**
 * The largest difference between curves at the same ψ.
 * @param {FrictionCurve[]} curves
 */
export function spreadOf(curves) {
  const [first, ...others] = curves.map(({ epsilonT }) => Array.from(epsilonT));
  return Math.max(
    ...others.map((curve) => Math.max(...curve.map((value, i) => Math.abs(value - first[i])))),
  );
}

/**
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {number} most
 */
function even(theme, most) {
  const ticks = Array.from({ length: most + 1 }, (_, i) => i);
  return plainAxis(theme, [0, most], ticks, ticks.map(brief));
}
