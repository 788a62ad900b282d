import assert from "node:assert/strict";
import { test } from "node:test";

import { createUndoStack, withLooks } from "../../../frontend/state/undo-stack.js";
import { readAddress } from "../../../frontend/state/address/reading.js";

const stateAt = (search) => readAddress(search).state;

/** A stack that was led through some states, each a while after the one before unless it is told when. */
function led(first, ...next) {
  const stack = createUndoStack(stateAt(first));
  let time = 0;
  const go = (search, change = {}) => {
    time += 5000;
    stack.follow(stateAt(search), { dragging: false, inputTimeStamp: time, ...change });
  };
  next.forEach((each) => go(...[each].flat()));
  return { ...stack, go };
}

const kappaOf = (step) => step && step.state.collision.kappa;

test("createUndoStack takes back step by step, brings back, and ends at both ends", () => {
  const stack = led("?kappa=1", "?kappa=2", "?kappa=3");
  assert.ok(stack.canUndo() && !stack.canRedo());
  assert.deepEqual([stack.undo(), stack.undo(), stack.undo()].map(kappaOf), [2, 1, null]);
  assert.ok(!stack.canUndo() && stack.canRedo());
  assert.deepEqual([stack.redo(), stack.redo(), stack.redo()].map(kappaOf), [2, 3, null]);
});

test("createUndoStack says what is another there", () => {
  const { changed } = led("?kappa=63", "?kappa=40").undo();
  assert.deepEqual(changed, [{ key: "kappa", from: "40", to: "63" }]);
});

test("createUndoStack cuts off what was taken back when something new comes", () => {
  const stack = led("?kappa=1", "?kappa=2", "?kappa=3");
  stack.undo();
  stack.go("?kappa=9");
  assert.ok(!stack.canRedo());
  assert.deepEqual([stack.undo(), stack.undo()].map(kappaOf), [2, 1]);
});

test("createUndoStack is not led on by the state that it gave itself", () => {
  const stack = led("?kappa=1", "?kappa=2");
  stack.undo();
  stack.go("?kappa=1");
  assert.equal(kappaOf(stack.redo()), 2);
});

test("createUndoStack takes fast changes of one thing for one step, and not those of several", () => {
  const fast = (time) => ({ inputTimeStamp: time });
  const one = led("?kappa=1", ["?kappa=2", fast(0)], ["?kappa=3", fast(900)]);
  assert.equal(kappaOf(one.undo()), 1);
  const slow = led("?kappa=1", ["?kappa=2", fast(0)], ["?kappa=3", fast(1100)]);
  assert.equal(kappaOf(slow.undo()), 2);
  const two = led("?kappa=1", ["?kappa=2", fast(0)], ["?kappa=2&map=switches", fast(100)]);
  assert.equal(two.undo().state.map, "epsilon_t");
  const pages = led(
    "?scene=lesson&step=1",
    ["?scene=lesson&step=2", fast(0)],
    ["?scene=lesson&step=3", fast(100)],
  );
  assert.equal(pages.undo().state.step, "2");
});

test("createUndoStack has no step for there and back again", () => {
  const fast = (time) => ({ inputTimeStamp: time });
  const stack = led("?kappa=1", ["?kappa=2", fast(0)], ["?kappa=1", fast(100)]);
  assert.ok(!stack.canUndo());
  stack.go("?kappa=5");
  assert.equal(kappaOf(stack.undo()), 1);
});

test("createUndoStack leaves colours, language and face alone", () => {
  const stack = led("?kappa=1", "?kappa=2", "?kappa=2&theme=dark&face=expert");
  const { state } = stack.undo();
  const { theme, face, collision } = withLooks(state, stateAt("?theme=dark&face=expert"));
  assert.deepEqual([theme, face, collision.kappa], ["dark", "expert", 1]);
});

test("createUndoStack goes along with back and forward, which are a change where they lead elsewhere", () => {
  const fromAddress = { fromAddress: true };
  const stack = led("?kappa=1", "?kappa=2", "?kappa=3", ["?kappa=2", fromAddress]);
  assert.ok(stack.canRedo());
  stack.go("?kappa=3", fromAddress);
  assert.ok(!stack.canRedo());
  stack.go("?kappa=1", fromAddress);
  assert.deepEqual([stack.undo(), stack.undo()].map(kappaOf), [3, 2]);
});

test("createUndoStack has the collision of an impact in the step of the impact", () => {
  const spheres = "?scene=spheres&kappa=";
  const stack = led(`${spheres}63`, [`${spheres}7`, { isWorkedOut: true }]);
  assert.ok(!stack.canUndo());
  const impact = "&normal_velocity_m_s=2";
  stack.go(`${spheres}7${impact}`);
  stack.go(`${spheres}8${impact}`, { isWorkedOut: true });
  assert.equal(kappaOf(stack.undo()), 7);
  // the answer about it comes once more
  stack.go(`${spheres}7`, { isWorkedOut: true });
  assert.equal(kappaOf(stack.redo()), 8);
});
