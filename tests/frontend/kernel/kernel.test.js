import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import {
  aboutModule,
  createKernel,
  importsOf,
  MOST_SAMPLES,
} from "../../../frontend/kernel/kernel.js";

const file = new URL("../../../frontend/kernel/kernel.wasm", import.meta.url);
const module = new WebAssembly.Module(readFileSync(file));
const about = aboutModule(module);
const kernel = await createKernel(module);

/** The module by itself, its memory filled with what no call leaves by chance. */
async function bare(stack = about.stack) {
  const { env } = importsOf({ ...about, stack });
  const { exports } = await WebAssembly.instantiate(module, { env });
  const bytes = new Uint8Array(env.__linear_memory.buffer);
  bytes.fill(0xa5, 0, about.stack);
  return { ...exports, bytes };
}

/** Addresses that a damped trace is given, the room for episodes apart. */
const [contact, lanes] = [about.free, about.free + about.contact];
const labels = lanes + about.lanes;
const arrays = Array.from({ length: 5 }, (_, i) => labels + about.labels + i * 100_000);
const traceArguments = (room) => [
  ...[contact, about.most_switches, 18, 1, 0.3, 400, room],
  ...[...arrays, lanes, labels, arrays[4] + 9000],
];

/** Collisions of μ/α = 1. */
const list = (kappa, psi, damping = 0) => ({
  ...{ kappa: Float64Array.from(kappa), gtOverGn: Float64Array.from(psi) },
  ...{ muOverAlpha: 1, damping },
});

/** One of them. */
const of = (kappa, psi, damping = 0) => ({
  ...{ kappa, mu_over_alpha: 1, gt_over_gn: psi, damping },
});

test("the kernel takes nothing but memory, a stack and functions of Math", () => {
  const taken = WebAssembly.Module.imports(module).map(({ name }) => name);
  const [memory, stack, ...functions] = taken;
  assert.deepEqual([memory, stack], ["__linear_memory", "__stack_pointer"]);
  assert.deepEqual(
    functions.filter((name) => typeof Math[name] !== "function"),
    [],
  );
});

test("a stack that overflows traps, for there is nothing below it", async () => {
  const { prepare_contact: prepare, damped_trace: trace } = await bare();
  assert.equal(prepare(0.1, contact), 0);
  assert.equal(trace(...traceArguments(64)), 0);
  const small = await bare(64);
  assert.throws(() => small.prepare_contact(0.1, contact), WebAssembly.RuntimeError);
});

test("half of the stack is never used", async () => {
  const { prepare_contact: prepare, damped_trace: trace, trace: elastic, bytes } = await bare();
  prepare(0.1, contact);
  trace(...traceArguments(64));
  elastic(...traceArguments(64));
  const used = about.stack - bytes.findIndex((byte) => byte !== 0xa5);
  assert.ok(used > 0 && used < about.stack / 2, `${used} bytes`);
});

test("arrays that the arena has no room for trap", async () => {
  const { trace } = await bare();
  assert.throws(() => trace(...traceArguments(400_000)), WebAssembly.RuntimeError);
});

test("what is no collision, is too stiff, or has no room here, is asked of the server", () => {
  assert.equal(kernel.collision(of(-1, 0.3)), null);
  assert.equal(kernel.collision(of(18, NaN)), null);
  assert.equal(kernel.collision(of(18, Infinity)), null);
  assert.equal(kernel.collision({ ...of(18, 0.3), mu_over_alpha: -1 }), null);
  assert.equal(kernel.collision(of(18, 0.3, -0.1)), null);
  assert.equal(kernel.collision(of(18, 0.3, 2e30)), null);
  assert.equal(kernel.collisions(list([18, Infinity], [0.3, 0.3])), null);
  assert.equal(kernel.trace(of(1e12, 0.3), 400) === null, true);
  assert.equal(kernel.trace(of(5e8, 1), 400) === null, true);
  assert.equal(kernel.trace(of(18, 0.3, 0.1), MOST_SAMPLES + 1) === null, true);
  assert.equal(kernel.trace(of(18, 0.3, 0.1), 1) === null, true);
});

test("a refused damping leaves the next call its own contact", () => {
  const before = kernel.collision(of(18, 0.3, 0.1));
  kernel.collision(of(18, 0.3, 2e30));
  assert.deepEqual(kernel.collision(of(18, 0.3, 0.1)), before);
  assert.equal(kernel.collision(of(18, 0.3, 2e30)), null);
});

test("collisions beyond one part of a list are those of a list of their own", () => {
  const size = 20_000;
  const kappa = Float64Array.from({ length: size }, (_, i) => 0.1 + i / 300);
  const psi = Float64Array.from({ length: size }, (_, i) => 0.01 + (i % 150) / 50);
  const whole = kernel.collisions(list(kappa, psi));
  const last = kernel.collisions(list(kappa.slice(-100), psi.slice(-100)));
  assert.deepEqual(whole.epsilonT.slice(-100), last.epsilonT);
  assert.deepEqual(whole.switches.slice(-100), last.switches);
  assert.deepEqual(whole.isCertain.slice(-100), last.isCertain);
  assert.deepEqual(whole.errorBound.slice(-100), last.errorBound);
});

test("the longest trace has room", () => {
  const trace = kernel.trace(of(3.6e8, 1), MOST_SAMPLES);
  assert.ok(trace.switches > 19_000);
  assert.equal(trace.regime.length, MOST_SAMPLES + trace.switches);
});

test("a trace ends in the coefficient of restitution, at the end of the contact", () => {
  for (const damping of [0, 0.1]) {
    const trace = kernel.trace(of(63, 0.97, damping), 400);
    const end = 400 + trace.switches - 1;
    assert.equal(trace.time.length, end + 1);
    const left = trace.tangentialVelocity[end] / 0.97;
    assert.ok(Math.abs(left - trace.epsilonT) <= 2 * trace.errorBound);
    assert.equal(trace.time[end], trace.contactDuration);
    assert.equal(trace.starts.length, trace.switches + 1);
    assert.ok(trace.starts.slice(1).every((start) => trace.time.includes(start)));
  }
});
