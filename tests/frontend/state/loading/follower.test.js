import assert from "node:assert/strict";
import { test } from "node:test";

import { createFollower, isSame } from "../../../../frontend/state/loading/follower.js";

/** A follower whose answers are there at once, and what it was told. */
function makeFollower(isEnough = isSame) {
  const told = [];
  const follower = createFollower({
    load: async (wish) => wish,
    isEnough,
    onAnswer: (answer) => told.push(answer),
    onNothing: () => told.push("nothing"),
    onError: assert.fail,
  });
  return {
    ...follower,
    told,
    async follow(wish) {
      follower.follow(wish);
      await new Promise((resolve) => setImmediate(resolve));
    },
  };
}

test("createFollower asks for each wish once", async () => {
  const { follow, told } = makeFollower();
  await follow({ kappa: 1 });
  await follow({ kappa: 1 });
  await follow({ kappa: 2 });
  assert.deepEqual(told, [{ kappa: 1 }, { kappa: 2 }]);
});

test("createFollower does not ask where something as good was asked for", async () => {
  const { follow, told, asked } = makeFollower((had, wish) => had >= wish);
  await follow(200);
  await follow(100);
  assert.deepEqual([told, asked()], [[200], 200]);
  await follow(800);
  assert.deepEqual([told, asked()], [[200, 800], 800]);
});

test("createFollower says where there is nothing, and asks for the same after that", async () => {
  const { follow, told, asked } = makeFollower();
  await follow(1);
  await follow(null);
  assert.equal(asked(), null);
  await follow(1);
  assert.deepEqual(told, [1, "nothing", 1]);
});

test("createFollower asks anew once it has been told to forget", async () => {
  const { follow, forget, told } = makeFollower();
  await follow(1);
  forget();
  await follow(1);
  assert.deepEqual(told, [1, 1]);
});
