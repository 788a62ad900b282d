import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { test } from "node:test";

import { zipOf } from "../../../frontend/pictures/zip.js";

/** Reads a ZIP as Python's own zipfile does, sums included. */
const READ = `
import io, json, sys, zipfile
with zipfile.ZipFile(io.BytesIO(sys.stdin.buffer.read())) as file:
    assert file.testzip() is None
    found = [[i.filename, list(i.date_time), file.read(i).decode()] for i in file.infolist()]
print(json.dumps(found))
`;

async function readBack(zip) {
  const input = Buffer.from(await zip.arrayBuffer());
  return JSON.parse(execFileSync("python", ["-c", READ], { input }));
}

test("zipOf makes what Python's zipfile reads: names, times, texts, also none", async () => {
  const time = new Date(2026, 10, 29, 13, 8, 38);
  const long = "κ = 63\n".repeat(10_000);
  const files = [
    { name: "empty.txt", content: "" },
    { name: "κ/ε_t.csv", content: new Blob([long]) },
    { name: "one.txt", content: "1" },
  ];
  const when = [2026, 11, 29, 13, 8, 38];
  assert.deepEqual(await readBack(await zipOf(files, time)), [
    ["empty.txt", when, ""],
    ["κ/ε_t.csv", when, long],
    ["one.txt", when, "1"],
  ]);
});

test("zipOf makes an empty ZIP of nothing", async () => {
  assert.deepEqual(await readBack(await zipOf([], new Date(2026, 10, 29))), []);
});
