// @ts-check

/**
 * What a map that is on the page knows of a collision, until its exact answer is here.
 * @typedef {object} MapReading
 * @property {number} epsilon_t
 * @property {number} switches of the nearest cell
 */

/**
 * Looks a collision up in a map, perhaps of another μ/α: ε_t and the switches depend on κ and
 * ψ = (g_t/g_n)/(μ/α) alone, so the row of the same ψ is the right one. ε_t is continuous, even where
 * the switches change, and is read between the cells: on the usual map with a median error of 0.001,
 * and of up to 0.2 in its first column, where κ doubles from one cell to the next.
 *
 * @param {{grid: import("../../api/answers.js").MapGrid, muOverAlpha: number, view: {damping: number}}} map
 * @param {import("../../state/parameters.js").Collision} collision
 * @returns {MapReading | null} null beyond the map, and for another damping
 */
export function readMap(
  { grid, muOverAlpha, view },
  { kappa, mu_over_alpha, gt_over_gn, damping },
) {
  if (view.damping !== damping) {
    return null;
  }
  const column = placeAmong(grid.kappa, kappa);
  const row = placeAmong(grid.gt_over_gn, gt_over_gn * (muOverAlpha / mu_over_alpha));
  if (!column || !row) {
    return null;
  }
  const nearestRow = row.rest < 0.5 ? row.below : row.below + 1;
  const nearestColumn = column.rest < 0.5 ? column.below : column.below + 1;
  const switches = grid.switches[nearestRow][nearestColumn];
  return { epsilon_t: between(grid.epsilon_t, row, column), switches };
}

/**
 * @param {Float64Array} values ascending
 * @param {number} value
 * @returns {{below: number, rest: number} | null} the index before it and the share of the step after it
 */
function placeAmong(values, value) {
  let low = 0;
  let high = values.length - 1;
  if (!(value >= values[low] && value <= values[high])) {
    return null;
  }
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= value) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return { below: low, rest: (value - values[low]) / (values[high] - values[low]) };
}

/**
 * @param {Float64Array[]} cells
 * @param {{below: number, rest: number}} row
 * @param {{below: number, rest: number}} column
 */
function between(cells, row, column) {
  const [low, high] = [cells[row.below], cells[row.below + 1]].map(
    (line) => line[column.below] + column.rest * (line[column.below + 1] - line[column.below]),
  );
  return low + row.rest * (high - low);
}
