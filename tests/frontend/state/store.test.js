import assert from "node:assert/strict";
import { test } from "node:test";

import { createStore } from "../../../frontend/state/store.js";

test("createStore tells a listener the state, the one before and how it came about", () => {
  const store = createStore({ a: 1, b: 2 });
  const heard = [];
  store.subscribe((...all) => heard.push(all));
  store.set({ b: 3 }, { dragging: true, inputTimeStamp: 17 });
  assert.deepEqual(heard, [
    [
      { a: 1, b: 3 },
      { a: 1, b: 2 },
      { dragging: true, inputTimeStamp: 17 },
    ],
  ]);
});

test("createStore forgets a listener that has unsubscribed", () => {
  const store = createStore({ a: 1 });
  const end = store.subscribe(() => assert.fail("it had unsubscribed"));
  end();
  store.set({ a: 2 });
  assert.deepEqual(store.get(), { a: 2 });
});
