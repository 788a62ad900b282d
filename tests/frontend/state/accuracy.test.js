import assert from "node:assert/strict";
import { test } from "node:test";

import {
  accuracyQuery,
  canAnswer,
  failingOf,
  KNOBS,
  METHODS,
  nearestNotch,
  sameAccuracy,
  USUAL_ACCURACY,
} from "../../../frontend/state/accuracy.js";

const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358 };

test("accuracyQuery asks with what the method heeds, and nothing else", () => {
  const accuracy = { ...USUAL_ACCURACY, tolerance: 1e-4, steps: 100, rtol: 1e-6 };
  const queries = METHODS.map(({ id }) => accuracyQuery({ ...accuracy, method: id }));
  assert.deepEqual(queries, [
    { method: "auto", tolerance: "0.0001" },
    { method: "exact" },
    { method: "table" },
    { method: "stiff" },
    { method: "coulomb" },
    { method: "timestep", steps: "100", integrator: "velocity_verlet" },
    { method: "ode", rtol: "0.000001" },
  ]);
});

test("sameAccuracy overlooks what the method does not heed", () => {
  const exact = { ...USUAL_ACCURACY, method: "exact" };
  assert.ok(sameAccuracy(exact, { ...exact, steps: 7 }));
  assert.ok(!sameAccuracy(USUAL_ACCURACY, { ...USUAL_ACCURACY, tolerance: 0.1 }));
});

test("every notch of a knob is allowed, and from fast to exact", () => {
  for (const { notches, admits, initial, key } of Object.values(KNOBS)) {
    assert.ok(notches.every(admits) && admits(initial), key);
    const sign = key === "steps" ? 1 : -1;
    assert.ok(
      notches.every((notch, i) => i === 0 || sign * (notch - notches[i - 1]) > 0),
      key,
    );
  }
});

test("nearestNotch finds the notch itself, and for a number between the nearer in ratio", () => {
  for (const [i, notch] of KNOBS.steps.notches.entries()) {
    assert.equal(nearestNotch(KNOBS.steps, notch), i);
  }
  assert.equal(KNOBS.tolerance.notches[nearestNotch(KNOBS.tolerance, 2e-5)], 1e-5);
  assert.equal(nearestNotch(KNOBS.steps, 1e6), KNOBS.steps.notches.length - 1);
});

test("canAnswer knows the range of the table and the patience with the solver", () => {
  assert.ok(canAnswer("table", AT));
  assert.ok(!canAnswer("table", { ...AT, kappa: 1001 }));
  assert.ok(!canAnswer("table", { ...AT, mu_over_alpha: 0 }));
  assert.ok(!canAnswer("ode", { ...AT, kappa: 1e6 }));
  assert.ok(canAnswer("coulomb", { ...AT, kappa: 1e300 }));
});

test("failingOf shows time steps where a method shows no error", () => {
  assert.equal(failingOf({ ...USUAL_ACCURACY, method: "exact" }).method, "timestep");
  assert.equal(failingOf({ ...USUAL_ACCURACY, tolerance: 1e-3 }).method, "timestep");
  assert.equal(failingOf({ ...USUAL_ACCURACY, method: "stiff" }).method, "stiff");
});
