import assert from "node:assert/strict";
import { test } from "node:test";

import { USUAL_ACCURACY } from "../../../frontend/state/accuracy.js";
import { createErrorMapLoader } from "../../../frontend/state/error-map-loader.js";

const STATE = {
  collision: { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358 },
  accuracy: { ...USUAL_ACCURACY, method: "coulomb" },
  scale: "linear",
  map_y: "gt_over_gn",
};

function makeLoader(context) {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  let now = 0;
  context.mock.method(performance, "now", () => now);
  const asked = [];
  let nothings = 0;
  const loader = createErrorMapLoader({
    load: async (wish) => asked.push(wish),
    onErrors: () => {},
    onNothing: () => (nothings += 1),
    onError: assert.fail,
  });
  return {
    asked,
    nothings: () => nothings,
    async follow(change, dragging = false) {
      now += 1000;
      loader.follow({ ...STATE, ...change }, dragging);
      await new Promise((resolve) => setImmediate(resolve));
      return asked.length;
    },
  };
}

test("createErrorMapLoader asks again only for another method, knob, μ/α or axes", async (context) => {
  const { follow } = makeLoader(context);
  assert.equal(await follow({}), 1);
  assert.equal(await follow({ collision: { ...STATE.collision, kappa: 20 } }), 1);
  assert.equal(await follow({ scale: "log" }), 2);
  assert.equal(await follow({ scale: "log", accuracy: USUAL_ACCURACY }), 3);
  assert.equal(await follow({ scale: "log", accuracy: { ...USUAL_ACCURACY, tolerance: 1 } }), 3);
  const steps = { ...USUAL_ACCURACY, method: "timestep", steps: 51 };
  assert.equal(await follow({ scale: "log", accuracy: steps }), 4);
});

test("createErrorMapLoader asks for fewer cells where each costs more", async (context) => {
  const { asked, follow } = makeLoader(context);
  await follow({});
  await follow({ accuracy: { ...USUAL_ACCURACY, method: "timestep", steps: 1e5 } });
  await follow({ accuracy: { ...USUAL_ACCURACY, method: "ode" } });
  const cells = asked.map(({ counts }) => counts.kappa * counts.gtOverGn);
  assert.ok(cells[0] > cells[1] && cells[1] > cells[2]);
  assert.ok(cells[1] * 1e5 <= 3.1e8);
});

test("createErrorMapLoader asks nothing where the method does not answer everywhere", async (context) => {
  const { follow, nothings } = makeLoader(context);
  const collision = { ...STATE.collision, kappa: 5000 };
  const accuracy = { ...USUAL_ACCURACY, method: "table" };
  assert.equal(await follow({ collision, accuracy, scale: "log" }), 0);
  assert.equal(nothings(), 1);
});
