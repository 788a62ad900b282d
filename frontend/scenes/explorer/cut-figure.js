// @ts-check

import { switchClasses } from "../../figures/color-scales.js";
import {
  axisTitle,
  baseLayout,
  CUT_MARGIN,
  innerSize,
  plainAxis,
} from "../../figures/plot-area.js";
import { shareAxis } from "../../figures/share-axis.js";
import { legible } from "../../figures/spread.js";
import { brief } from "../../format/number.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";

/**
 * @typedef {import("../../api/answers.js").Cut} Cut
 * @typedef {import("../../state/map-view.js").MapView} MapView
 * @typedef {import("../../figures/theme.js").Theme} Theme
 * @typedef {import("../../state/presets.js").Letter} Letter
 */

const TICKS = [-1, -0.5, 0, 0.5, 1];
const RIBBON_PIXELS = 8;
const LETTER_PIXELS = 14;
/** The letters name collisions at one κ; this near to it, as a factor, they still say what they mean. */
const NEAR_ENOUGH = 1.2;

/**
 * The cut through the map at one κ: ε_t beside what simpler laws say, over a ribbon in the map's
 * colours of the switch counts and the letters of Fig. 5.
 * @param {{cut: Cut, view: MapView, kappa: number, muOverAlpha: number, letters: Letter[], most: number}} subject
 *   with the number of switches up to which the map has colours
 * @param {Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function cutFigure({ cut, view, kappa, muOverAlpha, letters, most }, theme, size) {
  const inner = innerSize(size, CUT_MARGIN, theme);
  const { range, perPixel } = verticalAxis(inner.height, theme);
  const shares = cut.values.map((_, i) => i / (cut.values.length - 1));
  // The letters of Fig. 5 are undamped collisions.
  const near = view.damping > 0 ? [] : letters.filter((one) => isNear(one.kappa, kappa));
  const placed = near.map(({ letter, psi }) => ({
    letter,
    share: view.gtOverGn.toShare(psi * muOverAlpha),
  }));
  const onAxis = placed.filter(({ share }) => share >= 0 && share <= 1);
  const gap = (LETTER_PIXELS * theme.unit) / inner.width;
  const height = range[0] + (RIBBON_PIXELS + LETTER_PIXELS / 2 + 2) * theme.unit * perPixel;
  const quiet = { color: theme.inkSoft, width: 1.25 * theme.unit };
  const faint = { color: theme.ruleStrong, width: 1.25 * theme.unit };
  const line = (/** @type {string} */ name, /** @type {Line} */ points, /** @type {any} */ style) =>
    cutLine(name, points, { simplify: false, ...style });
  return {
    data: [
      countRibbon(cut.switches, most, range[0], RIBBON_PIXELS * theme.unit * perPixel, theme),
      line("stiff bound", within(shares, cut.stiff_bound, 1), faint),
      line("stiff bound, below", within(shares, cut.stiff_bound, -1), faint),
      line("stiff asymptote", within(shares, cut.stiff_asymptote, 1), { ...faint, dash: "dot" }),
      line("stiff asymptote, below", within(shares, cut.stiff_asymptote, -1), {
        ...faint,
        dash: "dot",
      }),
      line("coulomb", { x: shares, y: cut.coulomb }, { ...quiet, dash: "6px,4px" }),
      line(
        "epsilon_t",
        { x: shares, y: cut.epsilon_t },
        { color: theme.ink, width: 2 * theme.unit },
      ),
      letterMarks(
        legible(onAxis, ({ share }) => share, gap),
        height,
        theme,
      ),
    ],
    layout: {
      ...baseLayout(theme, size, CUT_MARGIN),
      xaxis: {
        ...shareAxis(theme, view.gtOverGn, view.scale),
        title: axisTitle(PLOT_SYMBOLS[view.vertical], 4, theme),
      },
      yaxis: {
        ...plainAxis(theme, range, TICKS, TICKS.map(brief)),
        title: axisTitle(PLOT_SYMBOLS.epsilon_t, 2, theme),
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
    },
  };
}

/**
 * The vertical axis, the same for every cut, with room for ribbon and letters below −1.
 * @param {number} height
 * @param {Theme} theme
 * @returns {{range: [number, number], perPixel: number}}
 */
function verticalAxis(height, { unit }) {
  const below = (RIBBON_PIXELS + LETTER_PIXELS + 6) * unit;
  const perPixel = (1.04 + 1) / Math.max(1, height - below);
  return { range: [-1 - below * perPixel, 1.04], perPixel };
}

/** @typedef {{x: ArrayLike<number>, y: ArrayLike<number>}} Line */

/**
 * @param {string} name
 * @param {Line} points
 * @param {Record<string, any>} line
 */
function cutLine(name, { x, y }, line) {
  return { name, type: "scatter", mode: "lines", x, y, line };
}

/**
 * The part of a curve that exists and lies on the axis. Where there is none it is a line out of sight:
 * Plotly leaves out a trace without points, and a drag would have to draw everything anew.
 * @param {Float64Array} x
 * @param {Float64Array} y
 * @param {1 | -1} sign
 * @returns {Line}
 */
function within(x, y, sign) {
  const shown = [...y.keys()].filter((i) => y[i] <= 1);
  return shown.length === 0
    ? { x: [0, 1], y: [2, 2] }
    : { x: shown.map((i) => x[i]), y: shown.map((i) => sign * y[i]) };
}

/**
 * Runs of one count, each in its colour on the map.
 * @param {Cut["switches"]} switches
 * @param {number} most
 * @param {number} base
 * @param {number} height
 * @param {Theme} theme
 */
function countRibbon(switches, most, base, height, theme) {
  const colors = switchClasses(most, theme.dark).map(({ color }) => color);
  // Of the stiffest springs the number of switches is not known.
  const colorAt = (/** @type {number} */ i) =>
    colors[Math.min(colors.length - 1, Math.floor(switches[i] / 2))] ?? "rgba(0,0,0,0)";
  const step = 1 / (switches.length - 1);
  const starts = [...switches.keys()].filter((i) => i === 0 || colorAt(i) !== colorAt(i - 1));
  // A count changes somewhere between two samples: half-way is as good as any.
  const edges = [...starts.map((i) => Math.max(0, (i - 0.5) * step)), 1];
  return {
    name: "switches",
    type: "bar",
    x: starts.map((_, k) => (edges[k] + edges[k + 1]) / 2),
    y: starts.map(() => height),
    width: starts.map((_, k) => edges[k + 1] - edges[k]),
    base: starts.map(() => base),
    marker: { color: starts.map(colorAt), line: { width: 0 } },
  };
}

/**
 * @param {{letter: string, share: number}[]} letters
 * @param {number} height
 * @param {Theme} theme
 */
function letterMarks(letters, height, theme) {
  return {
    name: "letters",
    type: "scatter",
    mode: "markers+text",
    x: letters.map(({ share }) => share),
    y: letters.map(() => height),
    text: letters.map(({ letter }) => letter),
    textfont: { size: 11 * theme.unit, color: theme.ink },
    marker: { size: LETTER_PIXELS * theme.unit, color: "rgba(0,0,0,0)", line: { width: 0 } },
    cliponaxis: false,
  };
}

/**
 * @param {number} a
 * @param {number} b
 */
function isNear(a, b) {
  return a < NEAR_ENOUGH * b && b < NEAR_ENOUGH * a;
}
