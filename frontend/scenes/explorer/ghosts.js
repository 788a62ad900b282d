// @ts-check

/**
 * The collisions that are pinned, as the pictures of the present one hold them. The axes reach as far
 * as they need, so that all of it is seen on one scale.
 * @typedef {object} Ghosts
 * @property {number} duration the longest
 * @property {number} tangentialForce the largest |F_t/μ|
 * @property {number} velocity the largest of those at the beginning
 * @property {number} leastVelocity
 * @property {(column: "tangential_force_over_mu" | "tangential_velocity", theme: Theme, factor?: number) => Record<string, any>[]} lines
 *   over time, drawn larger by a factor
 * @property {Ghosts["lines"]} letters of these lines, to be drawn over everything
 * @property {(placeOf: (ghost: Ghost) => import("../../state/scales.js").Place, figure: import("../../figures/plot-area.js").Figure, theme: Theme) => Record<string, any>[]} marks
 *   where they lie on a map or a cut
 * @property {(tableOf: (trace: import("../../api/answers.js").Trace) => Table) => Table[]} tables
 *
 * @typedef {{collision: import("../../state/parameters.js").Collision, epsilon_t: number}} Ghost
 * @typedef {import("../../figures/theme.js").Theme} Theme
 * @typedef {import("../../figures/tables.js").Table} Table
 */

/** @type {Ghosts} */
export const NO_GHOSTS = {
  duration: 0,
  tangentialForce: 0,
  velocity: 0,
  leastVelocity: 0,
  lines: () => [],
  letters: () => [],
  marks: () => [],
  tables: () => [],
};

/**
 * What is pinned, over what a sweep leaves behind, which has lines alone.
 * @param {Ghosts} trails
 * @param {Ghosts} pinned
 * @returns {Ghosts}
 */
export function over(trails, pinned) {
  return {
    ...pinned,
    duration: Math.max(trails.duration, pinned.duration),
    tangentialForce: Math.max(trails.tangentialForce, pinned.tangentialForce),
    velocity: Math.max(trails.velocity, pinned.velocity),
    leastVelocity: Math.min(trails.leastVelocity, pinned.leastVelocity),
    lines: (...how) => [...trails.lines(...how), ...pinned.lines(...how)],
  };
}
