// @ts-check

import { lostShare } from "../format/energy.js";
import { ABSENT, errorBound, percentage, significant, typable } from "../format/number.js";
import { placesAmong, spreadIndices } from "./sample.js";

/**
 * A picture's numbers, as many as one can read. Headings and caption are texts with symbols as ε_t.
 * @typedef {object} Table
 * @property {string} caption
 * @property {string[]} headings of the columns, the first is that of the rows' own heads
 * @property {string[][]} rows
 * @property {number} [here] the row of the present collision
 */

/** Rows that sample a trace, to which its switches are added. */
const TRACE_ROWS = 40;
const SWITCH_ROWS = 60;
const CUT_ROWS = 30;
const MAP_ROWS = 12;
const MAP_COLUMNS = 8;

/** @typedef {import("../api/answers.js").Trace} Trace */

/** @param {import("../api/answers.js").CollisionAnswer} result @returns {Table} */
export function resultTable(result) {
  const { kappa, mu_over_alpha: mu, gt_over_gn: gt, damping, psi } = result.parameters;
  return {
    caption: `The collision: ${result.summary}`,
    headings: ["quantity", "value"],
    rows: [
      ["κ", typable(kappa)],
      ["μ/α", typable(mu)],
      ["g_t/g_n", typable(gt)],
      ["η", typable(damping)],
      ["ψ", significant(psi ?? Infinity)],
      ["ε_n", significant(result.epsilon_n, 8)],
      ["ε_t", significant(result.epsilon_t, 8)],
      ["error of ε_t", errorBound(result.error_bound)],
      ["switches", String(result.switches ?? ABSENT)],
      ["turns", String(result.reversals ?? ABSENT)],
      ["contact t_c", significant(result.contact_duration, 6)],
      ["energy lost", percentage(lostShare(result))],
      ["method", result.method],
    ],
  };
}

/** @param {Trace} trace @returns {Table} */
export function forceTable(trace) {
  return traceTable(trace, "Forces", {
    "F_t/μ": trace.tangential_force_over_mu,
    F_n: trace.normal_force,
  });
}

/** @param {Trace} trace @returns {Table} */
export function velocityTable(trace) {
  return traceTable(trace, "Tangential velocity", { "g_t(t)/g_n": trace.tangential_velocity });
}

/** @param {Trace} trace @returns {Table} */
export function contactTable(trace) {
  return traceTable(trace, "Compression of the spheres and stretch of the spring, scaled,", {
    compression: trace.compression,
    stretch: trace.spring_elongation,
  });
}

/**
 * @param {Trace} trace
 * @param {string} what
 * @param {Record<string, Float64Array>} columns
 * @returns {Table}
 */
function traceTable(trace, what, columns) {
  const { time, switch_times: switches } = trace;
  const marked = placesAmong(time, [...switches].slice(0, SWITCH_ROWS));
  const indices = spreadIndices(time.length, TRACE_ROWS, marked);
  const isSwitch = new Set(marked);
  return {
    caption: `${what} during the contact: ${indices.length} of ${time.length} instants, the switches among them. CSV and JSON hold all.`,
    headings: ["time", ...Object.keys(columns), "regime"],
    rows: indices.map((i) => [
      significant(time[i]),
      ...Object.values(columns).map((column) => significant(column[i])),
      `${regimeAt(trace, time[i])}${isSwitch.has(i) ? ", from here" : ""}`,
    ]),
  };
}

/**
 * The regime that holds or begins at an instant; the list of episodes may end before the contact does.
 * @param {Trace} trace
 * @param {number} instant
 */
function regimeAt({ episodes, contact_duration: duration }, instant) {
  const episode = episodes.find(
    ({ start, end }) => instant >= start && (instant < end || end >= duration),
  );
  if (!episode) {
    return "–";
  }
  if (episode.regime === "sticking") {
    return "sticks";
  }
  return episode.direction < 0 ? "slides back" : "slides";
}

/**
 * The cut and its simple laws, at every so many of its points and at the present collision.
 * @param {import("../api/answers.js").Cut} cut
 * @param {string} along what it runs over: g_t/g_n or ψ
 * @param {number} here the present collision there
 * @param {number} kappa
 * @returns {Table}
 */
export function cutTable(cut, along, here, kappa) {
  const [present] = placesAmong(cut.values, [here]);
  const indices = spreadIndices(cut.values.length, CUT_ROWS, [present]);
  return {
    caption: `ε_t over ${along} at κ = ${significant(kappa)}: ${indices.length} of ${cut.values.length} points, the one nearest to the present collision among them. CSV and JSON hold all.`,
    headings: [along, "ε_t", "switches", "Coulomb’s law", "stiff bound", "stiff limit"],
    rows: indices.map((i) => [
      significant(cut.values[i]),
      significant(cut.epsilon_t[i]),
      String(cut.switches[i]),
      significant(cut.coulomb[i]),
      significant(cut.stiff_bound[i]),
      significant(cut.stiff_asymptote[i]),
    ]),
    here: indices.indexOf(present),
  };
}

/**
 * ε_t over the velocities of real spheres, in every so many cells.
 * @param {import("../api/answers.js").VelocityMap} map
 * @returns {Table}
 */
export function velocityMapTable(map) {
  const { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential } = map;
  const columns = spreadIndices(normal.length, MAP_COLUMNS);
  const rows = spreadIndices(tangential.length, MAP_ROWS).reverse();
  return {
    caption:
      "ε_t over g_n (columns) and g_t (rows), both in m/s: some cells of the map. CSV and JSON hold all.",
    headings: ["g_t", ...columns.map((i) => `g_n ${significant(normal[i], 3)}`)],
    rows: rows.map((j) => [
      significant(tangential[j], 3),
      ...columns.map((i) => significant(map.epsilon_t[j][i], 3)),
    ]),
  };
}

/**
 * ε_t over the tangential velocity of real spheres.
 * @param {import("../api/answers.js").VelocityMap} map
 * @returns {Table}
 */
export function sphereCutTable({
  tangential_velocity_m_s: tangential,
  epsilon_t,
  coulomb,
  ...map
}) {
  const rows = spreadIndices(tangential.length, CUT_ROWS);
  return {
    caption: `ε_t over g_t in m/s at g_n = ${significant(map.normal_velocity_m_s[0])} m/s: ${rows.length} of ${tangential.length} points. CSV and JSON hold all.`,
    headings: ["g_t", "ε_t", "Coulomb’s law"],
    rows: rows.map((j) => [
      significant(tangential[j]),
      significant(epsilon_t[j][0]),
      significant(coulomb[j][0]),
    ]),
  };
}

/**
 * The force at the steps of a method.
 * @param {import("../api/answers.js").Stepped} stepped
 * @returns {Table}
 */
export function steppedTable({ method_time: time, method_tangential_force_over_mu: force }) {
  const indices = spreadIndices(time.length, TRACE_ROWS);
  return {
    caption: `Tangential force in time steps: ${indices.length} of ${time.length} instants. CSV and JSON hold the exact force, JSON the steps too.`,
    headings: ["time", "F_t/μ"],
    rows: indices.map((i) => [significant(time[i]), significant(force[i])]),
  };
}

/**
 * Every so many cells of the map, and those nearest to the present collision.
 * @param {{grid: import("../api/answers.js").MapGrid, quantity: "epsilon_t" | "switches"}} map
 * @param {{along: string, here: number, frame: string}} rows what they run over, where the present collision is, and what else holds
 * @param {import("../state/parameters.js").Collision} collision
 * @returns {Table}
 */
export function mapTable({ grid, quantity }, rows, collision) {
  const name = quantity === "switches" ? "Number of switches" : "ε_t";
  return gridTable(name, grid, grid[quantity], rows, collision);
}

/**
 * The error of a method in every so many cells.
 * @param {Float64Array[]} errors
 * @param {import("../state/map-view.js").MapView} view
 * @param {Parameters<typeof mapTable>[1]} rows
 * @param {import("../state/parameters.js").Collision} collision
 * @returns {Table}
 */
export function errorTable(errors, view, rows, collision) {
  const axes = {
    kappa: valuesOf(view.kappa, errors[0].length),
    gt_over_gn: valuesOf(view.gtOverGn, errors.length),
  };
  return gridTable("Error of ε_t", axes, errors, rows, collision);
}

/**
 * @param {import("../state/scales.js").Scale} scale
 * @param {number} count
 */
function valuesOf(scale, count) {
  return Float64Array.from({ length: count }, (_, i) => scale.fromShare(i / (count - 1)));
}

/**
 * @param {string} name
 * @param {{kappa: Float64Array, gt_over_gn: Float64Array}} axes
 * @param {(Float64Array | Int32Array)[]} cells
 * @param {Parameters<typeof mapTable>[1]} rows
 * @param {import("../state/parameters.js").Collision} collision
 * @returns {Table}
 */
function gridTable(name, axes, cells, { along, here, frame }, collision) {
  const { kappa, gt_over_gn: gtOverGn } = axes;
  const [column] = placesAmong(kappa, [collision.kappa]);
  const [row] = placesAmong(gtOverGn, [here]);
  const columns = spreadIndices(kappa.length, MAP_COLUMNS, [column]);
  const rows = spreadIndices(gtOverGn.length, MAP_ROWS, [row]).reverse();
  return {
    caption: `${name} over κ (columns) and ${along} (rows) ${frame}: some cells of the map, those nearest to the present collision among them. CSV and JSON hold all.`,
    headings: [along, ...columns.map((k) => `κ ${significant(kappa[k], 3)}`)],
    rows: rows.map((i) => [
      significant(gtOverGn[i], 3),
      ...columns.map((k) => significant(cells[i][k], 3)),
    ]),
    here: rows.indexOf(row),
  };
}
