import assert from "node:assert/strict";
import { test } from "node:test";

import { decodeArrays } from "../../../frontend/api/arrays.js";
import { createClient, Refused, Unreachable } from "../../../frontend/api/client.js";
import { mapView } from "../../../frontend/state/map-view.js";

const COLLISION = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 };

const LOG = { scale: "log", map_y: "gt_over_gn" };

function encoded(dtype, numbers, shape) {
  return { dtype, shape, bdata: Buffer.from(numbers.buffer).toString("base64") };
}

/** A client whose server gives one answer, and the URLs it was asked. */
function clientOf(body, { status = 200, headers = {} } = {}) {
  const asked = [];
  const fetch = async (url) => {
    asked.push(new URL(url, "http://here"));
    return new Response(typeof body === "string" ? body : JSON.stringify(body), {
      status,
      headers,
    });
  };
  return { asked, client: createClient({ fetch }) };
}

test("decodeArrays turns what is encoded into typed arrays and rows, and leaves the rest", () => {
  const decoded = decodeArrays({
    time: encoded("f8", Float64Array.of(0, 0.1, Math.PI), "3"),
    switches: encoded("i4", Int32Array.of(0, 2, 4, 6, 8, 10), "2,3"),
    summary: "slides",
  });
  assert.deepEqual(decoded, {
    time: Float64Array.of(0, 0.1, Math.PI),
    switches: [Int32Array.of(0, 2, 4), Int32Array.of(6, 8, 10)],
    summary: "slides",
  });
});

test("trace asks for the columns that are drawn, and reads the server's own time", async () => {
  const { asked, client } = clientOf(
    { time: encoded("f8", Float64Array.of(0, 1), "2"), epsilon_t: 0.5 },
    { headers: { "server-timing": "compute;dur=0.46" } },
  );
  const trace = await client.trace(COLLISION);
  assert.deepEqual(trace, { time: Float64Array.of(0, 1), epsilon_t: 0.5, milliseconds: 0.46 });
  assert.equal(asked[0].pathname, "/api/v1/trace");
  assert.deepEqual(Object.fromEntries(asked[0].searchParams), {
    kappa: "63",
    mu_over_alpha: "1.4",
    gt_over_gn: "1.358",
    samples: "300",
    quantities:
      "time,compression,normal_force,tangential_force_over_mu,tangential_velocity,spring_elongation,tangential_energy",
    encoding: "base64",
  });
});

test("cut asks along the vertical axis of the view, or along κ", async () => {
  const { asked, client } = clientOf({ values: encoded("f8", Float64Array.of(0.005, 5), "2") });
  const view = mapView(COLLISION, LOG);
  const axes = { muOverAlpha: 1.4, view, count: 200 };
  const cut = await client.cut({ along: "gt_over_gn", held: 63, ...axes });
  assert.deepEqual(cut.values, Float64Array.of(0.005, 5));
  assert.equal(asked[0].pathname, "/api/v1/cut");
  assert.deepEqual(Object.fromEntries(asked[0].searchParams), {
    along: "gt_over_gn",
    kappa: "63",
    mu_over_alpha: "1.4",
    minimum: "0.005",
    maximum: "5",
    count: "200",
    scale: "log",
    quantities: "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote",
    encoding: "base64",
  });
  await client.cut({ along: "kappa", held: 1.358, ...axes });
  const query = Object.fromEntries(asked[1].searchParams);
  assert.equal(query.gt_over_gn, "1.358");
  assert.deepEqual([query.along, query.minimum, query.maximum], ["kappa", "0.1", "1000"]);
  assert.ok(!("kappa" in query));
});

test("map asks for the axes of the view", async () => {
  const { asked, client } = clientOf({});
  await client.map({
    muOverAlpha: 1.4,
    view: mapView(COLLISION, LOG),
    counts: { kappa: 80, gtOverGn: 60 },
  });
  assert.equal(
    asked[0].search,
    "?mu_over_alpha=1.4&kappa_min=0.1&kappa_max=1000&kappa_count=80&kappa_scale=log" +
      "&gt_over_gn_min=0.005&gt_over_gn_max=5&gt_over_gn_count=60&gt_over_gn_scale=log&encoding=base64",
  );
});

test("steps and stepped ask with the damping of the collision, if it has any", async () => {
  const { asked, client } = clientOf({});
  const damped = { ...COLLISION, damping: 0.3 };
  await client.steps(damped, "1e-3");
  await client.stepped(damped, { method: "timestep" });
  await client.steps(COLLISION, "1e-3");
  await client.steps("damped", "1e-3");
  assert.equal(
    asked[0].search,
    "?kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358&damping=0.3&error=1e-3",
  );
  assert.equal(asked[1].searchParams.get("damping"), "0.3");
  assert.equal(asked[2].search, "?kappa=63&mu_over_alpha=1.4&gt_over_gn=1.358&error=1e-3");
  assert.equal(asked[3].search, "?region=damped&error=1e-3");
});

test("a refusal is told in the server's own words", async () => {
  const { client } = clientOf({ detail: "too many switches" }, { status: 413 });
  await assert.rejects(
    client.trace(COLLISION),
    (error) => error instanceof Refused && error.message === "too many switches",
  );
});

test("a server that is busy, gone or breaks off may be asked again", async () => {
  const gone = createClient({ fetch: () => Promise.reject(new TypeError("failed to fetch")) });
  const clients = {
    busy: clientOf({}, { status: 503 }).client,
    brokenOff: clientOf('{"time":').client,
  };
  for (const [reason, client] of Object.entries({ ...clients, silent: gone })) {
    await assert.rejects(
      client.trace(COLLISION),
      (error) => error instanceof Unreachable && error.reason === reason,
    );
  }
});

test("a crowded server is asked once more, not before it says, and not for whom it no longer matters", async (t) => {
  t.mock.timers.enable({ apis: ["setTimeout"] });
  const statuses = [503, 200, 503, 503, 503];
  let asked = 0;
  const fetch = async () =>
    new Response("{}", { status: statuses[asked++], headers: { "retry-after": "1" } });
  const turn = () => new Promise((resolve) => setImmediate(resolve));
  const client = createClient({ fetch });

  const answer = client.trace(COLLISION);
  await turn();
  t.mock.timers.tick(999);
  await turn();
  assert.equal(asked, 1);
  t.mock.timers.tick(1001);
  await answer;
  assert.equal(asked, 2);

  const inVain = client.trace(COLLISION);
  await turn();
  t.mock.timers.tick(2000);
  await assert.rejects(inVain, Unreachable);
  assert.equal(asked, 4);

  const controller = new AbortController();
  const forgotten = client.trace(COLLISION, controller.signal);
  await turn();
  controller.abort();
  await assert.rejects(forgotten, Unreachable);
  assert.equal(asked, 5);
});
