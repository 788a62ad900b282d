import assert from "node:assert/strict";
import { test } from "node:test";

import {
  contactBody,
  IMPACT_PARAMETERS,
  impactOf,
  usualOf,
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

test("a normal restitution stands in for the dissipative constant, at the velocity of the impact", () => {
  const impact = { ...impactOf("steel"), normal_restitution: 0.9, normal_velocity_m_s: 3 };
  const body = contactBody(STEEL, impact);
  assert.equal(body.normal_restitution, 0.9);
  assert.equal(body.at_normal_velocity_m_s, 3);
  assert.ok(!("dissipative_constant_s" in body));
  assert.equal(valuesOf(STEEL, impact).dissipative_constant_s, null);
});

test("the second body is what is set of it, else what the first is", () => {
  const impact = { ...impactOf("steel"), density_kg_m3: 1000, radius_2_m: 0.01 };
  const { body_1: first, body_2: second } = contactBody(STEEL, impact);
  assert.deepEqual([first.density_kg_m3, second.density_kg_m3], [1000, 1000]);
  assert.deepEqual([first.radius_m, second.radius_m], [0.02, 0.01]);
  const usual = usualOf(STEEL, { ...impact, radius_m: 0.5 });
  assert.deepEqual([usual.radius_m, usual.radius_2_m], [0.02, 0.5]);
});

test("a wall has the moduli of the sphere where the material has none, and a sphere its measures", () => {
  const impact = { ...impactOf("steel"), second: "wall", radius_2_m: 1, poisson_ratio_2: 0.1 };
  assert.deepEqual(contactBody(STEEL, impact).body_2, {
    wall: true,
    youngs_modulus_pa: 2e11,
    poisson_ratio: 0.1,
  });
  assert.equal(valuesOf(STEEL, impact).radius_2_m, null);
  const glass = { wall: true, youngs_modulus_pa: 7e10, poisson_ratio: 0.25 };
  const onGlass = { ...STEEL, body_2: glass };
  assert.deepEqual(
    contactBody(onGlass, { ...impactOf("steel"), second: "sphere", youngs_modulus_pa: 1e9 }).body_2,
    { ...SPHERE, youngs_modulus_pa: 1e9 },
  );
  assert.deepEqual(
    contactBody(onGlass, { ...impactOf("steel"), youngs_modulus_2_pa: 6e10 }).body_2,
    { ...glass, youngs_modulus_pa: 6e10 },
  );
});

test("velocityView reaches both velocities by a round number", () => {
  const velocities = { normal_velocity_m_s: 3.4, tangential_velocity_m_s: 0 };
  const { normal, tangential, most } = velocityView(velocities, "linear");
  const log = velocityView(velocities, "log");
  assert.equal(log.tangential.max, 5);
  assert.ok(log.tangential.min > 0 && log.tangential.min < 1e-4);
  assert.equal(most, 5);
  assert.ok(normal.min > 0);
  assert.deepEqual([normal.max, tangential.min, tangential.max], [5, 0, 5]);
});
