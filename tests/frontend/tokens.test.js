import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { THEME_PROPERTIES } from "../../frontend/figures/theme.js";
import { contrast } from "./contrast.js";

const sheet = readFileSync(new URL("../../frontend/styles/tokens.css", import.meta.url), "utf8");
const written = [...sheet.matchAll(/(--[\w-]+):\s*([^;]+);/g)].map((m) => [m[1], m[2].trim()]);
const pairs = written.map(([key, value]) => [key, /^light-dark\((.+), (.+)\)$/.exec(value)]);
const two = Object.fromEntries(pairs.filter(([, pair]) => pair));
const colorsOf = (which) =>
  Object.fromEntries(written.map(([key, value]) => [key, two[key]?.[which] ?? value]));

const schemes = { light: colorsOf(1), dark: colorsOf(2) };

for (const [name, token] of Object.entries(schemes)) {
  test(`text has the contrast of WCAG AA on its ground, ${name}`, () => {
    for (const [ink, ground] of [
      ["--ink", "--paper"],
      ["--ink-soft", "--paper"],
      ["--ink-soft", "--surface"],
      ["--ink-soft", "--well"],
      ["--warning", "--warning-paper"],
      ["--warning", "--paper"],
      ["--done", "--surface"],
      ["--done", "--paper"],
      ["--warning", "--surface"],
      ["--velocity", "--paper"],
      ["--spin", "--paper"],
      ["--pin-a", "--paper"],
      ["--pin-b", "--paper"],
      ["--pin-c", "--paper"],
      ["--on-regime", "--sliding"],
      ["--on-regime", "--sliding-back"],
      ["--on-regime", "--sticking"],
    ]) {
      assert.ok(contrast(token[ink], token[ground]) >= 4.5, `${ink} on ${ground}`);
    }
  });

  test(`lines and edges have the contrast of WCAG AA for graphics, ${name}`, () => {
    for (const line of [
      "--tangential-force",
      "--normal-force",
      "--velocity",
      "--spin",
      ...Object.keys(token).filter((key) => key.startsWith("--method-")),
      "--rule-strong",
      "--focus",
    ]) {
      assert.ok(contrast(token[line], token["--paper"]) >= 3, line);
    }
  });
}

test("the dark scheme has a colour of its own for everything that a figure draws", () => {
  const shared = Object.values(THEME_PROPERTIES).filter((property) => !(property in two));
  assert.deepEqual(shared, ["--sans"]);
});
