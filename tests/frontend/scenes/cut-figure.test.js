import assert from "node:assert/strict";
import { test } from "node:test";

import { switchClasses } from "../../../frontend/figures/color-scales.js";
import { cutFigure } from "../../../frontend/scenes/explorer/cut-figure.js";
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
  const subject = { cut: CUT, view, kappa: 63, muOverAlpha: 1.4, letters: LETTERS, most: 8 };
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
  assert.deepEqual(named("stiff asymptote").y, [0.04, 0.02]);
  assert.deepEqual(named("stiff asymptote, below").y, [-0.04, -0.02]);
});

test("cutFigure keeps a limit that is nowhere on the axis out of sight", () => {
  const soft = { ...CUT, stiff_asymptote: Float64Array.of(90, 9, 4, NaN, NaN) };
  const { y } = named("stiff asymptote", { cut: soft });
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
  assert.deepEqual(named("letters", { kappa: 70 }).text, ["a", "e", "n"]);
  assert.deepEqual(named("letters", { kappa: 18 }).text, []);
});
