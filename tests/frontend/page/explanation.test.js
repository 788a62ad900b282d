import assert from "node:assert/strict";
import { test } from "node:test";

import { Refused, Unreachable } from "../../../frontend/api/client.js";
import { learn } from "../../../frontend/format/words.js";
import { createExplanation } from "../../../frontend/page/explanation.js";
import { wordsOf } from "../locales.js";

/** What is told of an error: where, and in which language. */
function toldOf(error) {
  const told = [];
  const explainBy = createExplanation((reason) => told.push(["lost", reason]));
  explainBy((reason, language) => told.push([language, reason]))(error);
  return told;
}

test("a refusal is marked as English, and what the page says itself is in its own language", (t) => {
  learn(wordsOf("de"));
  t.after(() => learn(wordsOf("en")));
  assert.deepEqual(toldOf(new Refused(413, "too many switches")), [["en", "too many switches"]]);
  assert.deepEqual(toldOf(new Refused(500)), [["", "der Server antwortete mit 500"]]);
  assert.deepEqual(toldOf(new Unreachable("busy")), [["lost", "Der Server ist ausgelastet"]]);
});

test("an error of the page itself is not swallowed", () => {
  assert.throws(() => toldOf(new TypeError("ours")), /ours/);
});
