import assert from "node:assert/strict";
import { test } from "node:test";

import { INTEGRATORS, METHODS, USUAL_ACCURACY } from "../../../frontend/state/accuracy.js";
import { impactOf } from "../../../frontend/state/impact.js";
import { INITIAL_COLLISION, SOLID_ALPHA } from "../../../frontend/state/parameters.js";
import { sweepOf } from "../../../frontend/state/sweep.js";
import { readAddress } from "../../../frontend/state/address/reading.js";
import { isAt, stateAt, writeAddress } from "../../../frontend/state/address/writing.js";
import { spreadNumbers } from "../random.js";

const USUAL = {
  collision: INITIAL_COLLISION,
  alpha: SOLID_ALPHA,
  bounce: "wall",
  spin_share: 0,
  pins: [],
  sweep: null,
  accuracy: USUAL_ACCURACY,
  map: "epsilon_t",
  scale: "linear",
  map_x: "kappa",
  map_y: "gt_over_gn",
  shape: "flat",
  energy: "hidden",
  cut_x: "gt_over_gn",
  cut_y: "linear",
  scene: "explorer",
  theme: "system",
  embed: "none",
  sliders: "usual",
  region: "figure4",
  statistic: "p95",
  wanted_error: "1e-3",
  velocity_law: "epsilon_t",
  velocity_scale: "linear",
  paper_verdict: "all",
  paper_kind: "all",
  step: "1",
  lang: "system",
  notes: "hidden",
  handout: "hidden",
  face: "usual",
  presenting: "off",
  left: "contact",
  right: "map",
  impact: impactOf("steel"),
};

test("an address takes decimal points only, and says so", () => {
  const { state, problems } = readAddress(
    "?kappa=0,5&mu_over_alpha=1,000&alpha=0,4&tolerance=1,5&scene=spheres&radius_m=0,02",
  );
  assert.deepEqual(state, { ...USUAL, scene: "spheres" });
  assert.deepEqual(problems, [
    "κ must be a number greater than 0, with a decimal point, not “0,5”",
    "μ/α must be a number, 0 or greater, with a decimal point, not “1,000”",
    "tolerance must be from 1e-13 to 1, with a decimal point, not “1,5”",
    "R must be a length greater than 0, in m, with a decimal point, not “0,02”",
    "α must be greater than 0, at most 1, with a decimal point, not “0,4”",
  ]);
});

test("readAddress gives back exactly the state that writeAddress wrote", () => {
  const numbers = spreadNumbers(5, 300, 1e-300, 1e300);
  for (let i = 0; i < numbers.length; i += 3) {
    const [kappa, mu_over_alpha, gt_over_gn] = numbers.slice(i, i + 3);
    const state = {
      collision: { kappa, mu_over_alpha, gt_over_gn, damping: i % 2 ? 0 : Math.min(kappa, 1e30) },
      alpha: i % 4 ? SOLID_ALPHA : 0.4,
      bounce: ["wall", "wall_twice", "sphere"][i % 3],
      spin_share: i % 5 ? 0 : 5 / 7,
      pins: [
        [],
        [{ kappa: gt_over_gn, mu_over_alpha: kappa, gt_over_gn: 0, damping: 0 }],
        [null, null, { kappa, mu_over_alpha, gt_over_gn, damping: 1e-300 }],
      ][(i / 3) % 3],
      sweep: [null, sweepOf("radius_m"), { ...sweepOf("kappa"), from: 20, once: true }][
        (i / 3) % 3
      ],
      map: i % 2 ? "epsilon_t" : "switches",
      scale: i % 4 > 1 ? "linear" : "log",
      map_x: i % 5 ? "kappa" : "alpha_kappa",
      map_y: i % 7 ? "gt_over_gn" : "psi",
      shape: i % 3 ? "flat" : "surface",
      energy: i % 8 > 3 ? "hidden" : "shown",
      cut_x: i % 9 > 4 ? "gt_over_gn" : "kappa",
      cut_y: i % 10 > 4 ? "linear" : "log",
      scene: "explorer",
      theme: ["system", "light", "dark"][i % 3],
      embed: ["none", "force", "map,result"][(i >> 1) % 3],
      sliders: (i >> 1) % 3 ? ["usual", "none", "gt_over_gn,kappa"][(i / 3) % 3] : "usual",
      accuracy: {
        method: METHODS[i % METHODS.length].id,
        tolerance: 10 ** -(1 + (i % 12)),
        steps: 4 + i,
        integrator: INTEGRATORS[i % 3].id,
        rtol: 10 ** -(1 + (i % 12)),
      },
      region: ["figure4", "solids"][i % 2],
      statistic: ["p95", "median", "max"][(i >> 1) % 3],
      wanted_error: ["1e-3", "1e-5"][i % 2],
      velocity_law: ["epsilon_t", "coulomb"][i % 2],
      velocity_scale: ["linear", "log"][(i >> 1) % 2],
      paper_verdict: ["all", "fails"][i % 2],
      paper_kind: ["all", "equation", "claim"][i % 3],
      step: String(1 + (i % 10)),
      lang: ["system", "en", "de"][i % 3],
      notes: i % 2 ? "hidden" : "shown",
      handout: i % 4 ? "hidden" : "shown",
      face: ["usual", "plain", "expert"][i % 3],
      presenting: i % 6 ? "off" : "on",
      left: ["contact", "cut"][i % 2],
      right: ["map", "force"][(i >> 1) % 2],
      impact: {
        ...impactOf(i % 2 ? "steel" : "glass-on-glass"),
        inertia: i % 8 > 3 ? null : "hollow",
        radius_m: i % 4 > 1 ? kappa : null,
      },
    };
    assert.deepEqual(readAddress(writeAddress(state)), { state, problems: [] });
  }
});

test("readAddress of nothing is the usual state, without complaint", () => {
  const { state, problems } = readAddress("");
  assert.deepEqual(state, USUAL);
  assert.deepEqual(problems, []);
});

test("readAddress replaces nonsense by the usual value and names each piece of it", () => {
  const { state, problems } = readAddress(
    "?kappa=-3&mu_over_alpha=1e999&gt_over_gn=0.5&map=%3Cscript%3E&scale=log",
  );
  assert.deepEqual(state, {
    ...USUAL,
    collision: { ...INITIAL_COLLISION, gt_over_gn: 0.5 },
    scale: "log",
  });
  assert.deepEqual(problems, [
    "κ must be a number greater than 0, not “-3”",
    "μ/α must be a number, 0 or greater, not “1e999”",
    "map must be epsilon_t or switches, not “<script>”",
  ]);
});

test("readAddress judges the numbers of the methods by their own ranges", () => {
  const { state, problems } = readAddress("?steps=3&rtol=1e-3&tolerance=2&method=magic");
  assert.deepEqual(state.accuracy, { ...USUAL_ACCURACY, rtol: 1e-3 });
  assert.equal(problems.length, 3);
});

test("α stands in the address only where it is not 2/7, and nonsense becomes 2/7", () => {
  const usual = readAddress("").state;
  assert.doesNotMatch(writeAddress(usual), /[?&]alpha=/);
  assert.match(writeAddress({ ...usual, alpha: 0.4 }), /&alpha=0\.4(&|$)/);
  for (const text of ["0", "-1", "1.1", "NaN", "two sevenths"]) {
    const { state, problems } = readAddress(`?alpha=${text}`);
    assert.equal(state.alpha, SOLID_ALPHA);
    assert.match(problems[0], /^α must be greater than 0, at most 1/);
  }
});

test("the ball that bounces stands in the address where it is not the usual one", () => {
  assert.doesNotMatch(writeAddress(USUAL), /spin_share|bounce/);
  const ball = { ...USUAL, bounce: "wall_twice", spin_share: 0.714 };
  assert.match(writeAddress(ball), /&spin_share=0\.714&bounce=wall_twice(&|$)/);
  const { state, problems } = readAddress("?bounce=floor&spin_share=1.5");
  assert.deepEqual([state.bounce, state.spin_share], ["wall", 0]);
  assert.deepEqual(problems, [
    "bounce must be wall or wall_twice or sphere, not “floor”",
    "spin_share must be a number from 0 to 1, not “1.5”",
  ]);
});

test("readAddress brings the scene of a panel that stands alone", () => {
  assert.equal(readAddress("?embed=steps").state.scene, "accuracy");
  assert.equal(readAddress("?embed=map&scene=accuracy").state.scene, "explorer");
  assert.equal(readAddress("?embed=result&scene=accuracy").state.scene, "accuracy");
});

test("readAddress takes panels of one scene and values of that, each once and in their order", () => {
  const read = (/** @type {string} */ search) => {
    const { state, problems } = readAddress(search);
    return [state.scene, state.embed, state.sliders, problems.length].join(" ");
  };
  assert.equal(
    read("?embed=map,result,map&sliders=gt_over_gn,kappa,kappa"),
    "explorer map,result gt_over_gn,kappa 0",
  );
  assert.equal(read("?embed=velocities&sliders=radius_m"), "spheres velocities radius_m 0");
  assert.equal(read("?embed=force&sliders=none"), "explorer force none 0");
  assert.equal(read("?embed=paper&sliders=kappa"), "paper paper usual 1");
  assert.equal(read("?embed=,none&sliders="), "explorer none usual 2");
  // Without a frame nothing is locked.
  assert.equal(read("?sliders=kappa"), "explorer none usual 0");
});

test("readAddress names the panels and values that do not belong together, and keeps the others", () => {
  const { state, problems } = readAddress("?embed=force,velocities,map&sliders=kappa,radius_m");
  assert.deepEqual([state.embed, state.sliders], ["force,map", "kappa"]);
  assert.deepEqual(problems, [
    "embed must be none or result or force or velocity or map or cut or contact or compare, not “velocities”",
    "sliders must be none or kappa or mu_over_alpha or gt_over_gn or damping or spin_share, not “radius_m”",
  ]);
});

test("readAddress repeats only the beginning of a very long piece of nonsense", () => {
  const [problem] = readAddress(`?kappa=${"x".repeat(10_000)}`).problems;
  assert.ok(problem.length < 100);
});

test("writeAddress leaves out what is usual of the page, and holds what is not", () => {
  const usual = readAddress("").state;
  assert.doesNotMatch(writeAddress(usual), /scene|theme|embed|method|region/);
  assert.match(writeAddress({ ...usual, theme: "dark", embed: "map" }), /&theme=dark&embed=map$/);
  const framed = { ...usual, embed: "force,map", sliders: "kappa" };
  assert.match(writeAddress(framed), /&embed=force,map&sliders=kappa$/);
});

test("stateAt changes what an address names and leaves the rest, but for the damping and what is set by hand", () => {
  const present = readAddress("?theme=dark&damping=0.3&map_y=psi&radius_m=0.1").state;
  const letter = stateAt(present, "?kappa=18&mu_over_alpha=1&gt_over_gn=0.5&map=switches");
  assert.deepEqual(letter, {
    ...present,
    collision: { kappa: 18, mu_over_alpha: 1, gt_over_gn: 0.5, damping: 0 },
    map: "switches",
  });
  const steel = stateAt(present, "?material=steel&scene=spheres&normal_velocity_m_s=100");
  assert.deepEqual(steel.impact, { ...impactOf("steel"), normal_velocity_m_s: 100 });
  assert.equal(steel.collision.damping, 0.3);
});

test("isAt knows the state that an address asks for, whatever else it says", () => {
  const link = "?kappa=63&mu_over_alpha=1.4&gt_over_gn=1.36&map=switches";
  const there = stateAt(readAddress("?theme=dark").state, link);
  assert.ok(isAt(there, link));
  assert.ok(!isAt({ ...there, map: "epsilon_t" }, link));
  assert.ok(!isAt({ ...there, collision: { ...there.collision, kappa: 62 } }, link));
  const steel = "?kappa=5896.51&scene=spheres&material=steel&tangential_velocity_m_s=5";
  const spheres = stateAt(there, steel);
  assert.ok(isAt({ ...spheres, collision: { ...spheres.collision, kappa: 5896.5105 } }, steel));
  assert.ok(
    !isAt({ ...spheres, impact: { ...spheres.impact, tangential_velocity_m_s: 6 } }, steel),
  );
});
