// @ts-check

import { percentage, significant } from "../format/number.js";

/**
 * All that was measured in a region.
 * @param {import("../api/answers.js").Tradeoff} tradeoff
 * @returns {import("./tables.js").Table}
 */
export function tradeoffTable({ rows, machine, measured_at: measuredAt }) {
  return {
    caption: `Time per collision and error of ε_t, measured ${measuredAt.slice(0, 10)} on ${machine}.`,
    headings: ["method", "µs", "median", "95 %", "worst", "wrong sign", "wrong switches"],
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
