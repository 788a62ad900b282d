// @ts-check

import { switchClasses } from "../../../figures/color-scales.js";
import { axisTitle, baseLayout, CUT_MARGIN, innerSize } from "../../../figures/plot-area.js";
import { shareAxis } from "../../../figures/share-axis.js";
import { legible } from "../../../figures/spread.js";
import { PLOT_SYMBOLS } from "../../../format/symbols.js";
import { runsOfSign, telling } from "./curves.js";
import { verticalAxis } from "./vertical-axis.js";

/**
 * @typedef {import("../../../api/answers.js").Cut} Cut
 * @typedef {import("../../../figures/theme.js").Theme} Theme
 * @typedef {import("./vertical-axis.js").VerticalAxis} VerticalAxis
 * @typedef {import("../../../state/presets.js").Letter} Letter
 */

const RIBBON_PIXELS = 8;
const LETTER_PIXELS = 14;
/** The letters name collisions at one κ; this near to it, as a factor, they still say what they mean. */
const NEAR_ENOUGH = 1.2;

/** Plotly's own dots are dashes of 3 pixels. */
const DOTTED = { dash: "1px,4px", width: 2 };
const DASHED = { dash: "6px,4px", width: 1.25 };

/**
 * The cut through the map along one of its axes: ε_t beside what simpler laws say, over a ribbon in
 * the map's colours of the switch counts and the letters of Fig. 5. On a logarithmic axis, what is
 * negative is a line of its own.
 * @param {import("../../../api/queries.js").CutAxes & {cut: Cut, vertical: "linear" | "log", letters: Letter[], most: number}} subject
 *   with the number of switches up to which the map has colours
 * @param {Theme} theme
 * @param {import("../../../figures/plot-area.js").Size} size
 * @returns {import("../../../figures/plot-area.js").Figure & {axis: VerticalAxis}}
 */
export function cutFigure(subject, theme, size) {
  const { cut, view, along, vertical, most } = subject;
  const inner = innerSize(size, CUT_MARGIN, theme);
  const below = (RIBBON_PIXELS + LETTER_PIXELS + 6) * theme.unit;
  const axis = verticalAxis(vertical, cut.epsilon_t, inner.height, below, theme);
  const shares = cut.values.map((_, i) => i / (cut.values.length - 1));
  const gap = (LETTER_PIXELS * theme.unit) / inner.width;
  const height =
    axis.range[0] + (RIBBON_PIXELS + LETTER_PIXELS / 2 + 2) * theme.unit * axis.perPixel;
  const ribbon = RIBBON_PIXELS * theme.unit * axis.perPixel;
  return {
    data: [
      countRibbon(cut.switches, most, axis.range[0], ribbon, theme),
      ...limits(cut, shares, vertical, axis, theme),
      ...laws(cut, shares, vertical, axis, theme),
      letterMarks(
        legible(lettersOn(subject), ({ share }) => share, gap),
        height,
        theme,
      ),
    ],
    layout: {
      ...baseLayout(theme, size, CUT_MARGIN),
      xaxis: {
        ...shareAxis(theme, along === "kappa" ? view.kappa : view.gtOverGn, view.scale),
        title: axisTitle(PLOT_SYMBOLS[along === "kappa" ? "kappa" : view.vertical], 4, theme),
      },
      yaxis: axis.layout,
    },
    axis,
  };
}

/** Whether the stiff limit is to be seen anywhere on a cut. @param {Cut} cut */
export function hasStiffLimit({ stiff_asymptote, stiff_bound }) {
  return stiff_asymptote.some((value, i) => value <= stiff_bound[i]);
}

/**
 * Both limits of stiff springs, on both sides of zero unless magnitudes are shown. The law that is
 * reached is drawn where it lies below the bound: elsewhere it says nothing.
 * @param {Cut} cut
 * @param {Float64Array} shares
 * @param {"linear" | "log"} vertical
 * @param {VerticalAxis} axis
 * @param {Theme} theme
 */
function limits(cut, shares, vertical, axis, theme) {
  const faint = { color: theme.ruleStrong, width: 1.25 };
  const parts = /** @type {const} */ ([
    ["stiff bound", telling(shares, cut.stiff_bound, () => 1), faint],
    [
      "stiff limit",
      telling(shares, cut.stiff_asymptote, (i) => cut.stiff_bound[i]),
      { ...faint, ...DOTTED },
    ],
  ]);
  return parts.flatMap(([name, { x, y }, style]) => {
    const sides = vertical === "log" ? [1] : [1, -1];
    return sides.map((side) => {
      const heights = y.map((value) => axis.place(side * value));
      return cutLine(side > 0 ? name : `${name}, below`, { x, y: heights }, style, theme);
    });
  });
}

/**
 * Coulomb's law and ε_t itself.
 * @param {Cut} cut
 * @param {Float64Array} shares
 * @param {"linear" | "log"} vertical
 * @param {VerticalAxis} axis
 * @param {Theme} theme
 */
function laws({ coulomb, epsilon_t }, shares, vertical, axis, theme) {
  const quiet = { color: theme.inkSoft, ...DASHED };
  const full = { color: theme.ink, width: 2 };
  if (vertical === "linear") {
    return [
      cutLine("coulomb", { x: shares, y: coulomb }, quiet, theme),
      cutLine("epsilon_t", { x: shares, y: epsilon_t }, full, theme),
    ];
  }
  const negative = { color: theme.negative, width: 2, dash: "7px,2px,2px,2px" };
  const runs = (/** @type {Float64Array} */ values, /** @type {1 | -1} */ sign) =>
    runsOfSign(shares, values, sign, axis);
  return [
    cutLine("coulomb", runs(coulomb, 1), quiet, theme),
    cutLine("epsilon_t", runs(epsilon_t, 1), full, theme),
    cutLine("epsilon_t, negative", runs(epsilon_t, -1), negative, theme),
  ];
}

/**
 * A line, out of sight where it has no points: Plotly leaves out a trace without any, and a drag would
 * have to draw everything anew.
 * @param {string} name
 * @param {{x: ArrayLike<number>, y: ArrayLike<number>}} points
 * @param {{color: string, width: number, dash?: string}} style
 * @param {Theme} theme
 */
function cutLine(name, { x, y }, style, { unit }) {
  const line = { simplify: false, ...style, width: style.width * unit };
  const points = y.length > 0 ? { x, y } : { x: [0, 1], y: [2, 2] };
  return { name, type: "scatter", mode: "lines", ...points, line };
}

/**
 * The letters of Fig. 5 and where they stand: undamped collisions at one κ, on a cut at it.
 * @param {Parameters<typeof cutFigure>[0]} subject
 */
function lettersOn({ view, along, held, muOverAlpha, letters }) {
  if (along === "kappa" || view.damping > 0) {
    return [];
  }
  const near = letters.filter(({ kappa }) => isNear(kappa, held));
  return near
    .map(({ letter, psi }) => ({ letter, share: view.gtOverGn.toShare(psi * muOverAlpha) }))
    .filter(({ share }) => share >= 0 && share <= 1);
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
