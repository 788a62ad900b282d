// @ts-check

/** @typedef {{x: number[], y: number[]}} Line with a gap where its y is not a number */

/**
 * The runs of a curve that have one sign, as magnitudes on a logarithmic axis: each falls to the floor
 * where the curve goes through zero, half-way between samples by the straight line between them.
 * @param {ArrayLike<number>} x
 * @param {ArrayLike<number>} values
 * @param {1 | -1} sign
 * @param {Pick<import("./vertical-axis.js").VerticalAxis, "place" | "floor">} axis
 * @returns {Line}
 */
export function runsOfSign(x, values, sign, { place, floor }) {
  /** @type {Line} */
  const line = { x: [], y: [] };
  const add = (/** @type {number} */ at, /** @type {number} */ y) => {
    line.x.push(at);
    line.y.push(y);
  };
  const has = (/** @type {number} */ i) => sign * values[i] > 0;
  for (let i = 0; i < values.length; i += 1) {
    if (has(i) && i > 0 && sign * values[i - 1] <= 0) {
      add(zeroBetween(x, values, i - 1), floor);
    }
    if (has(i)) {
      add(x[i], place(values[i]));
    }
    if (has(i) && i + 1 < values.length && !has(i + 1)) {
      if (sign * values[i + 1] <= 0) {
        add(zeroBetween(x, values, i), floor);
      }
      add(x[i], NaN);
    }
  }
  return line;
}

/**
 * @param {ArrayLike<number>} x
 * @param {ArrayLike<number>} values of which two neighbours have no common sign
 * @param {number} i the first of them
 */
function zeroBetween(x, values, i) {
  const share = values[i] / (values[i] - values[i + 1]);
  return x[i] + share * (x[i + 1] - x[i]);
}

/**
 * The part of a limit that says something: it exists, and does not lie above another that says more.
 * @param {ArrayLike<number>} x
 * @param {Float64Array} y
 * @param {(i: number) => number} most that may lie at a sample
 * @returns {Line}
 */
export function telling(x, y, most) {
  const shown = [...y.keys()].filter((i) => y[i] <= most(i));
  return { x: shown.map((i) => x[i]), y: shown.map((i) => y[i]) };
}
