import assert from "node:assert/strict";
import { test } from "node:test";

import {
  contactBody,
  IMPACT_PARAMETERS,
  impactOf,
  valuesOf,
  velocityView,
} from "../../../frontend/state/impact.js";

const SPHERE = { radius_m: 0.02, density_kg_m3: 7850, youngs_modulus_pa: 2e11, poisson_ratio: 0.3 };
const STEEL = {
  id: "steel",
  body_1: SPHERE,
  body_2: SPHERE,
  friction_coefficient: 0.4,
  tangential_stiffness_n_per_m: "mindlin",
  dissipative_constant_s: 0,
  impact: { normal_velocity_m_s: 20, tangential_velocity_m_s: 5 },
};

test("contactBody is the material's where nothing is set by hand", () => {
  assert.deepEqual(contactBody(STEEL, impactOf("steel")), {
    body_1: SPHERE,
    body_2: SPHERE,
    friction_coefficient: 0.4,
    tangential_stiffness_n_per_m: "mindlin",
    dissipative_constant_s: 0,
  });
});

test("what is set by hand holds for both spheres, and leaves a wall alone", () => {
  const impact = { ...impactOf("steel"), radius_m: 0.1, tangential_stiffness_n_per_m: 1e6 };
  const body = contactBody(STEEL, impact);
  assert.equal(body.body_1.radius_m, 0.1);
  assert.equal(body.body_2.radius_m, 0.1);
  assert.equal(body.tangential_stiffness_n_per_m, 1e6);
  assert.equal(
    contactBody(STEEL, { ...impactOf("steel"), inertia: "hollow" }).body_2.inertia,
    "hollow",
  );
  const wall = { wall: true, youngs_modulus_pa: 7e10, poisson_ratio: 0.25 };
  assert.deepEqual(contactBody({ ...STEEL, body_2: wall }, impact).body_2, wall);
});

test("valuesOf knows every parameter; Mindlin's stiffness is worked out elsewhere", () => {
  const values = valuesOf(STEEL, { ...impactOf("steel"), normal_velocity_m_s: 1 });
  assert.deepEqual(Object.keys(values).sort(), IMPACT_PARAMETERS.map(({ key }) => key).sort());
  assert.equal(values.normal_velocity_m_s, 1);
  assert.equal(values.tangential_velocity_m_s, 5);
  assert.equal(values.tangential_stiffness_n_per_m, null);
});

test("velocityView reaches both velocities by a round number", () => {
  const { normal, tangential, most } = velocityView({
    normal_velocity_m_s: 3.4,
    tangential_velocity_m_s: 0,
  });
  assert.equal(most, 5);
  assert.ok(normal.min > 0);
  assert.deepEqual([normal.max, tangential.min, tangential.max], [5, 0, 5]);
});
