// @ts-check

import { baseLayout, plainAxis } from "../../figures/plot-area.js";
import { brief, powerOfTen, significant } from "../../format/number.js";
import { PLOT_SYMBOLS } from "../../format/symbols.js";
import { say } from "../../format/words.js";
import { METHODS, titleOf } from "../../state/accuracy.js";

/**
 * @typedef {import("../../figures/theme.js").Theme} Theme
 * @typedef {"error_median" | "error_p95" | "error_max"} Statistic
 * @typedef {import("../../api/answers.js").Row} Row its numbers are null where the method refused every collision
 * @typedef {Row & Record<"microseconds_per_collision" | "wrong_sign" | Statistic, number>} AnsweredRow
 */

export const TRADEOFF_MARGIN = { l: 64, r: 16, t: 8, b: 46 };
/** Below this width every other power of ten has room, in pixels of the design. */
const NARROW = 400;

/** Below the rounding of a double there is nothing to tell apart. */
const LEAST_ERROR = 1e-16;
const MOST_ERROR = 10;
/** So many powers of ten a line of words takes. */
const LINE = 2;

/**
 * The series of the plot: which rows belong to them, and how they are drawn. Those that are not a method as
 * a whole have a name of their own.
 * @type {{method: string, own?: string, has: (row: Row) => boolean, color: keyof Theme, dash?: string, symbol: string}[]}
 */
const SERIES = [
  { method: "auto", has: is("auto"), color: "ink", dash: "dot", symbol: "circle-open" },
  { method: "exact", has: is("exact"), color: "ink", symbol: "star" },
  { method: "table", has: is("table"), color: "methodTable", symbol: "square" },
  { method: "stiff", has: is("stiff"), color: "inkSoft", symbol: "diamond" },
  { method: "coulomb", has: is("coulomb"), color: "inkSoft", symbol: "x" },
  {
    // Symplectic Euler gives the same numbers: no force acts before or after the contact.
    method: "timestep",
    own: "tradeoff.series.verlet",
    has: is("timestep", { integrator: "velocity_verlet" }),
    color: "methodSteps",
    symbol: "circle",
  },
  {
    method: "timestep",
    own: "tradeoff.series.forward_euler",
    has: is("timestep", { integrator: "forward_euler" }),
    color: "methodEuler",
    symbol: "circle",
  },
  {
    method: "ode",
    own: "tradeoff.series.ode_found",
    has: is("ode", { spring: undefined }),
    color: "methodOde",
    symbol: "triangle-up",
  },
  {
    method: "ode",
    own: "tradeoff.series.ode_ignored",
    has: is("ode", { spring: "held" }),
    color: "methodOde",
    dash: "dash",
    symbol: "triangle-up-open",
  },
  {
    method: "ode",
    own: "tradeoff.series.ode_printed",
    has: is("ode", { spring: "free" }),
    color: "methodOde",
    dash: "dot",
    symbol: "triangle-down-open",
  },
  { method: "LAMMPS", has: is("lammps"), color: "methodPeer", symbol: "hexagon" },
];

/**
 * Error against time of every method and knob, both logarithmic: what is further down and left is better.
 * @param {{rows: Row[], statistic: Statistic, chosen: (row: Row) => boolean}} subject
 * @param {Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function tradeoffFigure({ rows, statistic, chosen }, theme, size) {
  const drawn = seriesOf(rows);
  const answered = drawn.flatMap((series) => series.rows);
  const times = answered.map((row) => Math.log10(row.microseconds_per_collision));
  const [fastest, slowest] = [Math.floor(Math.min(...times)), Math.ceil(Math.max(...times))];
  const [low, high] = [LEAST_ERROR, MOST_ERROR].map(Math.log10);
  const beyond = extremes(answered, statistic, theme);
  const text = { standoff: 4 * theme.unit, font: { size: 12 * theme.unit } };
  return {
    data: [
      ...drawn.map((series) => line(series, statistic, theme)),
      beyond,
      ring(answered.filter(chosen), statistic, theme),
    ],
    layout: {
      ...baseLayout(theme, size, TRADEOFF_MARGIN),
      hovermode: "closest",
      hoverlabel: {
        bgcolor: theme.paper,
        bordercolor: theme.ruleStrong,
        font: { family: theme.sans, size: 12 * theme.unit, color: theme.ink },
        align: "left",
      },
      xaxis: {
        ...decades(theme, fastest, slowest, size.width < NARROW * theme.unit ? 2 : 1),
        title: { text: say("tradeoff.time"), ...text },
      },
      yaxis: {
        ...withRoomFor(beyond, decades(theme, low, high, 2)),
        title: {
          text: say("tradeoff.error", { epsilon_t: PLOT_SYMBOLS.epsilon_t }),
          ...text,
        },
      },
    },
  };
}

/**
 * The series that have rows with numbers, in the order of the legend.
 * @param {Row[]} rows
 */
export function seriesOf(rows) {
  const answered = /** @type {AnsweredRow[]} */ (
    rows.filter((row) => row.microseconds_per_collision !== null)
  );
  return SERIES.map((series) => ({
    ...series,
    name: series.own ? say(series.own) : titleOf(METHODS, series.method),
    rows: answered.filter(series.has),
  })).filter(({ rows: own }) => own.length > 0);
}

/**
 * @param {ReturnType<typeof seriesOf>[number]} series
 * @param {Statistic} statistic
 * @param {Theme} theme
 */
function line({ name, rows, color, dash = "solid", symbol }, statistic, theme) {
  const ink = /** @type {string} */ (theme[color]);
  return {
    name,
    type: "scatter",
    mode: rows.length > 1 ? "lines+markers" : "markers",
    x: rows.map((row) => Math.log10(row.microseconds_per_collision)),
    y: rows.map((row) => heightOf(row[statistic])),
    customdata: rows,
    hovertemplate: rows.map((row) => describe(name, row)),
    line: { width: 1.75 * theme.unit, color: ink, dash },
    marker: {
      size: 8 * theme.unit,
      color: ink,
      symbol: rows.map((row) => arrowOf(row[statistic]) ?? symbol),
      line: { width: 1.5 * theme.unit, color: ink },
    },
    cliponaxis: false,
  };
}

/**
 * Around what the page is set to.
 * @param {AnsweredRow[]} rows
 * @param {Statistic} statistic
 * @param {Theme} theme
 */
function ring(rows, statistic, theme) {
  return {
    name: "chosen",
    type: "scatter",
    mode: "markers",
    x: rows.map((row) => Math.log10(row.microseconds_per_collision)),
    y: rows.map((row) => heightOf(row[statistic])),
    hoverinfo: "skip",
    marker: {
      size: 18 * theme.unit,
      color: "rgba(0,0,0,0)",
      line: { width: 2 * theme.unit, color: theme.ink },
    },
  };
}

/**
 * @param {string} name
 * @param {AnsweredRow} row
 */
function describe(name, row) {
  const knobs = Object.entries(row.options)
    .filter(([, value]) => typeof value === "number")
    .map(([knob, value]) => say(`tradeoff.knobs.${knob}`, { value: brief(Number(value)) }));
  const wrong = [`${say("tradeoff.wrongSign")} ${short(100 * row.wrong_sign)} %`];
  if (row.wrong_switches !== null) {
    wrong.push(`${say("tradeoff.wrongSwitches")} ${short(100 * row.wrong_switches)} %`);
  }
  const errors = {
    median: short(row.error_median),
    p95: short(row.error_p95),
    max: short(row.error_max),
  };
  return [
    `<b>${[name, ...knobs].join(", ")}</b>`,
    `${short(row.microseconds_per_collision)} µs`,
    say("tradeoff.errors", errors),
    `${wrong.join(", ")}<extra></extra>`,
  ].join("<br>");
}

/** @param {number} value */
function short(value) {
  return brief(Number(value.toPrecision(2)));
}

/**
 * How an error is marked that lies beyond the axis, at its end.
 * @param {number} error
 */
function arrowOf(error) {
  if (error > MOST_ERROR) {
    return "arrow-up";
  }
  return error < LEAST_ERROR ? "arrow-down" : null;
}

/**
 * The largest and the smallest error beyond the axis, beside their marks; of the others, the table and
 * the pointer tell.
 * @param {AnsweredRow[]} rows
 * @param {Statistic} statistic
 * @param {Theme} theme
 */
function extremes(rows, statistic, theme) {
  const sorted = [...rows].sort((a, b) => a[statistic] - b[statistic]);
  const ends = [...sorted.slice(0, 1), ...sorted.slice(-1)];
  const told = ends.filter((row) => arrowOf(row[statistic]));
  return {
    name: "beyond the axis",
    type: "scatter",
    mode: "text",
    x: told.map((row) => Math.log10(row.microseconds_per_collision)),
    y: told.map((row) => heightOf(row[statistic])),
    text: told.map((row) => `${significant(row[statistic], 2)} ${row[statistic] > 1 ? "↑" : "↓"}`),
    textposition: told.map((row) => (row[statistic] > 1 ? "top right" : "bottom right")),
    textfont: { size: 11 * theme.unit, color: theme.ink },
    hoverinfo: "skip",
    cliponaxis: false,
  };
}

/**
 * An axis of errors with a line free for what is written beyond its ends.
 * @param {{y: number[]}} beyond
 * @param {ReturnType<typeof decades>} axis
 */
function withRoomFor({ y }, axis) {
  const [low, high] = axis.range;
  const ends = [Math.min(...y, low + LINE), Math.max(...y, high - LINE)];
  return { ...axis, range: [ends[0] - LINE, ends[1] + LINE] };
}

/** @param {number} error */
function heightOf(error) {
  return Math.log10(Math.min(MOST_ERROR, Math.max(LEAST_ERROR, error)));
}

/**
 * @param {Theme} theme
 * @param {number} first
 * @param {number} last
 * @param {number} step
 */
function decades(theme, first, last, step) {
  const count = Math.floor((last - first) / step) + 1;
  const powers = Array.from({ length: count }, (_, i) => first + step * i);
  return {
    ...plainAxis(theme, [first - 0.25, last + 0.25], powers, powers.map(powerOfTen)),
    showgrid: true,
    gridcolor: theme.grid,
    gridwidth: 1,
  };
}

/**
 * @param {string} method
 * @param {Record<string, string | undefined>} [options]
 * @returns {(row: Row) => boolean}
 */
function is(method, options = {}) {
  return (row) =>
    row.method === method &&
    Object.entries(options).every(([knob, value]) => row.options[knob] === value);
}
