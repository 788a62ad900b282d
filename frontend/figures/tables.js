// @ts-check

import { significant } from "../format/number.js";
import { TEXT_SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import { placesAmong, spreadIndices } from "./sample.js";

/**
 * A picture's numbers, as many as one can read. Headings and caption are texts with symbols as ε_t.
 * @typedef {object} Table
 * @property {string} caption
 * @property {string[]} headings of the columns, the first is that of the rows' own heads
 * @property {string[][]} rows
 * @property {number} [here] the row of the present collision
 */

export const MAP_ROWS = 12;
export const MAP_COLUMNS = 8;

/**
 * Every so many cells of the map, and those nearest to the present collision.
 * @param {{grid: import("../api/answers.js").MapGrid, quantity: "epsilon_t" | "switches"}} map
 * @param {{along: string, here: number, frame: string}} rows what they run over, where the present collision is, and what else holds
 * @param {import("../state/parameters.js").Collision} collision
 * @returns {Table}
 */
export function mapTable({ grid, quantity }, rows, collision) {
  const name = quantity === "switches" ? say("map.switchesCount") : TEXT_SYMBOLS.epsilon_t;
  return gridTable(name, grid, grid[quantity], rows, collision);
}

/**
 * Every so many cells of something over the axes of the map.
 * @param {string} name
 * @param {{kappa: Float64Array, gt_over_gn: Float64Array}} axes
 * @param {(Float64Array | Int32Array)[]} cells
 * @param {Parameters<typeof mapTable>[1]} rows
 * @param {import("../state/parameters.js").Collision} collision
 * @returns {Table}
 */
export function gridTable(name, axes, cells, { along, here, frame }, collision) {
  const { kappa, gt_over_gn: gtOverGn } = axes;
  const [column] = placesAmong(kappa, [collision.kappa]);
  const [row] = placesAmong(gtOverGn, [here]);
  const columns = spreadIndices(kappa.length, MAP_COLUMNS, [column]);
  const rows = spreadIndices(gtOverGn.length, MAP_ROWS, [row]).reverse();
  return {
    caption: say("map.caption", { name, along, frame }),
    headings: [along, ...columns.map((k) => `κ ${significant(kappa[k], 3)}`)],
    rows: rows.map((i) => [
      significant(gtOverGn[i], 3),
      ...columns.map((k) => significant(cells[i][k], 3)),
    ]),
    here: rows.indexOf(row),
  };
}
