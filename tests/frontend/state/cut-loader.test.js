import assert from "node:assert/strict";
import { test } from "node:test";

import { createCutLoader, FULL_CUT, QUICK_CUT } from "../../../frontend/state/cut-loader.js";

const STATE = {
  collision: { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 },
  scale: "linear",
  map_y: "gt_over_gn",
};
const settled = () => new Promise((resolve) => setImmediate(resolve));

/** A loader whose cut is there at once, and what it was asked; no pause, for time stands still. */
function makeLoader(context) {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  let now = 0;
  context.mock.method(performance, "now", () => now);
  const asked = [];
  const loader = createCutLoader({
    load: async (wish) => asked.push(wish),
    onCut: () => {},
    onError: assert.fail,
  });
  return {
    asked,
    loader,
    async follow(collision, dragging, options = {}) {
      now += 1000;
      const state = { ...STATE, ...options, collision: { ...STATE.collision, ...collision } };
      loader.follow(state, dragging);
      await settled();
      return asked.length;
    },
  };
}

test("createCutLoader asks again for another κ or μ/α, and not for another g_t/g_n", async (context) => {
  const { follow } = makeLoader(context);
  assert.equal(await follow({}, false), 1);
  assert.equal(await follow({ gt_over_gn: 3 }, true), 1);
  assert.equal(await follow({ gt_over_gn: 3 }, false), 1);
  assert.equal(await follow({ kappa: 20 }, false), 2);
  assert.equal(await follow({ mu_over_alpha: 2 }, false), 3);
  assert.equal(await follow({}, false, { scale: "log" }), 4);
});

test("createCutLoader takes fewer points while κ is dragged and all when it rests", async (context) => {
  const { asked, follow } = makeLoader(context);
  await follow({}, false);
  await follow({ kappa: 20 }, true);
  await follow({ kappa: 20 }, false);
  assert.deepEqual(
    asked.map(({ kappa, count }) => [kappa, count]),
    [
      [63, FULL_CUT],
      [20, QUICK_CUT],
      [20, FULL_CUT],
    ],
  );
});

test("createCutLoader asks for one cut over ψ, whatever the μ/α", async (context) => {
  const { asked, follow } = makeLoader(context);
  await follow({}, false, { map_y: "psi" });
  assert.equal(await follow({ mu_over_alpha: 2 }, false, { map_y: "psi" }), 1);
  assert.equal(asked[0].muOverAlpha, 1);
});

test("createCutLoader asks anew once it has been told to forget", async (context) => {
  const { loader, follow } = makeLoader(context);
  await follow({}, false);
  loader.forget();
  assert.equal(await follow({}, false), 2);
});
