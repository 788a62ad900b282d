import assert from "node:assert/strict";
import { test } from "node:test";

import {
  createCollisionLoad,
  serverAlone,
} from "../../../../frontend/state/loading/collision-load.js";
import { createSource } from "../../../../frontend/state/loading/source.js";
import { USUAL_ACCURACY } from "../../../../frontend/state/accuracy.js";

const COLLISION = { kappa: 18, mu_over_alpha: 1.4, gt_over_gn: 0.4, damping: 0 };
const EXACT = { limit: false, reversals: 0, first_episode_share: 1, milliseconds: 1 };

/** An answer of somebody about a collision that slides throughout. */
const said = (by, epsilon = 0.5, switches = 0) => ({
  ...{ ...EXACT, by, epsilon_t: epsilon, error_bound: 1e-15, switches, switches_certain: true },
  parameters: COLLISION,
});

/** Someone who answers all collisions alike. */
const answering = (answer) => ({ collision: async () => answer, trace: async () => answer });

const SERVER = { ...answering(said("server")), answer: async () => ({ method: "timestep" }) };

function sourceOf(kernel, isAway = () => false) {
  const faults = [];
  const onFault = (...what) => faults.push(what);
  return { source: createSource(SERVER, answering(kernel), { isAway, onFault }), faults };
}

const wish = (dragging, accuracy = USUAL_ACCURACY) => ({
  ...{ collision: COLLISION, accuracy, change: { dragging, inputTimeStamp: 0 }, isPictured: true },
});

test("the server is asked until the kernel is here, and then while no hand drags", async () => {
  const source = serverAlone(SERVER);
  const load = createCollisionLoad(source);
  assert.equal((await load(wish(true))).result.by, "server");
  Object.assign(source, sourceOf(said("kernel")).source);
  assert.equal((await load(wish(true))).result.by, "kernel");
  assert.equal((await load(wish(false))).result.by, "server");
});

test("what the kernel does not answer is asked of the server", async () => {
  const { source } = sourceOf(null);
  assert.equal((await source.of(true).trace(COLLISION)).by, "server");
});

test("while the server is away the kernel stands in for other methods, which is told", async () => {
  const { source } = sourceOf(said("kernel"), () => true);
  const load = createCollisionLoad(source);
  for (const [method, isOffered] of [
    ["timestep", false],
    ["exact", true],
  ]) {
    const answer = await load(wish(false, { ...USUAL_ACCURACY, method }));
    assert.equal(answer.result.by, "kernel");
    assert.equal(answer.isOffered, isOffered);
    assert.equal(answer.isAlone, true);
  }
  const served = createCollisionLoad(serverAlone(SERVER));
  const answer = await served(wish(false, { ...USUAL_ACCURACY, method: "timestep" }));
  assert.deepEqual([answer.result.method, answer.isOffered], ["timestep", true]);
});

test("a kernel that differs from the server beyond both bounds is told of once", async () => {
  for (const [own, count] of [
    [said("kernel", 0.5 + 1.5e-15), 0],
    [said("kernel", 0.5 + 3e-15), 1],
    [said("kernel", 0.5, 2), 1],
    [{ ...said("kernel", 0.5, 2), switches_certain: false }, 0],
  ]) {
    const { source, faults } = sourceOf(own);
    await source.compare(said("server"));
    await source.compare(said("server"));
    assert.equal(faults.length, count);
  }
});

test("a kernel that breaks down is told of and not asked again", async () => {
  const faults = [];
  const broken = async () => {
    throw new Error("trap");
  };
  const source = createSource(
    SERVER,
    { trace: broken },
    { isAway: () => false, onFault: (...what) => faults.push(what) },
  );
  const { signal } = new AbortController();
  assert.equal((await source.of(true).trace(COLLISION, signal)).by, "server");
  assert.equal(source.isNear(true), false);
  assert.equal((await source.of(true).trace(COLLISION, signal)).by, "server");
  assert.equal(faults.length, 1);
});

test("a wish for the kernel that is given up is no fault of it", async () => {
  const controller = new AbortController();
  controller.abort();
  const given = { map: async (_, signal) => signal.throwIfAborted() };
  const { signal } = controller;
  const onFault = () => assert.fail();
  const source = createSource(SERVER, given, { isAway: () => false, onFault });
  await assert.rejects(source.of(true).map({}, signal), { name: "AbortError" });
});
