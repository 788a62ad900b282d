import assert from "node:assert/strict";
import { test } from "node:test";

import { createGhosts } from "../../../frontend/scenes/explorer/compare/ghosts.js";
import { forceFigure } from "../../../frontend/scenes/explorer/force-figure.js";
import { velocityFigure } from "../../../frontend/scenes/explorer/velocity-figure.js";
import { makeTrace, SIZE, THEME } from "../fixtures.js";

const long = makeTrace({
  time: Float64Array.of(0, 2, 4, 5),
  tangential_force_over_mu: Float64Array.of(0, -1.5, 1, 0),
  tangential_velocity: Float64Array.of(3.8, 1, 0, -3.7),
  contact_duration: 5,
});

const pinned = (index, trace) => ({
  index,
  collision: { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.2, damping: 0 },
  loaded: { trace, result: { epsilon_t: 0.25 } },
});

const named = (figure, name) => figure.data.find((trace) => trace.name === name);

test("the axes grow to hold what is pinned, whose lines are drawn from the arrays that came", () => {
  const ghosts = createGhosts([pinned(1, long)]);
  const force = forceFigure(makeTrace(), THEME, SIZE, ghosts);
  const velocity = velocityFigure(makeTrace(), THEME, SIZE, false, ghosts);
  for (const [figure, column] of [
    [force, "tangential_force_over_mu"],
    [velocity, "tangential_velocity"],
  ]) {
    const line = named(figure, "pinned B");
    assert.equal(line.x, long.time);
    assert.equal(line.y, long[column]);
    assert.equal(line.line.color, "pin B");
    const { xaxis, yaxis } = figure.layout;
    assert.ok(xaxis.range[1] >= 5);
    assert.ok(long[column].every((value) => value > yaxis.range[0] && value < yaxis.range[1]));
  }
});

test("a small force beside a large one that is pinned is drawn as it is, beside another small one larger", () => {
  const small = (force) =>
    makeTrace({ tangential_force_over_mu: Float64Array.of(0, -force, force, 0) });
  const drawn = (ghosts) => forceFigure(small(0.0007), THEME, SIZE, createGhosts(ghosts));
  assert.equal(named(drawn([pinned(0, long)]), "tangential force / mu").y[2], 0.0007);
  const both = drawn([pinned(0, small(0.004))]);
  const [present, other] = ["tangential force / mu", "pinned A"].map((name) => named(both, name));
  assert.ok(Math.abs(other.y[2] / present.y[2] - 40 / 7) < 1e-12);
  assert.ok(other.y[2] > 0.3);
});

test("lines differ in dash and letter, not in colour alone, and from those that are there", () => {
  const ghosts = createGhosts([0, 1, 2].map((index) => pinned(index, long)));
  const lines = ghosts.lines("tangential_velocity", THEME);
  assert.equal(new Set(lines.map(({ line }) => line.dash)).size, 3);
  const present = velocityFigure(makeTrace(), THEME, SIZE, true, ghosts);
  const others = present.data.map(({ line }) => line?.dash).filter(Boolean);
  assert.equal(new Set(others).size, others.length);
  const [letters] = ghosts.letters("tangential_velocity", THEME);
  assert.deepEqual(letters.text, ["A", "B", "C"]);
});

test("a mark beyond the axes is at their end with an arrow, and what has no answer has none", () => {
  const silent = { ...pinned(1, null), loaded: null };
  const ghosts = createGhosts([pinned(0, null), silent]);
  const place = { x: 1.7, y: 0.5, beyond: { x: 1, y: 0 } };
  const figure = { data: [], layout: { yaxis: { range: [-2, 2] } } };
  const [marks] = ghosts.marks(() => place, figure, THEME);
  assert.deepEqual([marks.text, marks.x, marks.y], [["A→"], [1], [0]]);
  assert.deepEqual(ghosts.lines("tangential_velocity", THEME), []);
  assert.deepEqual(
    createGhosts([silent]).marks(() => place, figure, THEME),
    [],
  );
});
