import assert from "node:assert/strict";
import { readdirSync } from "node:fs";
import { test } from "node:test";

import { chosenLanguage, decimalMark, LANGUAGES } from "../../../frontend/state/language.js";

const LOCALES = new URL("../../../frontend/locales/", import.meta.url);

test("the language asked for is spoken, else the first of the browser's that is known", () => {
  assert.equal(chosenLanguage("de", ["en-GB"]), "de");
  assert.equal(chosenLanguage("system", ["de-CH", "en"]), "de");
  assert.equal(chosenLanguage("system", ["fr-FR", "DE", "en"]), "de");
  assert.equal(chosenLanguage("system", ["fr", "ja"]), "en");
  assert.equal(chosenLanguage("system", []), "en");
});

test("the decimal mark of fields is that of the language that the scene speaks", () => {
  assert.equal(decimalMark({ scene: "lesson", lang: "de" }, []), ",");
  assert.equal(decimalMark({ scene: "lesson", lang: "system" }, ["de-CH"]), ",");
  assert.equal(decimalMark({ scene: "lesson", lang: "en" }, ["de"]), ".");
  assert.equal(decimalMark({ scene: "explorer", lang: "de" }, ["de"]), ".");
});

test("every language has a file, and every file a language", () => {
  assert.deepEqual(readdirSync(LOCALES).sort(), LANGUAGES.map(({ id }) => `${id}.json`).sort());
});
