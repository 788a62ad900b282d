// @ts-check

import { decimalMark, say } from "../format/words.js";

/**
 * @typedef {{width: number, height: number}} Size in CSS pixels
 * @typedef {import("./theme.js").Theme} Theme
 * @typedef {{data: Record<string, any>[], layout: Record<string, any>}} Figure
 */

/** Margins are fixed, so that whoever lays something over a plot knows where its axes are: in pixels of the design. */
export const TRACE_MARGIN = { l: 48, r: 14, t: 6, b: 38 };
export const MAP_MARGIN = { l: 60, r: 20, t: 8, b: 46 };
export const CUT_MARGIN = { l: 60, r: 20, t: 6, b: 46 };

/**
 * Width and height between the axes.
 * @param {Size} size
 * @param {{l: number, r: number, t: number, b: number}} margin
 * @param {Theme} theme
 */
export function innerSize({ width, height }, { l, r, t, b }, { unit, words }) {
  return {
    width: Math.max(1, width - unit * (l + r)),
    height: Math.max(1, height - unit * (t + b * words)),
  };
}

/**
 * What all plots of the page have in common.
 * @param {Theme} theme
 * @param {Size} size
 * @param {{l: number, r: number, t: number, b: number}} margin
 */
export function baseLayout(theme, { width, height }, margin) {
  return {
    width,
    height,
    margin: {
      l: theme.unit * margin.l,
      r: theme.unit * margin.r,
      t: theme.unit * margin.t,
      b: theme.unit * margin.b * theme.words,
      pad: 0,
    },
    autosize: false,
    showlegend: false,
    hovermode: false,
    dragmode: false,
    barmode: "overlay",
    separators: `${decimalMark()} `,
    paper_bgcolor: "rgba(0,0,0,0)",
    plot_bgcolor: "rgba(0,0,0,0)",
    font: { family: theme.sans, size: 12 * theme.unit, color: theme.inkSoft },
  };
}

/**
 * An axis with ticks outside, no frame and no grid.
 * @param {Theme} theme
 * @param {[number, number]} range
 * @param {number[]} tickvals
 * @param {string[]} ticktext
 */
export function plainAxis(theme, range, tickvals, ticktext) {
  return {
    range,
    fixedrange: true,
    autorange: false,
    showgrid: false,
    zeroline: false,
    showline: false,
    tickmode: "array",
    tickvals,
    ticktext,
    ticks: "outside",
    ticklen: 4 * theme.unit,
    tickwidth: 1,
    tickcolor: theme.ruleStrong,
    automargin: false,
    ticklabeloverflow: "allow",
    tickangle: 0,
  };
}

/** A mark at the very end of the contact would else fall to rounding. */
const END_INCLUDED = 1 + 1e-9;

/**
 * The axis of time, the same in every view.
 * @param {Theme} theme
 * @param {number} contactDuration
 */
export function timeAxis(theme, contactDuration) {
  const step = contactDuration > 8 ? 2 : 1;
  const ticks = Array.from({ length: Math.floor(contactDuration / step) + 1 }, (_, i) => i * step);
  return {
    ...plainAxis(theme, [0, END_INCLUDED * contactDuration], ticks, ticks.map(String)),
    title: {
      text: say("trace.axis", { t: "<i>t</i>" }),
      standoff: 4 * theme.unit,
      font: { size: 12 * theme.unit * theme.words },
    },
  };
}

/** Undamped, the normal force reaches 1.14; the axis stays where it is unless a force goes beyond. */
const USUAL_REACH = 1.2;

/**
 * How far an axis of force goes to either side.
 * @param {...Float64Array} forces
 */
export function forceReach(...forces) {
  const largest = forces.map((values) =>
    values.reduce((most, value) => Math.max(most, Math.abs(value)), 0),
  );
  return Math.max(USUAL_REACH, 1.05 * Math.max(...largest));
}

/**
 * What an axis is, beside it.
 * @param {string} text
 * @param {number} standoff in pixels of the design, as the size of the type
 * @param {Theme} theme
 * @param {number} [type]
 */
export function axisTitle(text, standoff, { unit, words, ink }, type = 14) {
  return { text, standoff: standoff * unit, font: { size: type * unit * words, color: ink } };
}
