import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { createAnswers } from "../../../frontend/kernel/answers.js";
import { createKernel } from "../../../frontend/kernel/kernel.js";
import { linearScale, logScale } from "../../../frontend/state/scales.js";

const file = new URL("../../../frontend/kernel/kernel.wasm", import.meta.url);
const answers = createAnswers(await createKernel(new WebAssembly.Module(readFileSync(file))));

const COLLISION = { kappa: 18, mu_over_alpha: 1.4, gt_over_gn: 0.42, damping: 0 };
const VIEW = { scale: "linear", vertical: "gt_over_gn", damping: 0 };
const AXES = { kappa: linearScale(0.1, 70), gtOverGn: linearScale(0.01, 4) };

test("a collision has its episodes, one after the other, to the end of the contact", async () => {
  const { episodes, switches, contact_duration: end } = await answers.collision(COLLISION);
  assert.equal(episodes.length, switches + 1);
  assert.equal(episodes[0].start, 0);
  assert.equal(episodes.at(-1).end, end);
  assert.ok(episodes.every(({ start }, i) => i === 0 || start === episodes[i - 1].end));
  const regimes = new Set(episodes.map(({ regime }) => regime));
  assert.deepEqual(regimes, new Set(["sliding", "sticking"]));
});

test("a collision too stiff to be followed is that of the stiff limit, without a count", async () => {
  const answer = await answers.collision({ ...COLLISION, kappa: 1e13 });
  assert.equal(answer.method, "stiff");
  assert.equal(answer.switches, null);
  assert.equal(answer.epsilon_t, 0);
  assert.ok(answer.error_bound < 1e-6);
  assert.equal(await answers.trace({ ...COLLISION, kappa: 1e13 }), null);
});

test("without friction ψ is no number", async () => {
  const answer = await answers.collision({ ...COLLISION, mu_over_alpha: 0 });
  assert.equal(answer.parameters.psi, null);
  assert.equal(answer.epsilon_t, 1);
});

test("a map has at each of its places the collision there", async () => {
  for (const damping of [0, 0.1]) {
    const view = { ...VIEW, ...AXES, damping };
    const counts = { kappa: 40, gtOverGn: 60 };
    const map = await answers.map({ muOverAlpha: 1.4, view, counts });
    assert.equal(map.kappa[0], 0.1);
    assert.equal(map.gt_over_gn[59], 4);
    for (const [row, column] of [
      [0, 0],
      [31, 7],
      [59, 39],
    ]) {
      const place = { kappa: map.kappa[column], gt_over_gn: map.gt_over_gn[row], damping };
      const alone = await answers.collision({ ...COLLISION, ...place });
      assert.ok(Math.abs(map.epsilon_t[row][column] - alone.epsilon_t) <= 2 * alone.error_bound);
      assert.equal(map.switches[row][column], alone.switches);
    }
  }
});

test("cells that switch more often than can be seen are not counted, and cost next to nothing", async () => {
  const view = { ...VIEW, scale: "log", kappa: logScale(0.1, 1e9), gtOverGn: logScale(0.01, 4) };
  const map = await answers.map({ muOverAlpha: 1.4, view, counts: { kappa: 10, gtOverGn: 10 } });
  assert.ok(Number.isNaN(map.switches[5][9]));
  assert.equal(map.epsilon_t[5][9], 0);
  assert.ok(map.switches[5][5] > 0);
});

test("a map whose wish is given up ends at its next turn", async () => {
  const view = { ...VIEW, ...AXES };
  const wish = { muOverAlpha: 1.4, view, counts: { kappa: 2000, gtOverGn: 1000 } };
  const controller = new AbortController();
  const map = answers.map(wish, controller.signal);
  controller.abort();
  await assert.rejects(map, { name: "AbortError" });
});

test("a cut runs along either of its parameters, with the simple laws", async () => {
  const view = { ...VIEW, ...AXES };
  const along = await answers.cut({
    ...{ along: "kappa", held: 0.42, muOverAlpha: 1.4, view, count: 11 },
  });
  assert.deepEqual([along.values[0], along.values[10]], [0.1, 70]);
  const across = await answers.cut({
    ...{ along: "gt_over_gn", held: 18, muOverAlpha: 1.4, view, count: 11 },
  });
  assert.deepEqual([across.values[0], across.values[10]], [0.01, 4]);
  assert.equal(across.coulomb[0], 0);
  assert.ok(Number.isNaN(across.stiff_bound[10]));
});

test("a ball that falls back meets the wall with what its first collision left", async () => {
  const ball = { collision: COLLISION, alpha: 2 / 7, spinShare: 0 };
  const first = await answers.collision(COLLISION);
  const { second, mass_share: share } = await answers.bounce({ ...ball, partner: "wall" });
  assert.equal(share, 1);
  assert.equal(second.kappa, 18);
  assert.equal(second.direction, Math.sign(first.epsilon_t));
  assert.equal(second.gt_over_gn, Math.abs(first.epsilon_t) * 0.42);
  const off = await answers.bounce({ ...ball, partner: "sphere" });
  assert.deepEqual([off.mass_share, off.second], [0.5, null]);
});
