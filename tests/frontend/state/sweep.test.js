import assert from "node:assert/strict";
import { test } from "node:test";

import { readSweep, sweepOf, writeSweep } from "../../../frontend/state/sweep.js";

test("a sweep stands in the address with no more than what is not usual of it", () => {
  const usual = { key: "kappa", from: 0.1, to: 1000, seconds: 8, once: false };
  assert.deepEqual(sweepOf("kappa"), usual);
  for (const [text, patch] of [
    ["kappa", {}],
    ["kappa,1,100", { from: 1, to: 100 }],
    ["kappa,100,1,12.5", { from: 100, to: 1, seconds: 12.5 }],
    ["kappa,0.1,1000,8,once", { once: true }],
  ]) {
    assert.deepEqual(readSweep(text), { ...usual, ...patch });
    assert.equal(writeSweep({ ...usual, ...patch }), text);
  }
  assert.equal(
    writeSweep(readSweep("youngs_modulus_pa,1e5,1e12,4")),
    "youngs_modulus_pa,100000,1000000000000,4",
  );
  assert.deepEqual(readSweep("spin_share"), { ...usual, key: "spin_share", from: 0, to: 1 });
});

test("what no slider can do is no sweep", () => {
  for (const text of [
    "",
    "time",
    "tolerance,1,2",
    "kappa,1,1",
    "kappa,0.01,100",
    "kappa,1,2000",
    "kappa,1,ten",
    "kappa,1,100,0",
    "kappa,1,100,601",
    "kappa,1,100,8,twice",
    "kappa,1,100,8,once,more",
  ]) {
    assert.equal(readSweep(text), null, text);
  }
});
