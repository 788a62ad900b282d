import assert from "node:assert/strict";
import { test } from "node:test";

import { heatPixels, heatPlace } from "../../../frontend/figures/heat-image.js";
import { pixelScale } from "../../../frontend/figures/pixels.js";

const MAP = {
  z: [Float64Array.of(-1, 0, 0.5), Float64Array.of(7, NaN, -7)],
  zmin: -1,
  zmax: 1,
  colorscale: [
    [0, "#000000"],
    [0.5, "#204060"],
    [1, "#406080"],
  ],
  x0: 0,
  dx: 1 / 2,
  y0: 0,
  dy: 1,
};

test("heatPixels has the last row first, each value in its colour, what is beyond in that of the end, and nothing for no number", () => {
  assert.deepEqual(
    [...heatPixels(MAP)],
    [
      [64, 96, 128, 255],
      [0, 0, 0, 0],
      [0, 0, 0, 255],
      [0, 0, 0, 255],
      [32, 64, 96, 255],
      [48, 80, 112, 255],
    ].flat(),
  );
});

test("heatPixels of a scale in steps has no colour between two", () => {
  const colorscale = [
    [0, "#100000"],
    [0.5, "#100000"],
    [0.5, "#200000"],
    [1, "#200000"],
  ];
  const z = [Int32Array.of(-1, 0, 1, 2)];
  const red = heatPixels({ ...MAP, z, zmin: -1, zmax: 3, colorscale }).filter(
    (_, i) => i % 4 === 0,
  );
  assert.deepEqual([...red], [16, 16, 32, 32]);
});

test("heatPlace has half a cell more than the axes on each side", () => {
  const axes = { xaxis: { range: [0, 1] }, yaxis: { range: [0, 1] } };
  const scale = pixelScale({
    ...{ width: 130, height: 70, margin: { l: 20, r: 10, t: 5, b: 15 } },
    ...axes,
  });
  assert.deepEqual(heatPlace(MAP, scale), { x: -25, y: -25, width: 150, height: 100 });
});
