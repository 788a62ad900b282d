import assert from "node:assert/strict";
import { test } from "node:test";

import {
  axesMuOverAlpha,
  collisionAt,
  gtOverGnAt,
  horizontalAxis,
  mapView,
  scaleFor,
  placeOnMap,
  sameView,
} from "../../../frontend/state/map-view.js";
import { SOLID_ALPHA } from "../../../frontend/state/parameters.js";
import { isBeyond } from "../../../frontend/state/scales.js";
import { seeded } from "../random.js";

const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };
const LINEAR = { scale: "linear", map_y: "gt_over_gn" };
const LOG = { scale: "log", map_y: "gt_over_gn" };
const OVER_PSI = { scale: "linear", map_y: "psi" };

test("collisionAt and placeOnMap undo one another, to the four digits of a click", () => {
  const next = seeded(6);
  for (const options of [LINEAR, LOG, OVER_PSI, { ...LOG, map_y: "psi" }]) {
    const view = mapView(AT, options);
    for (let i = 0; i < 200; i += 1) {
      const [x, y] = [next(), next()];
      const place = placeOnMap(view, { ...AT, ...collisionAt(view, x, y, AT.mu_over_alpha) });
      assert.ok(Math.hypot(place.x - x, place.y - y) < 1e-3);
    }
  }
});

test("mapView takes the paper's axes where they hold the collision", () => {
  const { kappa, gtOverGn } = mapView(AT, LINEAR);
  assert.deepEqual([kappa.min, kappa.max, gtOverGn.min, gtOverGn.max], [0.1, 70, 0.01, 4]);
});

test("mapView reaches a collision beyond the usual axes", () => {
  assert.equal(mapView({ ...AT, kappa: 100 }, LINEAR).kappa.max, 100);
  assert.equal(mapView({ ...AT, kappa: 101 }, LINEAR).kappa.max, 200);
  const view = mapView({ ...AT, kappa: 37_204, gt_over_gn: 1e-3 }, LOG);
  assert.equal(view.kappa.max, 50_000);
  assert.equal(view.gtOverGn.min, 1e-3);
  assert.ok(!isBeyond(placeOnMap(view, { ...AT, kappa: 37_204, gt_over_gn: 1e-3 })));
});

test("scaleFor keeps the scale unless the collision is beyond its axes", () => {
  assert.equal(scaleFor({ ...AT, kappa: 1000 }, LINEAR), "linear");
  assert.equal(scaleFor({ ...AT, kappa: 2000 }, LINEAR), "log");
  assert.equal(scaleFor(AT, LOG), "log");
});

test("mapView does not stretch without end: there the collision stands at the edge", () => {
  for (const options of [LINEAR, LOG]) {
    const extreme = { ...AT, kappa: 1.7e308, gt_over_gn: 0 };
    const view = mapView(extreme, options);
    assert.ok(sameView(view, mapView(AT, options)));
    assert.deepEqual(placeOnMap(view, extreme), {
      x: 1,
      y: 0,
      beyond: { x: 1, y: options.scale === "log" ? -1 : 0 },
    });
  }
});

test("collisionAt keeps a drag beyond the frame within it", () => {
  const view = mapView(AT, LINEAR);
  assert.deepEqual(collisionAt(view, 1.3, -0.2, 1.4), { kappa: 70, gt_over_gn: 0.01 });
});

test("placeOnMap does not call beyond what the eye takes for the edge", () => {
  const linear = placeOnMap(mapView(AT, LINEAR), { ...AT, gt_over_gn: 0 });
  assert.deepEqual([linear.y, linear.beyond.y], [0, 0]);
  const log = placeOnMap(mapView(AT, LOG), { ...AT, gt_over_gn: 0 });
  assert.deepEqual([log.y, log.beyond.y], [0, -1]);
});

test("on the ψ axis the map stays while μ/α moves, and the collision moves on it", () => {
  const views = [0.3, 1.4, 3].map((mu) => mapView({ ...AT, mu_over_alpha: mu }, OVER_PSI));
  assert.ok(sameView(views[0], views[1]) || views[0].gtOverGn.max > views[1].gtOverGn.max);
  assert.ok(sameView(views[1], views[2]));
  assert.equal(axesMuOverAlpha(views[1], AT), 1);
  const heights = [1.4, 2.8].map((mu) => placeOnMap(views[1], { ...AT, mu_over_alpha: mu }).y);
  assert.ok(Math.abs(views[1].gtOverGn.fromShare(heights[0]) - 0.97) < 1e-12);
  assert.ok(heights[1] < heights[0]);
  assert.equal(gtOverGnAt(views[1], heights[0], 1.4), 1.358);
});

test("without friction the collision stands at the upper end of the ψ axis", () => {
  for (const gt_over_gn of [0, 1]) {
    const smooth = { ...AT, mu_over_alpha: 0, gt_over_gn };
    const { y, beyond } = placeOnMap(mapView(smooth, OVER_PSI), smooth);
    assert.deepEqual([y, beyond.y], [1, 1]);
  }
});

test("horizontalAxis gives the same places other numbers, 18 where κ is 63", () => {
  const view = mapView(AT, LINEAR);
  assert.equal(horizontalAxis(view, "kappa", SOLID_ALPHA).scale, view.kappa);
  const paper = horizontalAxis(view, "alpha_kappa", SOLID_ALPHA).scale;
  assert.ok(Math.abs(paper.toShare(18) - view.kappa.toShare(63)) < 1e-12);
  assert.ok(Math.abs(paper.fromShare(view.kappa.toShare(63)) - 18) < 1e-12);
  assert.ok(Math.abs(paper.max - 20) < 1e-12);
  assert.ok(Math.abs(horizontalAxis(view, "alpha_kappa", 0.4).scale.max - 28) < 1e-12);
});
