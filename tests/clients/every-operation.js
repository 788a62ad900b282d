// @ts-check

/** Asks a server everything that it answers, by openapi-fetch and the types made from its document. */

import createClient from "openapi-fetch";

const { process } = /** @type {any} */ (globalThis);
/** @type {import("openapi-fetch").Client<import("../../frontend/api/openapi.js").paths, "application/json">} */
const client = createClient({ baseUrl: process.argv[2] });

const collision = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358 };
/** @type {import("../../frontend/api/openapi.js").components["schemas"]["Sphere"]} */
const sphere = {
  radius_m: 0.02,
  density_kg_m3: 7850,
  youngs_modulus_pa: 2.1e11,
  poisson_ratio: 0.3,
  inertia: "solid",
};
/** @type {"mindlin"} */
const mindlin = "mindlin";
const contact = {
  body_1: sphere,
  body_2: sphere,
  friction_coefficient: 0.4,
  tangential_stiffness_n_per_m: mindlin,
};
const velocities = { min: 1, max: 2, count: 3 };

const answers = {
  collision: await client.GET("/api/v1/collision", { params: { query: collision } }),
  trace: await client.GET("/api/v1/trace", { params: { query: collision } }),
  cut: await client.GET("/api/v1/cut", {
    params: { query: { along: "gt_over_gn", kappa: 63, mu_over_alpha: 1.4 } },
  }),
  map: await client.GET("/api/v1/map", {
    params: { query: { mu_over_alpha: 1.4, kappa_count: 5, gt_over_gn_count: 4 } },
  }),
  collisions: await client.POST("/api/v1/collisions", {
    body: { kappa: [18, 63], mu_over_alpha: 1.4, gt_over_gn: 0.4, method: "exact" },
  }),
  scaling: await client.POST("/api/v1/scaling", {
    body: { ...contact, impact: { normal_velocity_m_s: 1, tangential_velocity_m_s: 0.5 } },
  }),
  velocity_map: await client.POST("/api/v1/scaling/map", {
    body: { ...contact, normal_velocity_m_s: velocities, tangential_velocity_m_s: velocities },
  }),
  codes: await client.POST("/api/v1/codes", {
    body: {
      body_1: contact.body_1,
      body_2: contact.body_2,
      normal_velocity_m_s: 1,
      kappa: 63,
      mu_over_alpha: 1.4,
      gt_over_gn: 1.358,
    },
  }),
  walton: await client.GET("/api/v1/walton", { params: { query: { beta_0: 0.4 } } }),
  bounce: await client.GET("/api/v1/bounce", {
    params: { query: { kappa: 4.5, mu_over_alpha: 1.4, gt_over_gn: 1.1, partner: "sphere" } },
  }),
  materials: await client.GET("/api/v1/materials"),
  table: await client.GET("/api/v1/table", {
    params: { query: { kappa_count: 5, psi_count: 4 } },
    parseAs: "text",
  }),
  tradeoff: await client.GET("/api/v1/tradeoff", { params: { query: { scene: "stiff" } } }),
  steps: await client.GET("/api/v1/steps", { params: { query: { region: "stiff" } } }),
  start_run: await client.POST("/api/v1/tradeoff/runs", { params: { query: { scene: "stiff" } } }),
  run: await client.GET("/api/v1/tradeoff/runs/{name}", { params: { path: { name: "none" } } }),
  cancel_run: await client.DELETE("/api/v1/tradeoff/runs/{name}", {
    params: { path: { name: "none" } },
  }),
  paper: await client.GET("/api/v1/paper"),
  presets: await client.GET("/api/v1/presets"),
  health: await client.GET("/healthz"),
  readiness: await client.GET("/readyz"),
  metrics: await client.GET("/metrics", { parseAs: "text" }),
};

// What the types say of an answer is there.
if (answers.collision.data?.switches !== 8 || answers.scaling.data?.warnings.length !== 0) {
  throw new Error("an answer is not what its type says");
}

process.stdout.write(
  JSON.stringify(
    Object.fromEntries(
      Object.entries(answers).map(([name, { response }]) => [name, response.status]),
    ),
  ),
);
