import assert from "node:assert/strict";
import { test } from "node:test";

import { createClient, NeedsServer } from "../../../frontend/api/client.js";
import { createFileClient } from "../../../frontend/api/file-client.js";

const COLLISION = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };
const CONTENTS = {
  language: "de",
  languages: [{ id: "de", name: "Deutsch" }],
  server: "",
  texts: { de: { first: { page: {} }, later: { lesson: { title: "Lektion" } } } },
  presets: [{ id: "figure-3" }],
  kernel: "AGFzbQEAAAA=",
};
const CALLS = ["collision", "trace", "bounce", "map", "cut"];

/** A client whose kernel answers as is given. */
function clientOf(answer) {
  return createFileClient(
    CONTENTS,
    Object.fromEntries(CALLS.map((call) => [call, async (asked) => answer(call, asked)])),
  );
}

test("a client of a file has the calls of one of a server", () => {
  const names = (client) => Object.keys(client).sort();
  assert.deepEqual(names(clientOf(() => null)), names(createClient({ fetch: () => {} })));
});

test("words and presets are those of the file", async () => {
  const client = clientOf(() => null);
  assert.deepEqual(await client.words("de"), { lesson: { title: "Lektion" } });
  assert.deepEqual(await client.presets(), [{ id: "figure-3" }]);
});

test("the kernel is compiled from the file", async () => {
  assert.ok((await clientOf(() => null).kernel()) instanceof WebAssembly.Module);
});

test("what the kernel computes is answered, and what it leaves to a server needs one", async () => {
  const client = clientOf((call, asked) => ({ call, asked }));
  for (const call of CALLS) {
    assert.deepEqual(await client[call](COLLISION), { call, asked: COLLISION });
    await assert.rejects(clientOf(() => null)[call](COLLISION), NeedsServer);
  }
});

test("all else needs a server", async () => {
  const client = clientOf(() => null);
  const here = ["isAnswering", "words", "presets", "font", "kernel"];
  for (const name of Object.keys(client).filter((each) => !here.includes(each))) {
    await assert.rejects(client[name](COLLISION), NeedsServer, name);
  }
});

test("a font is read from its own address", async () => {
  const font = await clientOf(() => null).font("data:font/woff2;base64,d09GMg==");
  assert.equal(font.type, "font/woff2");
  assert.equal(await font.text(), "wOF2");
});
