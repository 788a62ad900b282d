import assert from "node:assert/strict";
import { test } from "node:test";

import { createLaws } from "../../../frontend/scenes/paper/laws.js";
import { collapseFigure, spreadOf } from "../../../frontend/scenes/paper/collapse-figure.js";
import {
  collapseTable,
  stiffLawTable,
  switchLawTable,
} from "../../../frontend/scenes/paper/tables.js";
import { stiffLawFigure, stiffReach } from "../../../frontend/scenes/paper/stiff-law-figure.js";
import { switchLawFigure, switchLawOf } from "../../../frontend/scenes/paper/switch-law-figure.js";
import { THEME } from "../fixtures.js";

const SIZE = { width: 400, height: 300 };
const CURVES = [0.7, 1.4, 2.8].map((muOverAlpha) => ({
  muOverAlpha,
  psi: [0, 1, 2, 3],
  gtOverGn: [0, 1, 2, 3].map((psi) => psi * muOverAlpha),
  epsilonT: [-0.5, 0.1, 0, 1 / 3],
}));
const KAPPA = [10, 100, 1000];
const CUTS = [0.5, 1.5].map((psi) => ({
  psi,
  kappa: KAPPA,
  epsilonT: [0.1, -0.01, 0].map((value) => value / psi),
  bound: KAPPA.map((kappa) => Math.min(1, 1.1433 / Math.sqrt(kappa) / psi)),
  asymptote: KAPPA.map((kappa) => (4.4848 * kappa ** -1.25) / psi),
}));

test("collapseFigure draws each curve over both axes, the topmost the thinnest where they are one", () => {
  const { data } = collapseFigure(CURVES, THEME, SIZE);
  assert.equal(data.length, 6);
  for (const [i, curve] of CURVES.entries()) {
    assert.deepEqual(data[2 * i].x, curve.gtOverGn);
    assert.deepEqual(data[2 * i + 1].x, curve.psi);
    assert.equal(data[2 * i + 1].xaxis, "x2");
    assert.deepEqual(data[2 * i + 1].y, curve.epsilonT);
  }
  const widths = [1, 3, 5].map((i) => data[i].line.width);
  assert.deepEqual(
    widths,
    [...widths].sort((a, b) => b - a),
  );
});

test("spreadOf is the largest difference at the same ψ", () => {
  assert.equal(spreadOf(CURVES), 0);
  const off = { ...CURVES[2], epsilonT: [-0.5, 0.1, 0.25, 1 / 3] };
  assert.equal(spreadOf([CURVES[0], off]), 0.25);
});

test("stiffLawFigure scales points and lines by ψ alike and leaves out what is 0", () => {
  const { data } = stiffLawFigure(CUTS, THEME, SIZE);
  const [points, limit, bound] = data;
  assert.equal(points.x.length, 4);
  assert.ok(Math.abs(points.y[0] - Math.log10(0.1)) < 1e-12);
  limit.y.forEach((y, i) => assert.ok(Math.abs(10 ** y / (4.4848 * KAPPA[i] ** -1.25) - 1) < 1e-9));
  assert.ok(Math.abs(10 ** bound.y[2] / (1.1433 / Math.sqrt(1000)) - 1) < 1e-9);
});

test("stiffReach finds the constant in the data, and how near to it the collisions come", () => {
  const { reach, constant } = stiffReach(CUTS);
  assert.ok(Math.abs(constant - 4.4848) < 1e-9);
  assert.ok(Math.abs(reach - 0.01 / (4.4848 * 100 ** -1.25)) < 1e-9);
});

test("switchLawFigure shows the most switches of each κ under the law", () => {
  const law = switchLawOf({
    kappa: [10, 1000],
    switches: [
      [2, 30],
      [4, 8],
    ],
    largest_switches: [
      [3.2, 32.4],
      [3.2, 32.4],
    ],
  });
  assert.deepEqual(law, { kappa: [10, 1000], most: [4, 30], law: [3.2, 32.4] });
  const { data } = switchLawFigure(law, THEME, SIZE);
  assert.deepEqual(data[0].y, [Math.log10(4), Math.log10(30)]);
  assert.deepEqual(data[1].y, [Math.log10(3.2), Math.log10(32.4)]);
  assert.deepEqual(switchLawTable(law).rows, [
    ["10.00", "4", "3.200"],
    ["1000", "30", "32.40"],
  ]);
});

test("tables of the laws have a column for each curve", () => {
  assert.equal(collapseTable(CURVES).rows.length, 4);
  assert.equal(collapseTable(CURVES).headings.length, 4);
  assert.deepEqual(stiffLawTable(CUTS).headings, ["κ", "ψ = 0.50", "ψ = 1.5"]);
});

test("createLaws asks for the same ψ at every friction", async () => {
  const asked = [];
  const laws = createLaws(async (call, query) => {
    asked.push([call, query]);
    return { values: Float64Array.of(query.minimum, query.maximum), epsilon_t: [0, 0] };
  });
  const curves = await laws.load.collapse();
  assert.deepEqual(
    asked.map(([call, { kappa }]) => [call, kappa]),
    [
      ["cut", "5"],
      ["cut", "5"],
      ["cut", "5"],
    ],
  );
  for (const { psi } of curves) {
    assert.ok(Math.abs(psi[0] - 0.01) < 1e-12);
    assert.ok(Math.abs(psi[1] - 3) < 1e-12);
  }
  assert.deepEqual(
    laws.queries.collapse(),
    asked.map(([, query]) => query),
  );
});
