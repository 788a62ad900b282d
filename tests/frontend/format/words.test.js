import assert from "node:assert/strict";
import { test } from "node:test";

import { approximate, duration, significant, typable } from "../../../frontend/format/number.js";
import { decimalMark, learn, say } from "../../../frontend/format/words.js";
import { wordsOf } from "../locales.js";

test("symbols and values take their places, and markup stays what it is: letters", () => {
  learn(wordsOf("en", { a: "{{epsilon_t}} = {{value}} at {{kappa}} <b>" }));
  assert.equal(say("a", { value: "<i>1</i> & 2" }), "ε_t = <i>1</i> & 2 at κ <b>");
});

test("numbers choose their form by the language, and a form that it lacks is its other one", () => {
  learn(wordsOf("de", { minutes_one: "{{count}} Minute", minutes_other: "{{count}} Minuten" }));
  assert.deepEqual(
    [1, 5].map((count) => say("minutes", { count })),
    ["1 Minute", "5 Minuten"],
  );
  learn(wordsOf("cs", { a_other: "{{count}} jiných" }));
  assert.equal(say("a", { count: 3 }), "3 jiných");
});

test("braces around what nobody gives stay where they are", () => {
  learn(wordsOf("en", { a: "{{constructor}} {{value}}" }));
  assert.equal(say("a"), "{{constructor}} {{value}}");
});

test("what nobody has written is said by its key, whatever shape the texts have", () => {
  learn(wordsOf("en", { a: "flat", b: { c: "deep" } }));
  assert.deepEqual(
    ["a.b", "b", "nowhere.at.all"].map((key) => say(key)),
    ["a.b", "b", "nowhere.at.all"],
  );
});

test("numbers are written with the decimal mark of the page’s language", () => {
  learn(wordsOf("de"));
  assert.equal(decimalMark(), ",");
  assert.deepEqual(
    [
      significant(-0.08612),
      significant(1.5e-9),
      approximate(0.456),
      typable(1.358),
      duration(0.25),
    ],
    ["−0,08612", "1,500\u202f×\u202f10⁻⁹", "0,46", "1,358", "0,25\u202fms"],
  );
  learn(wordsOf("en"));
  assert.equal(significant(-0.08612), "−0.08612");
});
