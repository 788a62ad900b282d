import assert from "node:assert/strict";
import { test } from "node:test";

import { spreadApart } from "../../../frontend/figures/spread.js";
import { seeded } from "../random.js";

test("spreadApart leaves alone what is far enough apart", () => {
  assert.deepEqual(spreadApart([1, 3, 5], 1, 0, 6), [1, 3, 5]);
});

test("spreadApart moves a close pair by the same amount to either side", () => {
  assert.deepEqual(spreadApart([2.75, 3.25], 1, 0, 6), [2.5, 3.5]);
});

test("spreadApart keeps distance, order and bounds wherever there is room", () => {
  const next = seeded(7);
  for (let round = 0; round < 200; round += 1) {
    const positions = Array.from({ length: 9 }, () => 10 * next()).sort((a, b) => a - b);
    const spread = spreadApart(positions, 1, 0, 10);
    assert.ok(spread.every((place) => place >= -1e-12 && place <= 10 + 1e-12));
    assert.ok(spread.slice(1).every((place, i) => place - spread[i] >= 1 - 1e-12));
  }
});

test("spreadApart says when there is no room", () => {
  assert.equal(spreadApart([1, 2, 3], 4, 0, 6), null);
});
