import assert from "node:assert/strict";
import { test } from "node:test";

import {
  letterOf,
  readPins,
  withoutPin,
  withPin,
  writePins,
} from "../../../frontend/state/pins.js";
import { readAddress } from "../../../frontend/state/address/reading.js";
import { writeAddress } from "../../../frontend/state/address/writing.js";

const collision = (kappa, mu_over_alpha, gt_over_gn, damping = 0) => ({
  kappa,
  mu_over_alpha,
  gt_over_gn,
  damping,
});
const [A, B, C] = [
  collision(63, 1.4, 1.3579999999999999),
  collision(4.5, 0, 4, 0.25),
  collision(1e21, 1e-300, 0),
];

test("pins stand in an address with all of their digits, and it reads well", () => {
  const { state } = readAddress("");
  const address = writeAddress({ ...state, pins: [A, B, C] });
  assert.match(address, /&pins=63,1.4,1.3579999999999999;4.5,0,4,0.25;1e21,1e-300,0$/);
  assert.deepEqual(readAddress(address), { state: { ...state, pins: [A, B, C] }, problems: [] });
});

test("a pin takes the first free letter and keeps it while others come and go", () => {
  const all = withPin(withPin(withPin([], A), B), C);
  assert.equal(withPin(all, collision(1, 1, 1)), null);
  const two = withoutPin(all, 0);
  assert.equal(letterOf(two, { ...B }), "B");
  assert.equal(letterOf(two, A), "");
  assert.deepEqual(readPins(writePins(two)), { pins: [null, B, C], wrong: [] });
  assert.equal(letterOf(withPin(two, collision(1, 1, 1)), collision(1, 1, 1)), "A");
  assert.deepEqual(withoutPin(withoutPin(two, 2), 1), []);
});

test("of pins in an address what makes no sense is told in words, and the rest is kept", () => {
  for (const [text, pins, wrong] of [
    ["63,1.4;4.5,0,4,0.25", [null, B], "63,1.4"],
    ["0,1,1", [], "0,1,1"],
    ["1,1,1,-1;<script>;4.5,0,4,0.25", [null, null, B], "1,1,1,-1;<script>"],
    ["4.5,0,4,0.25;1,1,1;1,1,1;2,1,1", [B, collision(1, 1, 1), collision(1, 1, 1)], "2,1,1"],
    ["1e999,1,1;;", [], "1e999,1,1"],
  ]) {
    const { state, problems } = readAddress(`?pins=${text}`);
    assert.deepEqual(state.pins, pins, text);
    assert.deepEqual(problems, [
      `pins must be up to three collisions parted by semicolons, each κ,μ/α,g_t/g_n[,η], not “${wrong}”`,
    ]);
  }
});
