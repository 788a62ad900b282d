import assert from "node:assert/strict";
import { test } from "node:test";

import {
  approximate,
  brief,
  duration,
  errorBound,
  percentage,
  powerOfTen,
  significant,
  typable,
} from "../../../frontend/format/number.js";
import { spreadNumbers } from "../random.js";

/** What a reader, or a test of the page, makes of a number as set. */
function read(text) {
  const digits = {
    "⁻": "-",
    "⁰": 0,
    "¹": 1,
    "²": 2,
    "³": 3,
    "⁴": 4,
    "⁵": 5,
    "⁶": 6,
    "⁷": 7,
    "⁸": 8,
    "⁹": 9,
  };
  const [mantissa, power = "10"] = text.replaceAll("\u2212", "-").split("\u202f×\u202f");
  const exponent = [...power.slice(2)].map((c) => digits[c]).join("");
  return Number(mantissa) * 10 ** Number(exponent || 0);
}

test("significant shows a number to the digits asked for, whatever its size", () => {
  for (const value of spreadNumbers(1, 500, 1e-300, 1e300)) {
    for (const signed of [value, -value]) {
      const shown = read(significant(signed, 4));
      assert.ok(Math.abs(shown - signed) <= 0.50001e-3 * Math.abs(signed), `${signed} as ${shown}`);
    }
  }
});

test("significant sets a real minus sign and a raised power of ten", () => {
  assert.equal(significant(-0.08634), "\u22120.08634");
  assert.equal(significant(-4.3e-5, 2), "\u22124.3\u202f×\u202f10⁻⁵");
});

test("significant keeps trailing zeros, for they are digits that are known", () => {
  assert.equal(significant(0.97), "0.9700");
});

test("significant carries a rounding into the next power", () => {
  assert.equal(significant(9.99996), "10.00");
  assert.equal(significant(0.00099999), "0.001000");
});

test("significant has a word for what is no number", () => {
  assert.equal(significant(null), "–");
  assert.equal(significant(Number.NaN), "–");
  assert.equal(significant(Infinity), "∞");
  assert.equal(significant(0), "0");
});

test("brief drops what a tick does not need", () => {
  assert.deepEqual([0, 0.01, -0.5, 1000, 1e-6, 3e7].map(brief), [
    "0",
    "0.01",
    "\u22120.5",
    "1000",
    "10⁻⁶",
    "3\u202f×\u202f10⁷",
  ]);
});

test("percentage calls only nothing nothing and only everything everything", () => {
  assert.equal(percentage(0), "0\u202f%");
  assert.equal(percentage(1), "100\u202f%");
  assert.equal(percentage(1e-9), "< 0.1\u202f%");
  assert.equal(percentage(1 - 1e-9), "> 99.9\u202f%");
  assert.equal(percentage(0.4567), "45.7\u202f%");
});

test("errorBound never shows less than the bound", () => {
  for (const bound of spreadNumbers(2, 500, 1e-300, 1)) {
    const text = errorBound(bound).slice(1);
    const shown = text.startsWith("10") ? read(`1\u202f×\u202f${text}`) : read(text);
    assert.ok(shown >= bound * (1 - 1e-8), `${bound} as ${text}`);
    assert.ok(shown <= 2.0001 * bound, `${bound} as ${text}`);
  }
});

test("errorBound leaves out a factor of one", () => {
  assert.equal(errorBound(1e-14), "±10⁻¹⁴");
  assert.equal(errorBound(1.2e-14), "±2\u202f×\u202f10⁻¹⁴");
});

test("duration takes the unit that suits", () => {
  assert.deepEqual([0.012, 0.46, 23.4, 1500, null].map(duration), [
    "12\u202fµs",
    "0.46\u202fms",
    "23\u202fms",
    "1.5\u202fs",
    "–",
  ]);
});

test("typable gives back the very number when read", () => {
  for (const value of spreadNumbers(3, 300, 1e-300, 1e300)) {
    assert.equal(Number(typable(value)), value);
  }
  assert.deepEqual([1.358, 1e12, 123_456.7].map(typable), ["1.358", "1e12", "123456.7"]);
});

test("powerOfTen raises every digit", () => {
  assert.equal(powerOfTen(-1203), "10⁻¹²⁰³");
});

test("approximate keeps two decimals, and no sign on nothing", () => {
  assert.deepEqual([0.0863, -0.0863, -0.001, 1].map(approximate), [
    "0.09",
    "−0.09",
    "0.00",
    "1.00",
  ]);
});
