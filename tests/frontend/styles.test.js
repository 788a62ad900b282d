import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { test } from "node:test";

const folder = new URL("../../frontend/", import.meta.url);
const sheets = readdirSync(folder, { recursive: true }).filter((name) => name.endsWith(".css"));

test("no style sheet asks with :has() for what is not somewhere in the page: that costs a restyle for each text that Plotly measures", () => {
  assert.ok(sheets.length > 15);
  for (const name of sheets) {
    const sheet = readFileSync(new URL(name, folder), "utf8");
    const asked = [...sheet.matchAll(/:has\((?!\+)[^{]*/g)].map(([found]) => found.trim());
    assert.deepEqual(asked, [], name);
  }
});
