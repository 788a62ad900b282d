import assert from "node:assert/strict";
import { test } from "node:test";

import { differInMarksOnly } from "../../../frontend/figures/pixels.js";
import { createGhosts } from "../../../frontend/scenes/explorer/compare/ghosts.js";
import { forceFigure } from "../../../frontend/scenes/explorer/force-figure.js";
import { NO_GHOSTS, over } from "../../../frontend/scenes/explorer/ghosts.js";
import { createTrails, trailsOf } from "../../../frontend/scenes/explorer/trails.js";
import { velocityFigure } from "../../../frontend/scenes/explorer/velocity-figure.js";
import { makeTrace, SIZE, THEME } from "../fixtures.js";

const traces = Array.from({ length: 12 }, () => makeTrace());
const linesOf = (figure) => figure.data.filter(({ name }) => name.startsWith("trail "));

test("a trail is made of the last traces, evenly spaced on the slider, the older the fainter", () => {
  let shown = NO_GHOSTS;
  const trails = createTrails((next) => (shown = next));
  // a slider that stands at these shares as the traces arrive, of a range of 0.6
  const shares = [0, 0.01, 0.06, 0.07, 0.12, 0.18, 0.24, 0.3, 0.36, 0.42, 0.48, 0.42];
  shares.forEach((share, i) => trails.add(traces[i], share, 0.6));
  const lines = shown.lines("tangential_force_over_mu", THEME);
  const kept = [5, 6, 7, 8, 9, 10, 11];
  assert.ok(lines.every(({ y }, i) => y === traces[kept[i]].tangential_force_over_mu));
  assert.ok(lines.every(({ opacity }, i) => i === 0 || opacity > lines[i - 1].opacity));
  assert.ok(lines.at(-1).opacity <= 0.5);
  trails.clear();
  assert.equal(shown, NO_GHOSTS);
});

test("a picture takes in the next trace of a trail by moving lines that are there", () => {
  for (const makeFigure of [
    (ghosts) => forceFigure(makeTrace(), THEME, SIZE, ghosts),
    (ghosts) => velocityFigure(makeTrace(), THEME, SIZE, false, ghosts),
  ]) {
    const [first, second, full] = [1, 2, 7].map((count) =>
      makeFigure(trailsOf(traces.slice(0, count))),
    );
    assert.ok(differInMarksOnly(first, second) && differInMarksOnly(second, full));
    assert.equal(linesOf(first).length, linesOf(full).length);
  }
});

test("a trail has no letters and no dashes, and what is pinned lies over it", () => {
  const trace = makeTrace({
    contact_duration: 5,
    tangential_velocity: Float64Array.of(9, 1, 0, -8),
  });
  const collision = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.2, damping: 0 };
  const pins = createGhosts([
    { index: 0, collision, loaded: { trace, result: { epsilon_t: 0.2 } } },
  ]);
  const both = over(trailsOf(traces.slice(0, 3)), pins);
  const names = both.lines("tangential_velocity", THEME).map(({ name }) => name);
  assert.equal(names.at(-1), "pinned A");
  assert.equal(names.length, 8);
  assert.deepEqual(trailsOf(traces).letters("tangential_velocity", THEME), []);
  assert.ok(
    trailsOf(traces)
      .lines("tangential_velocity", THEME)
      .every(({ line }) => !line.dash),
  );
  assert.equal(both.velocity, 9);
  assert.equal(both.leastVelocity, -8);
  assert.equal(both.duration, Math.max(5, traces[0].contact_duration));
});
