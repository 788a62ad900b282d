import assert from "node:assert/strict";
import { test } from "node:test";

import { readMap } from "../../../frontend/scenes/explorer/map-reading.js";

/** Cells of ε_t = κ/10 + g_t/g_n, with a border of switches between g_t/g_n = 2 and 3. */
const kappa = Float64Array.of(1, 2, 4);
const ratios = Float64Array.of(1, 2, 3, 4);
const MAP = {
  muOverAlpha: 1,
  view: { damping: 0 },
  grid: {
    kappa,
    gt_over_gn: ratios,
    epsilon_t: [...ratios].map((gt) => kappa.map((k) => k / 10 + gt)),
    switches: [...ratios].map((gt) => Int32Array.from(kappa, () => (gt < 2.5 ? 4 : 2))),
  },
};
const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-12, `${value}`);

test("readMap reads ε_t between the cells", () => {
  const there = readMap(MAP, { kappa: 3, mu_over_alpha: 1, gt_over_gn: 1.5, damping: 0 });
  near(there.epsilon_t, 1.8);
  assert.equal(there.switches, 4);
  near(readMap(MAP, { kappa: 4, mu_over_alpha: 1, gt_over_gn: 4, damping: 0 }).epsilon_t, 4.4);
});

test("readMap takes the switches of the nearest cell, for counts have nothing between them", () => {
  const switchesAt = (gt_over_gn) =>
    readMap(MAP, { kappa: 1, mu_over_alpha: 1, gt_over_gn, damping: 0 }).switches;
  assert.deepEqual([2.4, 2.6].map(switchesAt), [4, 2]);
});

test("readMap finds another μ/α at the same ψ", () => {
  const at = (mu_over_alpha, gt_over_gn) =>
    readMap(MAP, { kappa: 2, mu_over_alpha, gt_over_gn, damping: 0 });
  near(at(2, 3).epsilon_t, at(1, 1.5).epsilon_t);
  assert.equal(at(2, 8).switches, 2);
  assert.equal(at(2, 9), null);
});

test("readMap knows nothing beyond its cells, nor without friction", () => {
  assert.equal(readMap(MAP, { kappa: 5, mu_over_alpha: 1, gt_over_gn: 2, damping: 0 }), null);
  assert.equal(readMap(MAP, { kappa: 2, mu_over_alpha: 1, gt_over_gn: 0, damping: 0 }), null);
  assert.equal(readMap(MAP, { kappa: 2, mu_over_alpha: 0, gt_over_gn: 2, damping: 0 }), null);
  assert.equal(readMap(MAP, { kappa: 2, mu_over_alpha: 0, gt_over_gn: 0, damping: 0 }), null);
});

test("readMap knows nothing of another damping", () => {
  assert.equal(readMap(MAP, { kappa: 2, mu_over_alpha: 1, gt_over_gn: 2, damping: 0.1 }), null);
});
