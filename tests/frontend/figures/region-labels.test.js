import assert from "node:assert/strict";
import { test } from "node:test";

import { regionLabels } from "../../../frontend/figures/region-labels.js";

const CELLS = [
  [0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 4],
  [0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 4],
  [0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 4],
  [0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 4],
  [0, 0, 0, 0, 0, 2, 2, 2, 2, 2, 4],
].map((row) => Int32Array.from(row));
const SIZE = { width: 100, height: 40 };

test("regionLabels puts one label into the middle of each area that has room", () => {
  const labels = regionLabels(CELLS, SIZE, 20, []);
  assert.deepEqual(labels.map(({ value, x, y }) => [value, x, y]).sort(), [
    [0, 0.2, 0.5],
    [2, 0.7, 0.5],
  ]);
});

test("regionLabels keeps off the frame, off small areas, and off places that are taken", () => {
  assert.deepEqual(regionLabels(CELLS, SIZE, 200, []), []);
  const beside = regionLabels(CELLS, SIZE, 10, [{ x: 0.2, y: 0.5 }]);
  const label = beside.find(({ value }) => value === 0);
  assert.ok(Math.hypot(100 * (label.x - 0.2), 40 * (label.y - 0.5)) >= 10);
});

test("regionLabels labels two areas of one count, each", () => {
  const mirrored = CELLS.map((row) => Int32Array.from([...row, ...row.toReversed()]));
  const labels = regionLabels(mirrored, { width: 210, height: 40 }, 20, []);
  assert.deepEqual(labels.map(({ value }) => value).sort(), [0, 0, 2, 2]);
});
