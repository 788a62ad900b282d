import assert from "node:assert/strict";
import { test } from "node:test";

import {
  restitutionColors,
  restitutionPlace,
  restitutionStops,
  switchClasses,
  switchStops,
} from "../../../frontend/figures/color-scales.js";
import { mapFigure, mostSwitches } from "../../../frontend/figures/map-figure.js";
import { horizontalAxis, mapView } from "../../../frontend/state/map-view.js";
import { luminance } from "../contrast.js";
import { SIZE, THEME } from "../fixtures.js";

const GRID = {
  kappa: Float64Array.of(0.1, 35, 70),
  gt_over_gn: Float64Array.of(0.01, 4),
  epsilon_t: [Float64Array.of(-1, 0, 1), Float64Array.of(0.1, 0.2, 0.3)],
  switches: [Int32Array.of(2, 8, 6), Int32Array.of(0, 0, 2)],
};
const AT = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };

function viewOf(scale) {
  return mapView(AT, { scale, map_y: "gt_over_gn" });
}

function figure(quantity, scale, symbol = "kappa", alpha = 2 / 7) {
  const view = viewOf(scale);
  const horizontal = horizontalAxis(view, symbol, alpha);
  return mapFigure({ grid: GRID, view, horizontal, quantity, most: 8 }, THEME, SIZE);
}

test("mapFigure shows the grid as it came, its first and last columns on the ends of the axis", () => {
  const [{ z, x0, dx, y0, dy }] = figure("epsilon_t", "linear").data;
  assert.equal(z, GRID.epsilon_t);
  assert.deepEqual([x0, x0 + 2 * dx, y0, y0 + dy], [0, 1, 0, 1]);
});

test("mapFigure of the switches has the letters of Fig. 5 where they lie, each readable", () => {
  const view = viewOf("linear");
  const horizontal = horizontalAxis(view, "kappa", 2 / 7);
  const letters = [1, 0.999, 0.5, 9].map((psi, i) => ({ letter: "abcd"[i], kappa: 35, psi }));
  const shown = { grid: GRID, view, horizontal, letters, muOverAlpha: 1.4 };
  const texts = (quantity) =>
    mapFigure({ ...shown, quantity }, THEME, SIZE).data.find(({ name }) => /letters/.test(name));
  assert.equal(texts("epsilon_t"), undefined);
  // One lies on another, one beyond the axis.
  assert.deepEqual(texts("switches").text, ["a", "c"]);
  assert.ok(Math.abs(texts("switches").y[0] - view.gtOverGn.toShare(1.4)) < 1e-12);
});

test("mapFigure puts each tick where its value lies", () => {
  for (const scale of ["linear", "log"]) {
    const view = viewOf(scale);
    const { tickvals, ticktext } = figure("epsilon_t", scale).layout.xaxis;
    assert.ok(tickvals.length >= 4);
    for (const [i, share] of tickvals.entries()) {
      assert.ok(share >= -1e-12 && share <= 1 + 1e-12);
      assert.ok(Math.abs(view.kappa.fromShare(share) / Number(ticktext[i]) - 1) < 1e-9);
    }
  }
});

test("mapFigure relabels the horizontal axis and leaves the picture", () => {
  const [kappa, paper] = ["kappa", "alpha_kappa"].map((symbol) =>
    figure("epsilon_t", "linear", symbol),
  );
  assert.deepEqual(kappa.data, paper.data);
  const at20 = paper.layout.xaxis.ticktext.indexOf("20");
  assert.ok(Math.abs(paper.layout.xaxis.tickvals[at20] - 1) < 1e-12);
});

test("mapFigure says in words whose α the axis ακ has", () => {
  const title = (...axis) => figure("epsilon_t", "linear", ...axis).layout.xaxis.title.text;
  assert.equal(title("alpha_kappa"), "<i>ακ</i> with <i>α</i>\u00a0=\u00a02/7, solid spheres");
  assert.equal(title("alpha_kappa", 0.4), "<i>ακ</i> with <i>α</i>\u00a0=\u00a00.4");
  assert.equal(title("kappa", 0.4), "<i>κ</i>");
});

test("mapFigure gives counts one colour for each pair of switches", () => {
  const [{ zmin, zmax, colorscale }] = figure("switches", "linear").data;
  const color = (count) => {
    const share = (count - zmin) / (zmax - zmin);
    return colorscale.findLast(([stop]) => stop <= share)[1];
  };
  const colors = [0, 2, 4, 6, 8].map(color);
  assert.deepEqual(
    colors,
    switchClasses(8, false).map((one) => one.color),
  );
  assert.equal(new Set(colors).size, 5);
  assert.equal(mostSwitches(GRID), 8);
  // one of a drag keeps those of the map before it, odd or even as its own are
  assert.equal(mostSwitches(GRID, 12), 12);
  assert.equal(mostSwitches(GRID, 13), 12);
  assert.equal(mostSwitches(GRID, 6), 8);
  assert.equal(mostSwitches(GRID, 9), 8);
});

test("switchClasses ends with one that says it holds more", () => {
  const labels = switchClasses(120, false).map(({ label }) => label);
  assert.deepEqual(labels, ["0", "2", "4", "6", "8", "10", "12", "14", "≥ 16"]);
  assert.deepEqual(
    switchStops(switchClasses(0, false)).map(([stop]) => stop),
    [0, 1],
  );
});

test("restitutionStops runs from −1 to 1, in order, with the page's colour at 0", () => {
  for (const dark of [false, true]) {
    const stops = restitutionStops(dark);
    const colors = restitutionColors(dark);
    assert.deepEqual(stops[0], [0, colors[0]]);
    assert.deepEqual(stops.at(-1), [1, colors.at(-1)]);
    assert.ok(stops.slice(1).every(([stop], i) => stop > stops[i][0]));
    assert.equal(stops.find(([stop]) => stop === 0.5)[1], colors[4]);
  }
});

test("the colours of ε_t tell its size by lightness alone, for those who see no hue", () => {
  for (const dark of [false, true]) {
    const light = restitutionColors(dark).map(luminance);
    const away = (values) => values.map((value) => (dark ? value : -value));
    for (const side of [away(light.slice(4)), away(light.slice(0, 5).reverse())]) {
      assert.ok(side.slice(1).every((value, i) => value > side[i]));
    }
  }
});

test("restitutionPlace spreads the small values, and keeps the ends and the middle", () => {
  assert.deepEqual([-1, 0, 0.25, 1].map(restitutionPlace), [0, 0.5, 0.75, 1]);
});

test("switchClasses of damped collisions are odd", () => {
  const classes = switchClasses(5, false);
  assert.deepEqual(
    classes.map(({ switches }) => switches),
    [1, 3, 5],
  );
});
