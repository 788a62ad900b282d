import assert from "node:assert/strict";
import { test } from "node:test";

import { placesAmong, spreadIndices } from "../../../frontend/figures/sample.js";
import { mapTable } from "../../../frontend/figures/tables.js";
import { cutTable, forceTable } from "../../../frontend/scenes/explorer/tables.js";
import { mapView } from "../../../frontend/state/map-view.js";

test("spreadIndices has both ends, what must not be missed, and each index once, in order", () => {
  assert.deepEqual(spreadIndices(101, 3, [7, 50]), [0, 7, 50, 100]);
  assert.deepEqual(spreadIndices(2, 40), [0, 1]);
  assert.deepEqual(spreadIndices(1, 40), [0]);
});

test("placesAmong finds the nearest, beyond the ends too", () => {
  assert.deepEqual(placesAmong([0, 1, 2, 4], [-5, 1.4, 3.5, 9]), [0, 1, 3, 3]);
});

test("forceTable holds every switch among its instants, with the regime that begins there", () => {
  const time = Float64Array.from({ length: 400 }, (_, i) => i / 100);
  const table = forceTable({
    time,
    normal_force: time,
    tangential_force_over_mu: time,
    switch_times: Float64Array.of(1.21),
    contact_duration: 3.99,
    episodes: [
      { regime: "sliding", start: 0, end: 1.21, direction: -1 },
      { regime: "sticking", start: 1.21, end: 3.99, direction: 0 },
    ],
  });
  assert.equal(table.rows.length, 41);
  assert.deepEqual(
    table.rows.find(([t]) => t === "1.210"),
    ["1.210", "1.210", "1.210", "sticks, from here"],
  );
  assert.equal(table.rows[0].at(-1), "slides back");
  assert.equal(table.rows.at(-1).at(-1), "sticks");
});

test("mapTable marks the row of the present collision and gives the cell nearest to it", () => {
  const kappa = Float64Array.from({ length: 30 }, (_, i) => i + 1);
  const gt_over_gn = Float64Array.from({ length: 20 }, (_, i) => i / 10);
  const epsilon_t = Array.from(gt_over_gn, (u) => Float64Array.from(kappa, (k) => u + k / 1000));
  const { headings, rows, here } = mapTable(
    { grid: { kappa, gt_over_gn, epsilon_t }, quantity: "epsilon_t" },
    { along: "g_t/g_n", here: 0.31, frame: "at μ/α = 1" },
    { kappa: 3.2, mu_over_alpha: 1, gt_over_gn: 0.31 },
  );
  assert.equal(rows[here][0], "0.300");
  assert.equal(rows[here][headings.indexOf("κ 3.00")], "0.303");
  assert.equal(rows[0].length, headings.length);
});

test("cutTable marks the row of the present collision and shows what a law does not say as absent", () => {
  const values = Float64Array.from({ length: 200 }, (_, i) => (i + 1) / 50);
  const law = values.map((u) => (u < 2 ? 0.1 : Number.NaN));
  const columns = { values, epsilon_t: values, switches: new Int32Array(200), coulomb: values };
  const cut = { ...columns, stiff_bound: law, stiff_asymptote: law };
  const collision = { kappa: 3.001, mu_over_alpha: 1.4, gt_over_gn: 1.003, damping: 0 };
  const view = mapView(collision, { scale: "linear", map_y: "gt_over_gn" });
  const axes = { cut, view, muOverAlpha: 1.4 };
  const { caption, headings, rows, here } = cutTable(
    { ...axes, along: "gt_over_gn", held: 3.001 },
    collision,
  );
  assert.match(caption, /^ε_t over g_t\/g_n at κ = 3\.001:/);
  assert.equal(headings[0], "g_t/g_n");
  assert.equal(rows[here][0], "1.000");
  assert.equal(rows.at(-1).at(-1), "–");
  const along = cutTable({ ...axes, along: "kappa", held: 1.003 }, collision);
  assert.match(along.caption, /^ε_t over κ at g_t\/g_n = 1\.003, μ\/α = 1\.400:/);
  assert.equal(along.headings[0], "κ");
  assert.equal(along.rows[along.here][0], "3.000");
});
