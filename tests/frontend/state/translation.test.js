import assert from "node:assert/strict";
import { test } from "node:test";

import { createTranslation } from "../../../frontend/state/translation.js";

function translationOf(texts) {
  const translation = createTranslation();
  for (const [language, own] of Object.entries(texts)) {
    translation.add(language, own);
  }
  return translation;
}

test("a text that is missing or empty is said in English", () => {
  const say = translationOf({
    en: { a: "one", b: "two", c: "three" },
    de: { a: "eins", b: "" },
  }).in("de");
  assert.deepEqual(
    ["a", "b", "c"].map((key) => say(key)),
    ["eins", "two", "three"],
  );
});

test("symbols and values take their places, and markup stays what it is: letters", () => {
  const say = translationOf({ en: { a: "{{epsilon_t}} = {{value}} at {{kappa}} <b>" } }).in("en");
  assert.equal(say("a", { value: "<i>1</i> & 2" }), "ε_t = <i>1</i> & 2 at κ <b>");
});

test("numbers choose their form by the language", () => {
  const texts = { minutes_one: "{{count}} Minute", minutes_other: "{{count}} Minuten" };
  const say = translationOf({ en: {}, de: texts }).in("de");
  assert.deepEqual(
    [1, 5].map((count) => say("minutes", { count })),
    ["1 Minute", "5 Minuten"],
  );
});

test("a form that a language lacks is its other one, and English counts in English", () => {
  const say = translationOf({
    en: { b_one: "one", b_other: "{{count}} others" },
    cs: { a_other: "{{count}} jiných" },
  }).in("cs");
  assert.equal(say("a", { count: 3 }), "3 jiných");
  assert.deepEqual([say("b", { count: 1 }), say("b", { count: 3 })], ["one", "3 others"]);
});

test("braces around what nobody gives stay where they are", () => {
  const say = translationOf({ en: { a: "{{constructor}} {{value}}" } }).in("en");
  assert.equal(say("a"), "{{constructor}} {{value}}");
});

test("a file of another shape than expected harms nobody", () => {
  const say = translationOf({ en: { a: { b: "deep" } }, de: { a: "flat" } }).in("de");
  assert.equal(typeof say("a"), "string");
  assert.equal(typeof say("a.b"), "string");
  assert.equal(typeof say("nowhere.at.all"), "string");
});

test("the direction of writing is that of the language", () => {
  const { direction } = createTranslation();
  assert.deepEqual(["en", "de", "ar"].map(direction), ["ltr", "ltr", "rtl"]);
});
