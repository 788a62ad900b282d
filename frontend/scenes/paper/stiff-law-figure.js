// @ts-check

import { axisTitle, baseLayout, plainAxis } from "../../figures/plot-area.js";
import { powerOfTen } from "../../format/number.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";
import { say } from "../../format/words.js";

/**
 * A cut along κ at one ψ, with what the server says of stiff springs there.
 * @typedef {{psi: number, kappa: ArrayLike<number>, epsilonT: ArrayLike<number>, bound: ArrayLike<number>, asymptote: ArrayLike<number>}} StiffCut
 */

/** @typedef {import("../../figures/theme.js").Theme} Theme */

export const LAW_MARGIN = { l: 62, r: 14, t: 8, b: 46 };
/** Below that there is nothing to see. */
const LEAST = 1e-8;

/**
 * |ε_t|ψ of collisions over κ, both logarithmic, under the line that they come up to, and the one of
 * Eq. 27 with its factor, which they keep below.
 * @param {StiffCut[]} cuts
 * @param {Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function stiffLawFigure(cuts, theme, size) {
  const points = cuts.flatMap(({ psi, kappa, epsilonT }) =>
    Array.from(kappa, (value, i) => ({ x: value, y: Math.abs(epsilonT[i]) * psi })),
  );
  const shown = points.filter(({ y }) => y > LEAST);
  const [{ kappa }] = cuts;
  // Both lines are the same at every ψ, once multiplied by it; the bound is cut off at 1.
  const least = cuts.reduce((a, b) => (a.psi > b.psi ? a : b));
  return {
    data: [
      {
        name: say("paper.stiffLaw.collisions"),
        type: "scatter",
        mode: "markers",
        x: shown.map(({ x }) => Math.log10(x)),
        y: shown.map(({ y }) => Math.log10(y)),
        marker: { size: 2.5 * theme.unit, color: theme.tangentialForce, opacity: 0.6 },
      },
      lawLine(say("paper.stiffLaw.limit"), kappa, scaled(least.asymptote, least.psi), {
        color: theme.ink,
        width: 2 * theme.unit,
      }),
      lawLine(say("paper.stiffLaw.corrected"), kappa, scaled(least.bound, least.psi), {
        color: theme.inkSoft,
        width: 1.5 * theme.unit,
        dash: "dash",
      }),
    ],
    layout: {
      ...baseLayout(theme, size, LAW_MARGIN),
      xaxis: { ...decadeAxis(theme, kappa), title: axisTitle(PLOT_SYMBOLS.kappa, 4, theme) },
      yaxis: {
        ...decadeAxis(theme, [LEAST, 1], 2),
        title: axisTitle(`|${PLOT_SYMBOLS.epsilon_t}| ${PLOT_SYMBOLS.psi}`, 2, theme),
      },
    },
  };
}

/**
 * How near to the limit the collisions come, and the constant of the limit, |ε_t|ψκ^{5/4}.
 * @param {StiffCut[]} cuts
 */
export function stiffReach(cuts) {
  const [{ psi, kappa, asymptote }] = cuts;
  const shares = cuts.flatMap((cut) =>
    Array.from(cut.epsilonT, (value, i) => Math.abs(value) / cut.asymptote[i]),
  );
  return { reach: Math.max(...shares), constant: asymptote[0] * psi * kappa[0] ** 1.25 };
}

/**
 * @param {string} name
 * @param {ArrayLike<number>} x
 * @param {ArrayLike<number>} y
 * @param {Record<string, any>} line
 */
export function lawLine(name, x, y, line) {
  return {
    name,
    type: "scatter",
    mode: "lines",
    x: Array.from(x, Math.log10),
    y: Array.from(y, Math.log10),
    line,
  };
}

/**
 * An axis over the decades between the first and the last value.
 * @param {Theme} theme
 * @param {ArrayLike<number>} values ascending
 */
export function decadeAxis(theme, values, every = 1) {
  const [low, high] = [values[0], values[values.length - 1]].map(Math.log10);
  const first = Math.ceil(low - 1e-9);
  const count = Math.floor((high + 1e-9 - first) / every) + 1;
  const powers = Array.from({ length: count }, (_, i) => first + every * i);
  return plainAxis(theme, [low, high], powers, powers.map(powerOfTen));
}

/**
 * @param {ArrayLike<number>} values
 * @param {number} factor
 */
function scaled(values, factor) {
  return Array.from(values, (value) => factor * value);
}
