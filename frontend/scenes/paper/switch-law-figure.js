// @ts-check

import { axisTitle, baseLayout, plainAxis } from "../../figures/plot-area.js";
import { brief } from "../../format/number.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";
import { say } from "../../format/words.js";
import { decadeAxis, lawLine, LAW_MARGIN } from "./stiff-law-figure.js";

/**
 * The largest number of switches that was met at each κ, and the law that it follows.
 * @typedef {{kappa: ArrayLike<number>, most: number[], law: ArrayLike<number>}} SwitchLaw
 */

const COUNTS = [2, 5, 10, 20, 50, 100, 200];

/**
 * The largest number of switches over κ, both logarithmic.
 * @param {SwitchLaw} subject
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function switchLawFigure({ kappa, most, law }, theme, size) {
  const highest = Math.log10(1.3 * Math.max(...most));
  const ticks = COUNTS.map(Math.log10);
  return {
    data: [
      {
        name: say("paper.switchLaw.points"),
        type: "scatter",
        mode: "markers",
        x: Array.from(kappa, Math.log10),
        y: most.map(Math.log10),
        marker: { size: 5 * theme.unit, color: theme.tangentialForce },
        cliponaxis: false,
      },
      lawLine("law for stiff springs", kappa, law, { color: theme.ink, width: 2 * theme.unit }),
    ],
    layout: {
      ...baseLayout(theme, size, LAW_MARGIN),
      xaxis: { ...decadeAxis(theme, kappa), title: axisTitle(PLOT_SYMBOLS.kappa, 4, theme) },
      yaxis: {
        ...plainAxis(theme, [Math.log10(1.7), highest], ticks, COUNTS.map(brief)),
        title: axisTitle(say("paper.switchLaw.most"), 4, theme, 12),
      },
    },
  };
}

/**
 * What a map of the numbers of switches says of each κ.
 * @param {{kappa: ArrayLike<number>, switches: ArrayLike<number>[], largest_switches: ArrayLike<number>[]}} map rows of constant g_t/g_n
 * @returns {SwitchLaw}
 */
export function switchLawOf({ kappa, switches, largest_switches: [law] }) {
  const most = Array.from(kappa, (_, i) => Math.max(...switches.map((row) => row[i])));
  return { kappa, most, law };
}
