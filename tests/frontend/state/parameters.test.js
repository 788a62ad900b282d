import assert from "node:assert/strict";
import { test } from "node:test";

import {
  collisionOfImpact,
  PARAMETERS,
  parseNumber,
  parseTyped,
  SOLID_ALPHA,
  SLIDER_STEPS,
  sliderStep,
  valueAtStep,
} from "../../../frontend/state/parameters.js";
import { logScale, powerScale } from "../../../frontend/state/scales.js";
import { spreadNumbers } from "../random.js";

const [kappa] = PARAMETERS;

test("scales lead from a value to its share and back", () => {
  for (const scale of [logScale(0.1, 1000), powerScale(0, 4, 1), powerScale(0, 4, 0.5)]) {
    for (const value of spreadNumbers(4, 100, 0.2, 3.9)) {
      assert.ok(Math.abs(scale.fromShare(scale.toShare(value)) / value - 1) < 1e-12);
    }
    assert.ok(Math.abs(scale.toShare(scale.min)) < 1e-15);
    assert.equal(scale.toShare(scale.max), 1);
  }
});

test("collisionOfImpact leaves out the digits that are rounding, and keeps 2/7", () => {
  const answer = {
    kappa: 4.7156432198765,
    mu_over_alpha: 1.4000000000000001,
    gt_over_gn: 0.1 + 0.2,
    damping: 1e-300 / 3,
    alpha: 0.28571428571428575,
    epsilon_t: 0.5,
  };
  assert.deepEqual(collisionOfImpact(answer), {
    collision: {
      kappa: 4.71564321988,
      mu_over_alpha: 1.4,
      gt_over_gn: 0.3,
      damping: 3.33333333333e-301,
    },
    alpha: SOLID_ALPHA,
  });
  assert.equal(collisionOfImpact({ ...answer, alpha: 0.4 + 1e-16 }).alpha, 0.4);
});

test("valueAtStep gives at every step of a slider a value the parameter admits, and ever greater ones", () => {
  for (const parameter of PARAMETERS) {
    const values = Array.from({ length: SLIDER_STEPS + 1 }, (_, i) => valueAtStep(parameter, i));
    assert.ok(values.every(parameter.admits), parameter.key);
    assert.ok(
      values.every((value, i) => i === 0 || value > values[i - 1]),
      parameter.key,
    );
  }
});

test("sliderStep finds the step a value came from", () => {
  for (const parameter of PARAMETERS) {
    for (let step = 0; step <= SLIDER_STEPS; step += 1) {
      assert.equal(sliderStep(parameter, valueAtStep(parameter, step)), step);
    }
  }
});

test("sliderStep puts a value beyond the slider at its end", () => {
  assert.equal(sliderStep(kappa, 37204), SLIDER_STEPS);
  assert.equal(sliderStep(kappa, 5e-324), 0);
});

const NO_NUMBERS = ["", "abc", "NaN", "Infinity", "1e999", "0x10", "1 2", "1_0", "--1", "<b>1</b>"];

test("parseNumber reads numbers with a decimal point and nothing else", () => {
  assert.deepEqual(
    ["63", "1e3", "+.5", "-5.", "5e-324"].map(parseNumber),
    [63, 1000, 0.5, -5, 5e-324],
  );
  for (const text of [...NO_NUMBERS, "0,5", "1,000", "\u22121"]) {
    assert.equal(parseNumber(text), null, text);
  }
});

test("parseTyped reads what is plainly a number, and leaves alone what may part thousands", () => {
  const typed = ["63", " 1e3 ", "+.5", "0,5", "\u22125", "1.000", "0,500", "1,5e3", "1234,567"];
  assert.deepEqual(
    typed.map((text) => parseTyped(text, ".")),
    [63, 1000, 0.5, 0.5, -5, 1, 0.5, 1500, 1234.567],
  );
  for (const text of [...NO_NUMBERS, "1,000", "-63,000", "1,000e3", "1,000.5"]) {
    assert.equal(parseTyped(text, "."), null, text);
  }
});

test("parseTyped has the marks the other way round where the comma is the decimal mark", () => {
  assert.deepEqual(
    ["0,5", "1,358", "1.35", "0.500"].map((text) => parseTyped(text, ",")),
    [0.5, 1.358, 1.35, 0.5],
  );
  for (const text of ["1.000", "63.000e3"]) {
    assert.equal(parseTyped(text, ","), null, text);
  }
});
