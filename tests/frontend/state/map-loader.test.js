import assert from "node:assert/strict";
import { test } from "node:test";

import { createMapLoader, FULL_MAP, QUICK_MAP } from "../../../frontend/state/map-loader.js";

const STATE = {
  collision: { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 },
  map: "epsilon_t",
  scale: "linear",
  map_y: "gt_over_gn",
};
const settled = () => new Promise((resolve) => setImmediate(resolve));

/** A loader whose map is there at once, and what it was asked; no pause, for time stands still. */
function makeLoader(context) {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  let now = 0;
  context.mock.method(performance, "now", () => now);
  const asked = [];
  const loader = createMapLoader({
    load: async (wish) => asked.push(wish),
    onMap: () => {},
    onError: assert.fail,
  });
  return {
    asked,
    loader,
    async follow(collision, dragging, state = STATE) {
      now += 1000;
      loader.follow({ ...state, collision: { ...state.collision, ...collision } }, dragging);
      await settled();
      return asked.length;
    },
  };
}

test("createMapLoader asks again only for another μ/α or other axes", async (context) => {
  const { follow } = makeLoader(context);
  assert.equal(await follow({}, false), 1);
  assert.equal(await follow({ kappa: 20, gt_over_gn: 3 }, true), 1);
  assert.equal(await follow({ kappa: 20, gt_over_gn: 3 }, false), 1);
  assert.equal(await follow({ kappa: 120 }, false), 2);
  assert.equal(await follow({ kappa: 120 }, false, { ...STATE, scale: "log" }), 3);
});

test("createMapLoader draws roughly while μ/α is dragged and fully when it rests", async (context) => {
  const { asked, follow } = makeLoader(context);
  await follow({}, false);
  await follow({ mu_over_alpha: 2 }, true);
  await follow({ mu_over_alpha: 2 }, false);
  assert.deepEqual(
    asked.map(({ muOverAlpha, counts }) => [muOverAlpha, counts]),
    [
      [1.4, FULL_MAP],
      [2, QUICK_MAP],
      [2, FULL_MAP],
    ],
  );
});

test("createMapLoader keeps its axes while a drag goes beyond them", async (context) => {
  const { asked, follow } = makeLoader(context);
  await follow({}, false);
  await follow({ kappa: 500, mu_over_alpha: 2 }, true);
  assert.equal(asked[1].view, asked[0].view);
  await follow({ kappa: 500, mu_over_alpha: 2 }, false);
  assert.equal(asked[2].view.kappa.max, 500);
});

test("createMapLoader asks anew once it has been told to forget", async (context) => {
  const { loader, follow } = makeLoader(context);
  await follow({}, false);
  loader.forget();
  assert.equal(await follow({}, false), 2);
});

test("createMapLoader asks for one map over ψ, whatever the μ/α", async (context) => {
  const { asked, follow } = makeLoader(context);
  const state = { ...STATE, map_y: "psi" };
  await follow({}, false, state);
  await follow({ mu_over_alpha: 2 }, true, state);
  await follow({ mu_over_alpha: 0.7 }, false, state);
  assert.deepEqual(
    asked.map(({ muOverAlpha, view }) => [muOverAlpha, view.vertical]),
    [[1, "psi"]],
  );
});
