import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

import { STEPS, textsOf } from "../../frontend/state/lesson.js";
import { flat, LOCALES } from "./locales.js";

const FRONTEND = new URL("../../frontend/", import.meta.url);
const sources = readdirSync(FRONTEND, { recursive: true })
  .filter((file) => /\.(js|html)$/.test(file))
  .map((file) => readFileSync(new URL(file, FRONTEND), "utf8"))
  .join("\n");
const locales = Object.fromEntries(Object.entries(LOCALES).map(([id, texts]) => [id, flat(texts)]));
const { en: english, ...others } = locales;
const sections = Object.keys(LOCALES.en).filter((key) => key !== "name");

/** Without the ending that a number asks for. */
const withoutPlural = (key) => key.replace(/_(zero|one|two|few|many|other)$/, "");

const placeholders = (text) => [...new Set(text.match(/{{\w+}}/g) ?? [])].sort();

/** The keys that stand in the sources, and those of the steps of the lesson. */
function usedKeys() {
  const name = `(?:${sections.join("|")})(?:\\.\\w+)+`;
  const written = [...sources.matchAll(new RegExp(`"(${name})"`, "g"))].map(([, key]) => key);
  const ofSteps = STEPS.flatMap((step) => Object.values(flat(textsOf(step))));
  return new Set(["name", ...written, ...ofSteps.filter((key) => key.includes("."))]);
}

/** What stands before the last part of keys that are put together; those of the steps are known one by one. */
const families = [...sources.matchAll(/`((?:\w+\.)+)\$\{/g)]
  .map(([, family]) => family)
  .filter((family) => family !== "lesson.steps.");

test("every key that is used is there, and every key that is there is used", () => {
  const there = new Set(Object.keys(english).map(withoutPlural));
  const used = usedKeys();
  assert.deepEqual(
    [...used].filter((key) => !there.has(key)),
    [],
  );
  const isUsed = (key) => used.has(key) || families.some((family) => key.startsWith(family));
  assert.deepEqual(
    [...there].filter((key) => !isUsed(key)),
    [],
  );
});

for (const [id, texts] of Object.entries(others)) {
  test(`${id} has the keys of English, with the same placeholders, and none is empty`, () => {
    const keys = (of) => [...new Set(Object.keys(of).map(withoutPlural))].sort();
    assert.deepEqual(keys(texts), keys(english));
    for (const [key, text] of Object.entries(texts)) {
      assert.notEqual(text.trim(), "", key);
      const wanted = english[key] ?? english[`${withoutPlural(key)}_other`];
      assert.deepEqual(placeholders(text), placeholders(wanted), key);
    }
  });

  test(`${id} leaves no sentence as it is in English`, () => {
    // One or two words may be the same in both, as “linear” and “Impact” are.
    const words = (text) => text.replaceAll(/{{\w+}}/g, "").match(/\p{L}{2,}/gu) ?? [];
    const same = Object.keys(english).filter(
      (key) => texts[key] === english[key] && words(english[key]).length >= 3,
    );
    assert.deepEqual(same, []);
  });
}

test("what the lesson quotes of the page is there in the same words", () => {
  for (const [id, texts] of Object.entries(locales)) {
    const said = Object.entries(texts);
    const steps = said.filter(([key]) => /^lesson\.steps\..*(text|question|verdicts)/.test(key));
    const quoted = steps.flatMap(([, text]) =>
      [...text.matchAll(/[“„«]\u00a0?([^”“»]*?)\u00a0?[”“»]/g)].map(([, words]) => words),
    );
    const there = said.filter(([key]) => !key.startsWith("lesson.steps")).map(([, text]) => text);
    assert.ok(quoted.length > 8, id);
    assert.deepEqual(
      quoted.filter((words) => !there.some((text) => text === words || isCutAt(words, text))),
      [],
      id,
    );
  }
});

/** The cut is quoted without what it is at. */
const isCutAt = (words, text) => text.startsWith(`${words} `) && text.includes("{{held}}");

test("no line ends within a formula", () => {
  for (const [id, texts] of Object.entries(locales)) {
    for (const [key, text] of Object.entries(texts)) {
      assert.doesNotMatch(text, /[}\d)|] [=−+/]|[=−] [\d{(]/, `${id}: ${key}`);
    }
  }
});

test("French signs are held to what they stand by", () => {
  for (const [key, text] of Object.entries(locales.fr)) {
    assert.doesNotMatch(text, /[^\u202f][;:!?%](?!\w)|«[^\u00a0]|[^\u00a0]»|'/, key);
  }
});

test("no text holds markup, an address, or a symbol that has a placeholder", () => {
  for (const [id, texts] of Object.entries(locales)) {
    for (const [key, text] of Object.entries(texts)) {
      assert.doesNotMatch(text, /<|https?:|ε_t|g_t|[κψη]|\$t\(/, `${id}: ${key}`);
    }
  }
});
