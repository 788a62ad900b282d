// @ts-check

import { spreadIndices } from "../../figures/sample.js";
import { MAP_COLUMNS, MAP_ROWS } from "../../figures/tables.js";
import { significant } from "../../format/number.js";
import { say } from "../../format/words.js";

/** @typedef {import("../../figures/tables.js").Table} Table */

const CUT_ROWS = 30;

/**
 * ε_t over the velocities of real spheres, in every so many cells.
 * @param {import("../../api/answers.js").VelocityMap} map
 * @returns {Table}
 */
export function velocityMapTable(map) {
  const { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential } = map;
  const columns = spreadIndices(normal.length, MAP_COLUMNS);
  const rows = spreadIndices(tangential.length, MAP_ROWS).reverse();
  return {
    caption: say("spheres.velocities.table"),
    headings: ["g_t", ...columns.map((i) => `g_n ${significant(normal[i], 3)}`)],
    rows: rows.map((j) => [
      significant(tangential[j], 3),
      ...columns.map((i) => significant(map.epsilon_t[j][i], 3)),
    ]),
  };
}

/**
 * ε_t over the tangential velocity of real spheres.
 * @param {import("../../api/answers.js").VelocityMap} map
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
    caption: say("spheres.cut.table", {
      velocity: significant(map.normal_velocity_m_s[0]),
      shown: rows.length,
      all: tangential.length,
    }),
    headings: ["g_t", "ε_t", say("methods.coulomb")],
    rows: rows.map((j) => [
      significant(tangential[j]),
      significant(epsilon_t[j][0]),
      significant(coulomb[j][0]),
    ]),
  };
}
