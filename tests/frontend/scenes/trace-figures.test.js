import assert from "node:assert/strict";
import { test } from "node:test";

import { forceFigure } from "../../../frontend/scenes/explorer/force-figure.js";
import { overlayFigure } from "../../../frontend/scenes/accuracy/overlay-figure.js";
import { velocityFigure } from "../../../frontend/scenes/explorer/velocity-figure.js";
import { makeTrace, SIZE, THEME } from "../fixtures.js";

function named(figure, name) {
  return figure.data.find((trace) => trace.name === name);
}

test("forceFigure draws the force just as it came", () => {
  const trace = makeTrace();
  const line = named(forceFigure(trace, THEME, SIZE), "tangential force / mu");
  assert.equal(line.x, trace.time);
  assert.equal(line.y, trace.tangential_force_over_mu);
});

test("forceFigure draws the normal force on both sides of zero", () => {
  const { x, y } = named(forceFigure(makeTrace(), THEME, SIZE), "plus and minus normal force");
  assert.deepEqual([...x], [0, 1, 2, 3, 3, 2, 1, 0]);
  assert.deepEqual([...y], [0, 1, 1, 0, -0, -1, -1, -0]);
});

test("forceFigure gives each episode its width and the colour of its regime", () => {
  const figure = forceFigure(makeTrace(), THEME, SIZE);
  const [shades, ribbon] = [named(figure, "regimes"), named(figure, "ribbon")];
  for (const bars of [shades, ribbon]) {
    assert.deepEqual(bars.x, [0.5, 1.5, 2.5]);
    assert.deepEqual(bars.width, [1, 1, 1]);
  }
  assert.deepEqual(shades.marker.color, ["forward shade", "rgba(0,0,0,0)", "backward shade"]);
  assert.deepEqual(ribbon.marker.color, ["forward solid", "sticking solid", "backward solid"]);
  assert.deepEqual(ribbon.text, ["slides →", "sticks", "← slides"]);
});

test("forceFigure draws a small force larger, and says so", () => {
  const [small, usual, none] = [0.0007, 0.5, 0].map((force) =>
    forceFigure(
      makeTrace({ tangential_force_over_mu: Float64Array.of(0, -force, force, 0) }),
      THEME,
      SIZE,
    ),
  );
  assert.ok(Math.abs(named(small, "tangential force / mu").y[2] - 0.7) < 1e-12);
  assert.notEqual(named(small, "enlargement").text[0].trim(), "");
  for (const figure of [usual, none]) {
    assert.equal(named(figure, "enlargement").text[0].trim(), "");
  }
});

/** Slides for a third of the contact, then sticks and slides in turns of a hundredth of a pixel. */
function makeStiffTrace(changes = {}) {
  const count = 200;
  const ends = Array.from({ length: count }, (_, i) => 1 + (i + 1) * 1e-3);
  const episodes = [
    { regime: "sliding", start: 0, end: 1, direction: 1 },
    ...ends.map((end, i) => ({
      regime: i % 2 ? "sliding" : "sticking",
      start: end - 1e-3,
      end,
      direction: i % 2 ? -1 : 0,
    })),
  ];
  const times = Float64Array.from({ length: 300 }, (_, i) => 1 + i * 1e-3);
  return makeTrace({ episodes, switch_times: times, ...changes });
}

test("the band of regimes covers the contact where its list of episodes ends before it", () => {
  const figure = forceFigure(makeStiffTrace(), THEME, SIZE);
  const { x, width, marker, text } = named(figure, "ribbon");
  assert.equal(x.at(-1) + width.at(-1) / 2, 3);
  assert.deepEqual(marker.color, ["forward solid", "many solid"]);
  // How many it stands for is said on it.
  assert.match(text[1], /switches, too brief/);
});

test("no piece of the band is so narrow that it shimmers, whatever the width of the plot", () => {
  for (const width of [320, 600, 1600]) {
    const size = { ...SIZE, width };
    for (const draw of [forceFigure, velocityFigure]) {
      const { width: widths } = named(draw(makeStiffTrace(), THEME, size), "regimes");
      assert.ok(widths.every((time) => (time / 3) * (width - 62) >= 4));
    }
  }
});

test("overlayFigure has room for the force of strong damping, and for that of coarse steps", () => {
  const stepped = (force) => ({
    method_time: Float64Array.of(0, 1.5, 3),
    method_tangential_force_over_mu: Float64Array.of(0, force, 0),
  });
  const range = (force, changes) =>
    overlayFigure({ trace: makeTrace(changes), stepped: stepped(force) }, THEME, SIZE).layout.yaxis
      .range;
  assert.deepEqual(range(-1, {}), [-1.2, 1.2]);
  assert.deepEqual(range(-1, { normal_force: Float64Array.of(0, 2, 1, 0) }), [-2.1, 2.1]);
  assert.deepEqual(range(-2, {}), [-2.1, 2.1]);
});

test("forceFigure writes nothing on a piece of ribbon that is too short", () => {
  const ribbon = named(forceFigure(makeTrace(), THEME, { width: 120, height: 400 }), "ribbon");
  assert.deepEqual(
    ribbon.text.map((text) => text.trim()),
    ["", "", ""],
  );
});

test("forceFigure numbers the switches from 1", () => {
  const switches = named(forceFigure(makeTrace(), THEME, SIZE), "switches");
  assert.deepEqual(switches.x, [1, 2]);
  assert.deepEqual(switches.text, ["1", "2"]);
});

test("forceFigure leaves out the numbers of switches that would cover one another", () => {
  const times = Float64Array.from({ length: 100 }, (_, i) => 0.03 * i);
  const figure = forceFigure(makeTrace({ switch_times: times }), THEME, SIZE);
  assert.deepEqual(named(figure, "switches").text, []);
});

test("forceFigure keeps its axes from one collision to the next, unless a force goes beyond", () => {
  const range = (trace) => forceFigure(trace, THEME, SIZE).layout.yaxis.range;
  const other = makeTrace({ normal_force: Float64Array.of(0, 1.1, 1.14, 0) });
  assert.deepEqual(range(makeTrace()), range(other));
  const strong = makeTrace({ normal_force: Float64Array.of(0, 2, 1, 0) });
  assert.ok(range(strong)[0] < -2);
});

test("velocityFigure marks the turns where the velocity passes zero", () => {
  const turns = named(velocityFigure(makeTrace(), THEME, SIZE), "turns");
  assert.deepEqual(turns.x, [1.5]);
});

test("velocityFigure marks no turns rather than too few", () => {
  const turns = named(velocityFigure(makeTrace({ reversals: 3 }), THEME, SIZE), "turns");
  assert.deepEqual(turns.x, []);
});

test("velocityFigure holds the whole motion in its axis, for every size of it", () => {
  for (const scale of [5e-324, 1e-9, 0.3, 1, 7.5, 1e300]) {
    const velocity = Float64Array.of(1.2, 0.4, -0.4, -1.2).map((value) => value * scale);
    const figure = velocityFigure(makeTrace({ tangential_velocity: velocity }), THEME, SIZE);
    const [low, high] = figure.layout.yaxis.range;
    assert.ok(low <= Math.min(...velocity) && high >= Math.max(...velocity), `at ${scale}`);
    assert.ok(low < high, `at ${scale}`);
  }
});

test("velocityFigure has an axis of finite scale at both ends of the doubles", () => {
  for (const value of [5e-324, 1e-310, 1.7e308]) {
    const velocity = Float64Array.of(value, 0, 0, -value);
    const figure = velocityFigure(makeTrace({ tangential_velocity: velocity }), THEME, SIZE);
    const [low, high] = figure.layout.yaxis.range;
    assert.ok(high - low < Infinity && SIZE.height / (high - low) < Infinity, `at ${value}`);
  }
});

test("velocityFigure numbers its axis in a power of ten where plain digits would not fit", () => {
  const axisAt = (scale) => {
    const velocity = Float64Array.of(1, 0.4, -0.4, -0.5).map((value) => value * scale);
    return velocityFigure(makeTrace({ tangential_velocity: velocity }), THEME, SIZE).layout.yaxis;
  };
  assert.equal(axisAt(1).title.text, "");
  assert.equal(axisAt(1e-7).title.text, "× 10⁻⁷");
  assert.equal(axisAt(1e-280).title.text, "× 10⁻²⁸⁰");
  for (const scale of [1e-280, 1e-7, 1, 500, 1e9]) {
    assert.ok(axisAt(scale).ticktext.every((text) => text.length <= 5));
  }
});

test("velocityFigure draws a sphere without tangential velocity", () => {
  const still = makeTrace({ tangential_velocity: new Float64Array(4), reversals: 0 });
  const [low, high] = velocityFigure(still, THEME, SIZE).layout.yaxis.range;
  assert.ok(low < 0 && high > 0);
});

test("velocityFigure draws the energy as a share of the axis above zero, when it is asked for", () => {
  const plain = velocityFigure(makeTrace(), THEME, SIZE);
  assert.equal(named(plain, "tangential energy"), undefined);
  const trace = makeTrace();
  const { data, layout } = velocityFigure(trace, THEME, SIZE, true);
  const { x, y } = named({ data }, "tangential energy");
  assert.equal(x, trace.time);
  const full = layout.yaxis2.tickvals[layout.yaxis2.ticktext.indexOf("100 %")];
  assert.deepEqual(
    [...y].map((value) => Number((value / full).toPrecision(6))),
    [1, 0.416667, 0.277778, 0.173611],
  );
  assert.deepEqual(layout.yaxis2.range, layout.yaxis.range);
});

test("velocityFigure draws no energy where there is none to begin with", () => {
  for (const energy of [0, Infinity]) {
    const trace = makeTrace({ tangential_energy: new Float64Array(4).fill(energy) });
    const { y } = named(velocityFigure(trace, THEME, SIZE, true), "tangential energy");
    assert.deepEqual([...y], [0, 0, 0, 0]);
  }
});
