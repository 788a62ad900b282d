import assert from "node:assert/strict";
import { test } from "node:test";

import { createPredictions } from "../../../frontend/scenes/lesson/predictions.js";
import { createRecord } from "../../../frontend/scenes/lesson/record.js";
import { stepNumber, STEPS } from "../../../frontend/state/lesson.js";
import { readAddress } from "../../../frontend/state/address/reading.js";

const predicted = STEPS.filter(({ prediction }) => prediction);
const [stop, reversal] = predicted;

function at(step, changes = {}) {
  const { state } = readAddress(`?scene=lesson&step=${stepNumber(step)}`);
  return { ...state, ...changes };
}

function seen(step, exact, collision = {}) {
  const state = at(step);
  return { state: { ...state, collision: { ...state.collision, ...collision } }, exact };
}

test("three steps or more ask for a prediction, of both kinds", () => {
  assert.ok(predicted.length >= 3);
  const kinds = new Set(predicted.map(({ prediction }) => prediction.kind));
  assert.deepEqual([...kinds].sort(), ["gauge", "sketch"]);
});

test("a prediction is waited for where its step begins, once", () => {
  const predictions = createPredictions(createRecord());
  assert.ok(predictions.isPending(at(stop)));
  assert.ok(!predictions.isPending(at(STEPS[0])));
  assert.ok(!predictions.isPending(at(stop, { scene: "explorer" })));
  assert.ok(!predictions.isPending(at(stop, { embed: "result" })));
  const { collision } = at(stop);
  assert.ok(!predictions.isPending(at(stop, { collision: { ...collision, kappa: 5 } })));
  predictions.commit(stop, 0.5);
  assert.ok(!predictions.isPending(at(stop)));
  assert.ok(predictions.isPending(at(reversal)));
});

test("what came is what the server says of where the step begins, whenever it says so", () => {
  const predictions = createPredictions(createRecord());
  predictions.note(stop, seen(stop, { epsilon_t: 0.3 }));
  predictions.commit(stop, -0.5);
  assert.deepEqual(predictions.of(stop), { guess: -0.5, came: 0.3 });
  predictions.note(stop, seen(stop, { epsilon_t: 0.1 }, { gt_over_gn: 3 }));
  assert.equal(predictions.of(stop).came, 0.3);
  predictions.commit(reversal, "rest");
  assert.equal(predictions.of(reversal).came, null);
  predictions.note(reversal, seen(reversal, { reversals: 1 }));
  assert.deepEqual(predictions.of(reversal), { guess: "rest", came: "once" });
});

test("to be shown anyway is no guess", () => {
  const predictions = createPredictions(createRecord());
  predictions.commit(stop, null);
  predictions.note(stop, seen(stop, { epsilon_t: 0.3 }));
  assert.deepEqual(predictions.all(), [{ step: stop, guess: null, came: 0.3 }]);
});

test("each sketch comes for some number of turns, and every number has a sketch", () => {
  const { sketches, came } = reversal.prediction;
  const names = [0, 1, 2, 3, 8, null].map((reversals) => came({ exact: { reversals } }));
  assert.deepEqual([...new Set(names)].sort(), Object.keys(sketches).sort());
});

test("answers outlive a page that is loaded anew, and what was kept of another shape is nothing", () => {
  const kept = new Map();
  globalThis.sessionStorage = {
    getItem: (name) => kept.get(name) ?? null,
    setItem: (name, text) => kept.set(name, text),
  };
  createRecord().note(stop, {
    isDone: true,
    chosen: ["a"],
    prediction: { guess: 0.5, came: null },
  });
  const expected = { isDone: true, chosen: ["a"], prediction: { guess: 0.5, came: null } };
  assert.deepEqual(createRecord().of(stop), expected);
  const nothing = { isDone: false, chosen: [], prediction: null };
  for (const broken of [
    "{",
    "null",
    "[]",
    "7",
    `{"${stop.id}": 3}`,
    `{"${stop.id}": {"chosen": 3}}`,
  ]) {
    kept.set("restitution.lesson", broken);
    assert.deepEqual(createRecord().of(stop), nothing, broken);
  }
  delete globalThis.sessionStorage;
});
