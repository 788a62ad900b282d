import assert from "node:assert/strict";
import { test } from "node:test";

import { errorMapFigure } from "../../../frontend/scenes/accuracy/error-map-figure.js";
import { seriesOf, tradeoffFigure } from "../../../frontend/scenes/accuracy/tradeoff-figure.js";
import { tradeoffTable } from "../../../frontend/scenes/accuracy/tables.js";
import { INTEGRATORS, METHODS } from "../../../frontend/state/accuracy.js";
import { horizontalAxis, mapView } from "../../../frontend/state/map-view.js";
import { SIZE, THEME } from "../fixtures.js";

const row = (method, options, changes = {}) => ({
  method,
  options,
  microseconds_per_collision: 10,
  error_median: 1e-6,
  error_p95: 1e-4,
  error_max: 1e-2,
  wrong_sign: 0.1,
  wrong_switches: null,
  ...changes,
});
const ROWS = [
  row("exact", {}, { error_p95: 0 }),
  row("timestep", { integrator: "velocity_verlet", steps: 50 }),
  row("timestep", { integrator: "velocity_verlet", steps: 500 }, { error_p95: 1e9 }),
  row("ode", { rtol: 1e-3 }),
  row("ode", { rtol: 1e-3, spring: "free" }),
  row("table", {}, { microseconds_per_collision: null, error_p95: null }),
];

test("seriesOf has a series for every method of the page", () => {
  for (const { id } of METHODS) {
    const options = id === "timestep" ? { integrator: INTEGRATORS[0].id, steps: 50 } : {};
    assert.equal(seriesOf([row(id, options)]).length, 1, id);
  }
});

test("seriesOf puts each row into one series and leaves out series without rows", () => {
  const series = seriesOf(ROWS);
  assert.deepEqual(
    series.map(({ rows }) => rows.length),
    [1, 2, 1, 1],
  );
});

test("tradeoffFigure places rows by the powers of ten of time and error, within its axes", () => {
  const figure = tradeoffFigure(
    { rows: ROWS, statistic: "error_p95", chosen: (each) => each.options.steps === 50 },
    THEME,
    SIZE,
  );
  const steps = figure.data.find(({ name }) => name.includes("Verlet"));
  assert.deepEqual(steps.x, [1, 1]);
  assert.deepEqual(steps.y, [-4, 1]);
  // What is beyond them stands at their end with its value.
  assert.deepEqual(steps.marker.symbol, ["circle", "arrow-up"]);
  const beyond = figure.data.find(({ name }) => name === "beyond the axis");
  assert.deepEqual(beyond.text, ["0 ↓", "1.0\u202f×\u202f10⁹ ↑"]);
  const [low, high] = figure.layout.yaxis.range;
  for (const { y } of figure.data) {
    assert.ok(y.every((height) => height >= low && height <= high));
  }
  assert.deepEqual(figure.data.at(-1).y, [-4]);
});

test("tradeoffTable has every row with its knobs", () => {
  const { rows } = tradeoffTable({ rows: ROWS, machine: "M", measured_at: "2026-01-02T03" });
  assert.equal(rows.length, ROWS.length);
  assert.equal(rows[1][0], "timestep, integrator velocity_verlet, steps 50");
  assert.equal(rows[1][6], "–");
});

test("errorMapFigure shows powers of ten, the lowest for none, and nothing for what is not known", () => {
  const view = mapView(
    { kappa: 1, mu_over_alpha: 1, gt_over_gn: 1 },
    { scale: "linear", map_y: "gt_over_gn" },
  );
  const errors = [Float64Array.of(0, -1e-3), Float64Array.of(NaN, 0.1)];
  const figure = errorMapFigure(
    { errors, view, horizontal: horizontalAxis(view, "kappa", 2 / 7) },
    THEME,
    SIZE,
  );
  const [[none, negative], [unknown, positive]] = figure.data[0].z;
  assert.equal(none, figure.data[0].zmin);
  assert.ok(Math.abs(negative + 3) < 1e-12 && Math.abs(positive + 1) < 1e-12);
  assert.equal(unknown, null);
});
