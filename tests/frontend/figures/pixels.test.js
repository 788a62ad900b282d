import assert from "node:assert/strict";
import { test } from "node:test";

import { forceFigure } from "../../../frontend/scenes/explorer/force-figure.js";
import {
  barPlaces,
  differInMarksOnly,
  linePath,
  pixelScale,
} from "../../../frontend/figures/pixels.js";
import { makeTrace, SIZE, THEME } from "../fixtures.js";

const LAYOUT = {
  width: 130,
  height: 70,
  margin: { l: 20, r: 10, t: 5, b: 15 },
  xaxis: { range: [0, 2] },
  yaxis: { range: [-1, 1] },
};

/** The figure of the made-up trace with the first switch at another time, and perhaps more changed. */
function figureWithSwitchAt(time, { theme = THEME, size = SIZE, ...changes } = {}) {
  const { episodes } = makeTrace();
  const moved = [{ ...episodes[0], end: time }, { ...episodes[1], start: time }, episodes[2]];
  const trace = makeTrace({ episodes: moved, switch_times: Float64Array.of(time, 2), ...changes });
  return forceFigure(trace, theme, size);
}

test("pixelScale counts from the upper left corner between the axes", () => {
  const scale = pixelScale(LAYOUT);
  const corners = [scale.x(0), scale.x(2), scale.y(1), scale.y(-1)];
  assert.deepEqual(
    corners.map((pixels) => pixels + 0),
    [0, 100, 0, 50],
  );
});

test("linePath leads from point to point, but not over a gap", () => {
  const line = { x: Float64Array.of(0, 1, 2), y: Float64Array.of(1, 0, -1) };
  assert.equal(linePath(line, pixelScale(LAYOUT)), "M0,0L50,25L100,50");
  const broken = { x: [0, 1, 1, 2], y: [1, 0, NaN, -1] };
  assert.equal(linePath(broken, pixelScale(LAYOUT)), "M0,0L50,25M100,50");
});

test("barPlaces outlines a bar from its base and finds its middle", () => {
  const bars = { x: [0.5], width: [1], base: [-1], y: [2] };
  assert.deepEqual(barPlaces(bars, pixelScale(LAYOUT)), [{ path: "M0,50V0H50V50Z", middle: 25 }]);
});

test("differInMarksOnly lets marks move, come and go, and words with them", () => {
  const { episodes } = makeTrace();
  for (const other of [
    figureWithSwitchAt(1.3),
    figureWithSwitchAt(0.01),
    figureWithSwitchAt(1, { episodes: episodes.slice(0, 2) }),
    figureWithSwitchAt(1, { switch_times: Float64Array.of(1) }),
    figureWithSwitchAt(1, { episodes: episodes.map((one) => ({ ...one, direction: 1 })) }),
    // the same ticks at other places
    figureWithSwitchAt(1, { contact_duration: 3.5 }),
    figureWithSwitchAt(1, { normal_force: Float64Array.of(0, 2, 1, 0) }),
  ]) {
    assert.ok(differInMarksOnly(figureWithSwitchAt(1), other));
  }
});

test("differInMarksOnly sees other axes, another style, another size", () => {
  for (const change of [
    { contact_duration: 4.5 },
    { theme: { ...THEME, tangentialForce: "other" } },
    { size: { ...SIZE, width: 601 } },
  ]) {
    assert.ok(!differInMarksOnly(figureWithSwitchAt(1), figureWithSwitchAt(1, change)));
  }
});
