import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

const read = (path) => readFileSync(new URL(`../../${path}`, import.meta.url));

test("i18next on the page is the package that is pinned, byte for byte, with its licence", () => {
  const pinned = JSON.parse(read("package.json")).devDependencies.i18next;
  assert.equal(JSON.parse(read("node_modules/i18next/package.json")).version, pinned);
  assert.ok(read("frontend/vendor/README.md").includes(`${pinned}, MIT`));
  for (const [ours, theirs] of [
    ["i18next.js", "dist/esm/i18next.js"],
    ["i18next.LICENSE", "LICENSE"],
  ]) {
    const [copy, original] = [`frontend/vendor/${ours}`, `node_modules/i18next/${theirs}`].map(
      read,
    );
    assert.ok(copy.equals(original), ours);
  }
});
