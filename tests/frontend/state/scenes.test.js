import assert from "node:assert/strict";
import { test } from "node:test";

import { isPlain, picturesOf, presentedIn } from "../../../frontend/state/scenes.js";
import { readAddress } from "../../../frontend/state/address/reading.js";

const at = (search) => readAddress(search).state;

test("what is not to be seen is not asked for", () => {
  const asked = (search) =>
    Object.entries(picturesOf(at(search)))
      .filter(([, isShown]) => isShown)
      .map(([name]) => name)
      .join(" ");
  assert.equal(asked("?face=plain"), "map contact");
  assert.equal(asked("?face=expert"), "map cut contact");
  assert.equal(asked("?scene=lesson&step=1"), "map contact");
  assert.equal(asked("?scene=lesson&step=5"), "map cut contact");
  assert.equal(asked("?embed=force"), "");
  assert.equal(asked("?embed=cut"), "map cut");
  assert.equal(asked("?scene=paper"), "");
  assert.equal(asked("?presenting=on&face=expert"), "map contact");
  assert.equal(asked("?presenting=on&right=cut"), "map cut contact");
});

test("what is presented is what was picked, each once, or what the step looks at", () => {
  assert.deepEqual(presentedIn(at("?presenting=on")), ["contact", "map"]);
  assert.deepEqual(presentedIn(at("?left=force&right=force")), ["force"]);
  assert.deepEqual(presentedIn(at("?scene=lesson&step=6&left=map")), ["velocity", "cut"]);
});

test("what is presented is plain, whatever face was chosen", () => {
  assert.equal(isPlain(at("?face=expert")), false);
  assert.equal(isPlain(at("?face=expert&presenting=on")), true);
});
