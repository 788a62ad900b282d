import assert from "node:assert/strict";
import { test } from "node:test";

import { surfaceFigure } from "../../../frontend/figures/surface-figure.js";
import { horizontalAxis, mapView } from "../../../frontend/state/map-view.js";
import { SIZE, THEME } from "../fixtures.js";

const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };
const [COLUMNS, ROWS] = [240, 180];
const GRID = {
  kappa: new Float64Array(COLUMNS),
  gt_over_gn: new Float64Array(ROWS),
  epsilon_t: Array.from({ length: ROWS }, (_, j) =>
    Float64Array.from({ length: COLUMNS }, (__, i) => i / COLUMNS - j / ROWS),
  ),
  switches: Array.from({ length: ROWS }, () => new Int32Array(COLUMNS)),
};

function figure(place = null, quantity = "epsilon_t") {
  const view = mapView(AT, { scale: "linear", map_y: "gt_over_gn" });
  const horizontal = horizontalAxis(view, "kappa", 2 / 7);
  return surfaceFigure({ grid: GRID, view, horizontal, quantity, place }, THEME, SIZE);
}

test("surfaceFigure shows values of the grid where they belong, but fewer, from corner to corner", () => {
  const { x, y, z } = figure().data[0];
  assert.ok(x.length * y.length < 5000);
  assert.deepEqual([x[0], x.at(-1), y[0], y.at(-1)], [0, 1, 0, 1]);
  for (const [j, row] of z.entries()) {
    for (const [i, value] of row.entries()) {
      const place = [Math.round(y[j] * (ROWS - 1)), Math.round(x[i] * (COLUMNS - 1))];
      assert.equal(value, GRID.epsilon_t[place[0]][place[1]]);
    }
  }
});

test("surfaceFigure marks the present collision at its height, once that is known", () => {
  const place = { x: 0.3, y: 0.4, epsilon_t: -0.2, switches: null };
  const point = (...args) => {
    const { x, y, z } = figure(...args).data[1];
    return [x, y, z];
  };
  assert.deepEqual(point(place), [[0.3], [0.4], [-0.2]]);
  assert.deepEqual(point(place, "switches"), [[], [], []]);
  assert.deepEqual(point(null), [[], [], []]);
});
