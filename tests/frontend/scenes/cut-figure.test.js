import assert from "node:assert/strict";
import { test } from "node:test";

import { switchClasses } from "../../../frontend/figures/color-scales.js";
import { cutFigure, hasStiffLimit } from "../../../frontend/scenes/explorer/cut/cut-figure.js";
import { mapView } from "../../../frontend/state/map-view.js";
import { SIZE, THEME } from "../fixtures.js";

const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };
const LETTERS = [
  { letter: "a", kappa: 63, psi: 2.2 },
  { letter: "e", kappa: 63, psi: 0.97 },
  { letter: "n", kappa: 63, psi: 0.03 },
  { letter: "o", kappa: 63, psi: 0.005 },
];
const CUT = {
  values: Float64Array.of(0.01, 1.0075, 2.005, 3.0025, 4),
  epsilon_t: Float64Array.of(0.97, 0.03, -0.01, 0.07, 0.3),
  switches: Int32Array.of(4, 6, 6, 0, 0),
  coulomb: Float64Array.of(0, 0, 0, 0.07, 0.3),
  stiff_bound: Float64Array.of(1, 0.2, 0.1, NaN, NaN),
  stiff_asymptote: Float64Array.of(3.5, 0.04, 0.02, NaN, NaN),
};

function figure(changes = {}, { scale = "linear", map_y = "gt_over_gn" } = {}) {
  const view = mapView(AT, { scale, map_y });
  const place = { view, along: "gt_over_gn", held: 63, muOverAlpha: 1.4 };
  const subject = { ...place, cut: CUT, vertical: "linear", letters: LETTERS, most: 8 };
  return cutFigure({ ...subject, ...changes }, THEME, SIZE);
}

function named(name, ...rest) {
  return figure(...rest).data.find((trace) => trace.name === name);
}

test("cutFigure draws ε_t and Coulomb's law just as they came, from end to end of the axis", () => {
  assert.equal(named("epsilon_t").y, CUT.epsilon_t);
  assert.equal(named("coulomb").y, CUT.coulomb);
  assert.deepEqual([...named("epsilon_t").x], [0, 0.25, 0.5, 0.75, 1]);
});

test("cutFigure draws the stiff limits where they exist and lie on the axis, on both sides", () => {
  assert.deepEqual(named("stiff bound").y, [1, 0.2, 0.1]);
  assert.deepEqual(named("stiff bound, below").y, [-1, -0.2, -0.1]);
  assert.deepEqual(named("stiff limit").y, [0.04, 0.02]);
  assert.deepEqual(named("stiff limit, below").y, [-0.04, -0.02]);
});

test("cutFigure keeps a limit that is nowhere on the axis out of sight", () => {
  const soft = { ...CUT, stiff_asymptote: Float64Array.of(90, 9, 4, NaN, NaN) };
  const { y } = named("stiff limit", { cut: soft });
  assert.ok(y.every((value) => value > figure({ cut: soft }).layout.yaxis.range[1]));
});

test("cutFigure keeps its axis from one cut to the next, so that a drag shakes nothing", () => {
  const deep = { ...CUT, epsilon_t: Float64Array.of(1, -1, 0, 0, 0) };
  const [{ range }, { range: other }] = [{}, { cut: deep }].map((c) => figure(c).layout.yaxis);
  assert.deepEqual(range, other);
  assert.ok(range[0] < -1 && range[1] > 1);
});

test("cutFigure gives each run of one count its width and its colour on the map", () => {
  const colors = switchClasses(8, false).map(({ color }) => color);
  const { x, width, marker } = named("switches");
  assert.deepEqual(width, [0.125, 0.5, 0.375]);
  assert.deepEqual(x, [0.0625, 0.375, 0.8125]);
  assert.deepEqual(marker.color, [colors[2], colors[3], colors[0]]);
});

test("cutFigure leaves the ribbon open where the number of switches is not known", () => {
  const cut = { ...CUT, switches: Float64Array.of(NaN, NaN, NaN, 0, 0) };
  assert.deepEqual(named("switches", { cut }).width, [0.625, 0.375]);
  assert.equal(named("switches", { cut }).marker.color[0], "rgba(0,0,0,0)");
});

test("cutFigure puts each letter at its ψ, on either axis", () => {
  for (const [changes, options] of [
    [{}, {}],
    [{ muOverAlpha: 1 }, { map_y: "psi" }],
  ]) {
    const { x, text } = named("letters", changes, options);
    const { gtOverGn } = mapView(AT, { scale: "linear", map_y: "gt_over_gn", ...options });
    const psi = gtOverGn.fromShare(x[text.indexOf("e")]) / (changes.muOverAlpha ?? 1.4);
    assert.ok(Math.abs(psi - 0.97) < 1e-12);
  }
});

test("cutFigure leaves out the letters that would cover others or lie beyond the axis", () => {
  assert.deepEqual(named("letters").text, ["a", "e", "n"]);
  assert.deepEqual(named("letters", {}, { scale: "log" }).text, ["a", "e", "n", "o"]);
  assert.deepEqual(named("letters", { muOverAlpha: 4 }).text, ["e", "n"]);
});

test("cutFigure names no letters far from the κ they were drawn at", () => {
  assert.deepEqual(named("letters", { held: 70 }).text, ["a", "e", "n"]);
  assert.deepEqual(named("letters", { held: 18 }).text, []);
});

test("cutFigure draws the stiff limit dotted, and only below the bound: above it says nothing", () => {
  const soft = { ...CUT, stiff_asymptote: Float64Array.of(0.9, 0.3, 0.05, NaN, NaN) };
  const { x, y, line } = named("stiff limit", { cut: soft });
  assert.deepEqual(
    [x, y],
    [
      [0, 0.5],
      [0.9, 0.05],
    ],
  );
  const [on, off] = line.dash.split(",").map(parseFloat);
  // as long as it is wide, and not a dash as Coulomb's law has them
  assert.ok(on <= line.width && off >= 2 * on);
  assert.notEqual(line.dash, named("coulomb").line.dash);
  assert.ok(!hasStiffLimit({ ...CUT, stiff_asymptote: Float64Array.of(3, 2, 1, NaN, NaN) }));
  assert.ok(hasStiffLimit(CUT));
});

const LOG = { vertical: "log" };

test("cutFigure shows magnitudes on a logarithmic axis, what is negative on a line of its own", () => {
  const { x, y } = named("epsilon_t", LOG);
  const positive = [0.97, 0.03, null, 0.07, 0.3].map((v) => v && Math.log10(v));
  for (const value of positive.filter((v) => v !== null)) {
    assert.ok(y.includes(value));
  }
  const negative = named("epsilon_t, negative", LOG);
  assert.ok(negative.y.includes(-2));
  assert.equal(negative.x[negative.y.indexOf(-2)], 0.5);
  assert.notEqual(negative.line.dash, undefined);
  assert.ok(!x.includes(0.5));
});

test("cutFigure takes both lines down to the floor where ε_t goes through zero, in one place", () => {
  const { axis } = figure(LOG);
  const zeros = (name) => {
    const { x, y } = named(name, LOG);
    return x.filter((_, i) => y[i] === axis.floor);
  };
  assert.deepEqual(zeros("epsilon_t"), zeros("epsilon_t, negative"));
  // 0.03 to −0.01 and −0.01 to 0.07, from sample to sample a quarter apart
  for (const [i, at] of [0.4375, 0.53125].entries()) {
    assert.ok(Math.abs(zeros("epsilon_t")[i] - at) < 1e-12);
  }
});

test("cutFigure has no point for a zero on a logarithmic axis, and none that is not finite but a gap", () => {
  const cut = { ...CUT, epsilon_t: Float64Array.of(0, 0.5, 0, 0.25, NaN) };
  const { x, y } = named("epsilon_t", { ...LOG, cut });
  const { floor } = figure({ ...LOG, cut }).axis;
  assert.deepEqual(x, [0, 0.25, 0.5, 0.25, 0.5, 0.75, 0.75]);
  const halves = [0.5, 0.25].map(Math.log10);
  assert.deepEqual(y, [floor, halves[0], floor, NaN, floor, halves[1], NaN]);
  const { range } = figure({ ...LOG, cut }).layout.yaxis;
  assert.ok(named("epsilon_t, negative", { ...LOG, cut }).y.every((height) => height > range[1]));
});

test("cutFigure has a logarithmic axis down to where the curve is, three decades at least", () => {
  const reach = (...values) => {
    const cut = { ...CUT, epsilon_t: Float64Array.of(...values) };
    const { axis, layout } = figure({ ...LOG, cut });
    assert.ok(layout.yaxis.tickvals.every((tick) => tick >= axis.floor && tick <= 0));
    assert.ok(layout.yaxis.tickvals.length >= 3 && layout.yaxis.tickvals.length <= 6);
    return axis.floor;
  };
  assert.equal(reach(0.5, 0.4, 0.3, 0.2, 0.1), -3);
  assert.equal(reach(2e-5, 3e-5, -4e-5, 1, 1), -5);
  assert.equal(reach(1e-40, 1e-40, 1, 1, 1), -15);
  assert.equal(reach(0, 0, 0, 0, 0), -3);
});

test("cutFigure runs along κ, without letters, which are of one κ", () => {
  const changes = { along: "kappa", held: 1.358 };
  const { tickvals, ticktext, title } = figure(changes).layout.xaxis;
  assert.match(title.text, /κ/);
  const { kappa } = mapView(AT, { scale: "linear", map_y: "gt_over_gn" });
  assert.deepEqual(
    tickvals,
    ticktext.map((text) => kappa.toShare(Number(text))),
  );
  assert.deepEqual(named("letters", changes).text, []);
});
