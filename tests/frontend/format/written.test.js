import assert from "node:assert/strict";
import { test } from "node:test";

import {
  alphaInWords,
  approximate,
  brief,
  duration,
  errorBound,
  percentage,
  powerOfTen,
  significant,
  typable,
} from "../../../frontend/format/number.js";
import { decimalMark, learn } from "../../../frontend/format/words.js";
import { readWritten } from "../../../frontend/format/written.js";
import { IMPACT_PARAMETERS } from "../../../frontend/state/impact.js";
import { PARAMETERS, parseTyped } from "../../../frontend/state/parameters.js";
import { LOCALES, wordsOf } from "../locales.js";
import { spreadNumbers } from "../random.js";

learn(wordsOf("en"));

const NUMBER = { subject: "κ" };
const RADIUS = { subject: "the radius", unit: "m" };
const MODULUS = { subject: "the Young’s modulus", unit: "Pa" };
const STIFFNESS = { subject: "the tangential stiffness", unit: "N/m" };
const VELOCITY = { subject: "the normal velocity", unit: "m/s" };
const TIME = { subject: "the dissipative constant", unit: "s" };
const DENSITY = { subject: "the density", unit: "kg/m³" };
const ANGLE = { subject: "the angle", unit: "°" };

/** Field, text, value; in English, where the point is the decimal mark. */
const READ = [
  // plainly numbers
  [NUMBER, "63", 63],
  [NUMBER, " 63 ", 63],
  [NUMBER, "+.5", 0.5],
  [NUMBER, "5.", 5],
  [NUMBER, "1.358", 1.358],
  [NUMBER, "1.000", 1],
  [NUMBER, "5e-324", 5e-324],
  [NUMBER, "1E+03", 1000],
  [NUMBER, "4.03d8", 4.03e8],
  // as the page and papers print them
  [NUMBER, "−1.888 × 10⁻⁴", -1.888e-4],
  [NUMBER, "1.888\u202f×\u202f10⁻⁴", 1.888e-4],
  [NUMBER, "\u22121.888 \u00d7 10\u22124", -1.888e-4],
  [NUMBER, "10⁻⁶", 1e-6],
  [NUMBER, "10^12", 1e12],
  [NUMBER, "10**-3", 1e-3],
  [NUMBER, "2·10^3", 2000],
  [NUMBER, "2 x 10^3", 2000],
  [NUMBER, "2*10**3", 2000],
  [NUMBER, "$1.888 \\times 10^{-4}$", 1.888e-4],
  [NUMBER, "–0.5", -0.5],
  [NUMBER, "２．５", 2.5],
  // fractions and shares
  [NUMBER, "2/7", 2 / 7],
  [NUMBER, "2 ⁄ 7", 2 / 7],
  [NUMBER, "-3/49", -3 / 49],
  [NUMBER, "50 %", 0.5],
  [NUMBER, "45.7\u202f%", 0.457],
  [NUMBER, "3‰", 0.003],
  // decimal commas that are nothing else
  [NUMBER, "0,5", 0.5],
  [NUMBER, "0,500", 0.5],
  [NUMBER, "1,5e3", 1500],
  [NUMBER, "1,88·10⁻⁴", 1.88e-4],
  [NUMBER, "1234,567", 1234.567],
  [NUMBER, "12,3456", 12.3456],
  // marks between thousands that are nothing else
  [NUMBER, "1 234", 1234],
  [NUMBER, "1\u00a0234\u00a0567,8", 1234567.8],
  [NUMBER, "1\u2009234.5", 1234.5],
  [NUMBER, "0.123\u202f456\u202f7", 0.1234567],
  [NUMBER, "1’234’567.5", 1234567.5],
  [NUMBER, "1_000_000", 1e6],
  [NUMBER, "1,234.5", 1234.5],
  [NUMBER, "1.234,5", 1234.5],
  [NUMBER, "1,000,000", 1e6],
  [NUMBER, "1.000.000", 1e6],
  [NUMBER, "12,34,567", 1234567],
  // units
  [STIFFNESS, "1.000 × 10¹² N/m", 1e12],
  [STIFFNESS, "4.03e8 N/m", 4.03e8],
  [STIFFNESS, "4.03e8", 4.03e8],
  [STIFFNESS, "5 N m⁻¹", 5],
  [STIFFNESS, "5 kN/mm", 5e6],
  [STIFFNESS, "5 N·m^-1", 5],
  [STIFFNESS, "5 kg/s²", 5],
  [RADIUS, "20 mm", 0.02],
  [RADIUS, "20mm", 0.02],
  [RADIUS, "4.03 µm", 4.03e-6],
  [RADIUS, "4.03 μm", 4.03e-6],
  [RADIUS, "4.03 um", 4.03e-6],
  [RADIUS, "2\u202fcm", 0.02],
  [RADIUS, "1 in", 0.0254],
  [RADIUS, "1/2 in", 0.0127],
  [MODULUS, "380 GPa", 3.8e11],
  [MODULUS, "210 N/mm²", 2.1e8],
  [MODULUS, "2,1e5 N/mm2", 2.1e11],
  [VELOCITY, "36 km/h", 10],
  [VELOCITY, "5 cm s^-1", 0.05],
  [VELOCITY, "1e2 mm/s", 0.1],
  [TIME, "12\u202fµs", 1.2e-5],
  [TIME, "5e-6s", 5e-6],
  [TIME, "1 min", 60],
  [DENSITY, "7.85 g/cm³", 7850],
  [DENSITY, "7,85 t/m^3", 7850],
  [ANGLE, "30°", 30],
  [ANGLE, "30 deg", 30],
  [ANGLE, "3.141592653589793 rad", 180],
];

/** Field, text, the two that it may mean. */
const ASKED = [
  [NUMBER, "1,000", { 1000: 1000, "1.000": 1 }],
  [NUMBER, "-1,358", { "-1358": -1358, "-1.358": -1.358 }],
  [NUMBER, "63,000e3", { "63000\u202f×\u202f10³": 63e6, "63.000\u202f×\u202f10³": 63e3 }],
  [RADIUS, "1,358 mm", { "1358\u202fmm": 1.358, "1.358\u202fmm": 0.001358 }],
  [
    STIFFNESS,
    "1.000 × 1012 N/m",
    { "1.000\u202f×\u202f10¹²\u202fN/m": 1e12, "1.000\u202f×\u202f1012\u202fN/m": 1012 },
  ],
];

/** What German has the other way round. */
const GERMAN = [
  [NUMBER, "1,000", 1],
  [NUMBER, "1,358", 1.358],
  [NUMBER, "0.5", 0.5],
  [NUMBER, "1.5", 1.5],
  [NUMBER, "1.000", { 1000: 1000, "1,000": 1 }],
  [MODULUS, "210.000 N/mm²", { "210000\u202fN/mm²": 2.1e11, "210,000\u202fN/mm²": 2.1e8 }],
  [NUMBER, "1.234,5", 1234.5],
  [NUMBER, "1.000.000", 1e6],
];

/** Field, text, words; none where it is no number at all. */
const REFUSED = [
  ...["", "abc", "NaN", "Infinity", "∞", "–", "1 2", "1_0", "--1", "1-2"],
  ...["<b>1</b>", "<", "±", "1,2,3", "1.2.3", "1,00,00", "2^3", "1/0", "1,000/7"],
].map((text) => [NUMBER, text, ""]);
const BOUND = "a bound, not a value";
const MARGIN = "how far a value may be off, not the value";
const UNCERTAIN = "a value with its uncertainty";
const WITH_REASON = [
  [RADIUS, "380 GPa", "GPa is a pressure; the radius takes m, mm, cm, µm"],
  [NUMBER, "20 mm", "mm is a length; κ takes a number without a unit"],
  [MODULUS, "5 N/m", "N/m is a stiffness; the Young’s modulus takes Pa, kPa, MPa, GPa"],
  [STIFFNESS, "5 N/m^2", "N/m² is a pressure; the tangential stiffness takes N/m, N/mm, kN/m"],
  [VELOCITY, "5 m/s²", "m/s² is an acceleration; the normal velocity takes m/s, cm/s, mm/s, km/h"],
  [TIME, "5 m^4", "m⁴ is another quantity; the dissipative constant takes s, ms, µs, ns"],
  [RADIUS, "50 %", "% is a share; the radius takes m, mm, cm, µm"],
  ...[
    [percentage(0.9999), BOUND],
    [percentage(1e-5), BOUND],
    ["≤ 10⁻⁸", BOUND],
    ["<= 0.1", BOUND],
    ["<0.1", BOUND],
    [errorBound(1e-14), MARGIN],
    [errorBound(8.3e-15), MARGIN],
    [errorBound(0.02), MARGIN],
    ["+/- 0.1", MARGIN],
    ["63 ± 2", UNCERTAIN],
    ["63+/-2", UNCERTAIN],
    ["63(2)", UNCERTAIN],
  ].map(([text, kind]) => [NUMBER, text, `“${text}” is ${kind}; κ takes one number`]),
  [RADIUS, "< 20 mm", `“< 20 mm” is ${BOUND}; the radius takes one number`],
  ...["1e999", "-1e999"].map((text) => [
    NUMBER,
    text,
    `“${text}” is beyond 1.8\u202f×\u202f10³⁰⁸, the largest number there is here`,
  ]),
  [RADIUS, "5 gpa", "“gpa” is no unit that is known here; the radius takes m, mm, cm, µm"],
  [
    RADIUS,
    "5 constructor",
    "“constructor” is no unit that is known here; the radius takes m, mm, cm, µm",
  ],
];

const byText = (readings) => Object.fromEntries(readings.map(({ text, value }) => [text, value]));

test("a written number is its value, and no nearby one", () => {
  assert.ok(READ.length >= 60);
  for (const [field, text, value] of READ) {
    assert.deepEqual(readWritten(text, field), { value }, text);
  }
});

test("what may be two numbers is asked about, and never silently one of them", () => {
  for (const [field, text, readings] of ASKED) {
    assert.deepEqual(byText(readWritten(text, field).readings ?? []), readings, text);
  }
});

test("in German the comma is the decimal mark, and a point between thousands is asked about", () => {
  for (const [field, text, meant] of GERMAN) {
    const reading = readWritten(text, { ...field, decimal: "," });
    assert.deepEqual(reading.value ?? byText(reading.readings ?? []), meant, text);
  }
});

test("what is no number is refused, and a unit of another dimension in words", () => {
  for (const [field, text, refusal] of [...REFUSED, ...WITH_REASON]) {
    assert.deepEqual(readWritten(text, field), { refusal }, text);
  }
});

test("what counts while it is typed is what is read of it when it is typed", () => {
  const all = [...READ, ...ASKED, ...GERMAN, ...REFUSED, ...WITH_REASON];
  for (const decimal of [".", ","]) {
    const plain = all.filter(([, text]) => parseTyped(text, decimal) !== null);
    assert.ok(plain.length > 8);
    for (const [, text] of plain) {
      const value = parseTyped(text, decimal);
      assert.deepEqual(readWritten(text, { ...NUMBER, decimal }), { value }, text);
    }
  }
});

/** Each formatter of the page with what its text says of a value, to the digits shown. */
const PRINTED = [
  [(value) => significant(value), 4],
  [(value) => significant(value, 2), 2],
  [(value) => significant(value, 8), 8],
  [brief, 3],
  [typable, 17],
];

test("what the page prints in English is read as printed", () => {
  for (const value of spreadNumbers(5, 400, 1e-300, 1e300).flatMap((each) => [each, -each])) {
    for (const [print, digits] of PRINTED) {
      const text = print(value);
      const reading = readWritten(text, NUMBER);
      assert.equal(reading.value?.toPrecision(digits), value.toPrecision(digits), text);
    }
  }
  for (const value of spreadNumbers(6, 100, 0.001, 100)) {
    assert.deepEqual(readWritten(approximate(value), NUMBER), { value: Number(value.toFixed(2)) });
    assert.deepEqual(readWritten(approximate(-value), NUMBER), {
      value: value.toFixed(2) === "0.00" ? 0 : -Number(value.toFixed(2)),
    });
  }
  for (let power = -300; power <= 300; power += 7) {
    assert.deepEqual(readWritten(powerOfTen(power), NUMBER), { value: Number(`1e${power}`) });
  }
  for (const share of spreadNumbers(7, 100, 1e-3, 0.999)) {
    const { value } = readWritten(percentage(share), NUMBER);
    assert.equal(value.toFixed(3), share.toFixed(3), percentage(share));
  }
  for (const milliseconds of spreadNumbers(8, 100, 1e-4, 1e5)) {
    const { value } = readWritten(duration(milliseconds), TIME);
    assert.equal(value.toPrecision(2), (milliseconds / 1000).toPrecision(2));
  }
  assert.deepEqual(readWritten(alphaInWords(2 / 7), NUMBER), { value: 2 / 7 });
});

test("what fields and the lesson print in any language is read as printed there", () => {
  for (const id of Object.keys(LOCALES)) {
    learn(wordsOf(id));
    const decimal = decimalMark();
    const digits = new Intl.NumberFormat(id, { maximumSignificantDigits: 4, useGrouping: false });
    for (const value of spreadNumbers(9, 300, 1e-3, 1e6)) {
      const inField = typable(value);
      assert.deepEqual(readWritten(inField, { ...NUMBER, decimal }), { value }, inField);
      const inLesson = readWritten(digits.format(value), { ...NUMBER, decimal });
      assert.equal(inLesson.value?.toPrecision(4), value.toPrecision(4), digits.format(value));
      const inWords = significant(value);
      const read = readWritten(inWords, NUMBER).value;
      assert.equal(read?.toPrecision(4), value.toPrecision(4), inWords);
    }
  }
  learn(wordsOf("en"));
});

test("every field takes its unit, and says which it takes instead of another", () => {
  for (const { key, unit } of [...PARAMETERS, ...IMPACT_PARAMETERS]) {
    assert.deepEqual(readWritten(`2 ${unit ?? ""}`, { subject: key, unit }), { value: 2 });
    const { refusal } = readWritten("2 Hz", { subject: key, unit });
    const [, taken] = refusal.split(" takes ");
    for (const each of unit ? taken.split(", ") : []) {
      assert.ok("value" in readWritten(`2 ${each}`, { subject: key, unit }), `${key}: ${each}`);
    }
  }
});
