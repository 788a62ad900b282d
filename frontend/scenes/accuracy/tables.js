// @ts-check

import { spreadIndices } from "../../figures/sample.js";
import { gridTable } from "../../figures/tables.js";
import { percentage, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { titleOf } from "../../state/accuracy.js";
import { STATISTICS } from "../../state/tradeoff-options.js";

/** @typedef {import("../../figures/tables.js").Table} Table */

const TRACE_ROWS = 40;

/**
 * All that was measured in a region.
 * @param {import("../../api/answers.js").Tradeoff} tradeoff
 * @returns {Table}
 */
export function tradeoffTable({ rows, machine, measured_at: measuredAt }) {
  return {
    caption: say("tradeoff.table.caption", { date: measuredAt.slice(0, 10), machine }),
    headings: [
      say("tradeoff.table.method"),
      "µs",
      ...["median", "p95", "max"].map((id) => titleOf(STATISTICS, id)),
      say("tradeoff.wrongSign"),
      say("tradeoff.wrongSwitches"),
    ],
    rows: rows.map((row) => [
      [row.method, ...Object.entries(row.options).map(([knob, value]) => `${knob} ${value}`)].join(
        ", ",
      ),
      significant(row.microseconds_per_collision ?? NaN, 2),
      significant(row.error_median ?? NaN, 2),
      significant(row.error_p95 ?? NaN, 2),
      significant(row.error_max ?? NaN, 2),
      percentage(row.wrong_sign ?? NaN),
      percentage(row.wrong_switches ?? NaN),
    ]),
  };
}

/**
 * The force at the steps of a method.
 * @param {import("../../api/answers.js").Stepped} stepped
 * @returns {Table}
 */
export function steppedTable({ method_time: time, method_tangential_force_over_mu: force }) {
  const indices = spreadIndices(time.length, TRACE_ROWS);
  return {
    caption: say("overlay.table", { shown: indices.length, all: time.length }),
    headings: [say("trace.time"), "F_t/μ"],
    rows: indices.map((i) => [significant(time[i]), significant(force[i])]),
  };
}

/**
 * The error of a method in every so many cells.
 * @param {Float64Array[]} errors
 * @param {import("../../state/map-view.js").MapView} view
 * @param {Parameters<typeof gridTable>[3]} rows
 * @param {import("../../state/parameters.js").Collision} collision
 * @returns {Table}
 */
export function errorTable(errors, view, rows, collision) {
  const axes = {
    kappa: valuesOf(view.kappa, errors[0].length),
    gt_over_gn: valuesOf(view.gtOverGn, errors.length),
  };
  return gridTable(say("errorMap.table"), axes, errors, rows, collision);
}

/**
 * @param {import("../../state/scales.js").Scale} scale
 * @param {number} count
 */
function valuesOf(scale, count) {
  return Float64Array.from({ length: count }, (_, i) => scale.fromShare(i / (count - 1)));
}

/**
 * What each code takes, without what there is to say of its law.
 * @param {import("../../api/answers.js").CodesAnswer} answer
 * @returns {Table}
 */
export function codesTable({ codes }) {
  return {
    caption: say("codes.table.caption"),
    headings: [
      say("codes.table.code"),
      say("codes.table.law"),
      "κ",
      "ε_t",
      say("codes.table.input"),
    ],
    rows: codes.map(({ code, style, kappa, epsilon_t, lines }) => [
      code,
      style,
      significant(kappa),
      significant(epsilon_t),
      lines.join("; "),
    ]),
  };
}
