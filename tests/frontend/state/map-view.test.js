import assert from "node:assert/strict";
import { test } from "node:test";

import { collisionAt, mapView, placeOnMap, sameView } from "../../../frontend/state/map-view.js";
import { seeded } from "../random.js";

const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358 };

test("collisionAt and placeOnMap undo one another, to the four digits of a click", () => {
  const next = seeded(6);
  for (const scale of ["linear", "log"]) {
    const view = mapView(AT, scale);
    for (let i = 0; i < 200; i += 1) {
      const [x, y] = [next(), next()];
      const place = placeOnMap(view, { ...AT, ...collisionAt(view, x, y) });
      assert.ok(Math.hypot(place.x - x, place.y - y) < 1e-3);
    }
  }
});

test("mapView takes the paper's axes where they hold the collision", () => {
  const { kappa, gtOverGn } = mapView(AT, "linear");
  assert.deepEqual([kappa.min, kappa.max, gtOverGn.min, gtOverGn.max], [0.1, 70, 0.01, 4]);
});

test("mapView reaches a collision beyond the usual axes", () => {
  assert.equal(mapView({ ...AT, kappa: 100 }, "linear").kappa.max, 100);
  assert.equal(mapView({ ...AT, kappa: 101 }, "linear").kappa.max, 200);
  const view = mapView({ ...AT, kappa: 37_204, gt_over_gn: 1e-3 }, "log");
  assert.equal(view.kappa.max, 50_000);
  assert.equal(view.gtOverGn.min, 1e-3);
  assert.ok(!placeOnMap(view, { ...AT, kappa: 37_204, gt_over_gn: 1e-3 }).outside);
});

test("mapView does not stretch without end: there the collision stands at the edge", () => {
  for (const scale of ["linear", "log"]) {
    const extreme = { ...AT, kappa: 1.7e308, gt_over_gn: 0 };
    const view = mapView(extreme, scale);
    assert.ok(sameView(view, mapView(AT, scale)));
    assert.deepEqual(placeOnMap(view, extreme), { x: 1, y: 0, outside: true });
  }
});

test("collisionAt keeps a drag beyond the frame within it", () => {
  const view = mapView(AT, "linear");
  assert.deepEqual(collisionAt(view, 1.3, -0.2), { kappa: 70, gt_over_gn: 0.01 });
});

test("placeOnMap does not call outside what the eye takes for the edge", () => {
  const linear = placeOnMap(mapView(AT, "linear"), { ...AT, gt_over_gn: 0 });
  assert.deepEqual([linear.y, linear.outside], [0, false]);
  const log = placeOnMap(mapView(AT, "log"), { ...AT, gt_over_gn: 0 });
  assert.deepEqual([log.y, log.outside], [0, true]);
});
