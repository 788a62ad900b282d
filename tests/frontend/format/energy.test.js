import assert from "node:assert/strict";
import { test } from "node:test";

import { lostShare } from "../../../frontend/format/energy.js";

test("lostShare is that of the answer, also where the energies are beyond the doubles", () => {
  const energy = { initial: null, final: null, dissipated: null, dissipated_share: 0.88 };
  assert.equal(lostShare({ limit: false, energy }), 0.88);
});

test("lostShare of a collision without tangential velocity is nothing", () => {
  const energy = { initial: 0, final: 0, dissipated: 0, dissipated_share: 0.88 };
  assert.equal(lostShare({ limit: true, energy }), 0);
});
