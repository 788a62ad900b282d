import assert from "node:assert/strict";
import { test } from "node:test";

import { differInMarksOnly } from "../../../frontend/figures/pixels.js";
import { sphereCutFigure } from "../../../frontend/scenes/spheres/sphere-cut-figure.js";
import { powerScale } from "../../../frontend/state/scales.js";
import { SIZE, THEME } from "../fixtures.js";

const SUBJECT = {
  curves: { epsilon_t: [1, -0.3, 0.5], coulomb: [0, 0, 0.5] },
  tangential: powerScale(0, 5, 1),
  scale: "linear",
  measured: [],
  here: { share: 0.5, epsilon_t: -0.3, velocity: "g_t = 2.5 m/s" },
};
const MEASURED = [0.2, 0.9, 1.2].map((share) => ({ share, epsilon_t: 0.1 }));

test("sphereCutFigure shows what was measured within its axis, and no trace of nothing", () => {
  const names = ({ data }) => data.map(({ name }) => name);
  const without = sphereCutFigure(SUBJECT, THEME, SIZE);
  assert.deepEqual(names(without), ["coulomb", "epsilon_t", "present impact"]);
  const { data } = sphereCutFigure({ ...SUBJECT, measured: MEASURED }, THEME, SIZE);
  assert.deepEqual(data[2].x, [0.2, 0.9]);
  assert.equal(data.length, 5);
});

test("sphereCutFigure tells what lies beyond its axis, and marks it nowhere", () => {
  const here = { share: 1.4, epsilon_t: 0.7, velocity: "g_t = 7 m/s" };
  const { data } = sphereCutFigure({ ...SUBJECT, measured: MEASURED, here }, THEME, SIZE);
  assert.deepEqual(data.find(({ name }) => name === "present impact").x, []);
  const told = data.find(({ name }) => name === "beyond the axis");
  assert.deepEqual([told.y[0], told.text[0]], [0.7, "g_t = 7 m/s →"]);
  assert.equal(told.text.length, 2);
});

test("a drag of sphereCutFigure moves marks only, more or fewer of them", () => {
  const before = sphereCutFigure({ ...SUBJECT, measured: MEASURED }, THEME, SIZE);
  const after = sphereCutFigure(
    { ...SUBJECT, measured: MEASURED.slice(1), here: { ...SUBJECT.here, share: 0.6 } },
    THEME,
    SIZE,
  );
  assert.ok(differInMarksOnly(before, after));
});
