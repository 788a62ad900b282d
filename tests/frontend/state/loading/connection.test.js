import assert from "node:assert/strict";
import { test } from "node:test";

import { createConnection } from "../../../../frontend/state/loading/connection.js";

const settled = () => new Promise((resolve) => setImmediate(resolve));

test("createConnection asks until the server answers, and tells of each change once", async (context) => {
  context.mock.timers.enable({ apis: ["setTimeout"] });
  const healthy = [false, false, true];
  const told = [];
  const connection = createConnection({
    isAnswering: async () => {
      told.push("asked");
      return healthy.shift() ?? true;
    },
    onLost: () => told.push("lost"),
    onRecovered: () => told.push("recovered"),
    interval: 100,
  });
  connection.reportLost();
  connection.reportLost();
  assert.ok(connection.isLost());
  for (let i = 0; i < 10; i += 1) {
    context.mock.timers.tick(100);
    await settled();
  }
  assert.deepEqual(told, ["lost", "asked", "asked", "asked", "recovered"]);
  assert.ok(!connection.isLost());
});
