// @ts-check

import { decodeArrays } from "./arrays.js";

/**
 * What this page reads of an answer of `/collision`.
 * @typedef {object} CollisionAnswer
 * @property {Episode[]} episodes
 * @property {import("../state/parameters.js").Collision & {psi: number | null}} parameters
 * @property {number} epsilon_t
 * @property {number | null} switches
 * @property {number | null} reversals
 * @property {number} contact_duration
 * @property {{initial: number, final: number, dissipated: number}} energy
 * @property {string} summary
 * @property {string} convention
 * @property {boolean} limit
 * @property {string} method
 * @property {number} error_bound
 * @property {number | null} milliseconds the server's own computing time
 */

/** @typedef {Pick<CollisionAnswer, "epsilon_t" | "method" | "error_bound" | "milliseconds">} Answer */

/**
 * What this page reads of an answer of `/trace`, its columns among it.
 * @typedef {CollisionAnswer & Columns & {switch_times: Float64Array}} Trace
 * @typedef {Record<"time" | "compression" | "normal_force" | "tangential_force_over_mu" | "tangential_velocity" | "spring_elongation" | "tangential_energy", Float64Array>} Columns
 */

/** @typedef {{regime: "sliding" | "sticking", start: number, end: number, direction: number}} Episode */

/**
 * @typedef {object} MapGrid
 * @property {Float64Array} kappa
 * @property {Float64Array} gt_over_gn
 * @property {Float64Array[]} epsilon_t rows of constant g_t/g_n
 * @property {Int32Array[]} switches
 */

/**
 * What is asked of `/cut`, and its columns; a number that does not exist is NaN.
 * @typedef {{kappa: number, muOverAlpha: number, view: import("../state/map-view.js").MapView, count: number}} CutWish
 * @typedef {{switches: Int32Array | Float64Array} & Record<"values" | "epsilon_t" | "coulomb" | "stiff_bound" | "stiff_asymptote", Float64Array>} Cut
 */

/**
 * A collision in time steps.
 * @typedef {object} Stepped
 * @property {number} epsilon_t
 * @property {number} error_bound
 * @property {Float64Array} method_time
 * @property {Float64Array} method_tangential_force_over_mu
 */

/**
 * What this page reads of `/tradeoff` and of `/steps`.
 * @typedef {{scene: string, measured_at: string, machine: string, rows: import("../figures/tradeoff-figure.js").Row[], can_be_measured_anew: boolean}} Tradeoff
 * @typedef {{id: string, scene: string, state: "running" | "done" | "cancelled" | "failed", progress: number, result: Omit<Tradeoff, "can_be_measured_anew"> | null}} Run
 * @typedef {object} StepsAnswer
 * @property {number} stability_limit
 * @property {Record<string, {p95: number | null, worst: number | null}>} needed
 * @property {{steps_max: number, velocity_verlet: {error_p95: number | null, error_max: number | null}}} rule
 */

/** @typedef {import("../state/parameters.js").Collision & {id: string, title: string, damping: number, source: string}} Preset */

/** The server could not be asked, or is too busy: asking again later may help. */
export class Unreachable extends Error {}

/** The server answered that it will not answer this: its reason is the message. */
export class Refused extends Error {}

const TRACE_COLUMNS =
  "time,compression,normal_force,tangential_force_over_mu,tangential_velocity,spring_elongation,tangential_energy";
const CUT_COLUMNS = "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote";
const LONGEST_WAIT = 15_000;

/** The only place that knows the server. */
export function createClient({ base = "/api/v1", fetch = globalThis.fetch.bind(globalThis) } = {}) {
  /**
   * @param {string} url
   * @param {AbortSignal} [signal]
   */
  async function get(url, signal, method = "GET") {
    const limit = AbortSignal.timeout(LONGEST_WAIT);
    let response;
    try {
      const until = signal ? AbortSignal.any([signal, limit]) : limit;
      response = await fetch(url, { signal: until, method });
    } catch (error) {
      throw new Unreachable("The server does not answer", { cause: error });
    }
    if ([502, 503, 504].includes(response.status)) {
      throw new Unreachable("The server is busy");
    }
    const body = await response.json().catch(() => null);
    if (!response.ok) {
      throw new Refused(body?.detail ?? `the server answered ${response.status}`);
    }
    if (body === null) {
      throw new Unreachable("The server’s answer broke off");
    }
    return { body, milliseconds: computeTime(response.headers.get("server-timing")) };
  }

  return {
    /**
     * @param {import("../state/parameters.js").Collision} collision
     * @param {AbortSignal} [signal]
     * @returns {Promise<CollisionAnswer>}
     */
    async collision(collision, signal) {
      const query = new URLSearchParams({ ...collisionQuery(collision), episode_limit: "0" });
      const { body, milliseconds } = await get(`${base}/collision?${query}`, signal);
      return { ...body, milliseconds };
    },

    /**
     * ε_t alone, as exactly as is wanted of it.
     * @param {import("../state/parameters.js").Collision} collision
     * @param {Record<string, string>} accuracy method, tolerance and the like
     * @param {AbortSignal} [signal]
     * @returns {Promise<Answer>}
     */
    async answer(collision, accuracy, signal) {
      const query = new URLSearchParams(answerQuery(collision, accuracy));
      const { body, milliseconds } = await get(`${base}/collision?${query}`, signal);
      const { epsilon_t, method, error_bound } = body;
      return { epsilon_t, method, error_bound, milliseconds };
    },

    /**
     * @param {import("../state/parameters.js").Collision} collision
     * @param {AbortSignal} [signal]
     * @returns {Promise<Trace>}
     */
    async trace(collision, signal) {
      const query = new URLSearchParams({ ...traceQuery(collision), encoding: "base64" });
      const { body, milliseconds } = await get(`${base}/trace?${query}`, signal);
      return /** @type {Trace} */ ({ ...decodeArrays(body), milliseconds });
    },

    /**
     * @param {number} muOverAlpha
     * @param {import("../state/map-view.js").MapView} view
     * @param {{kappa: number, gtOverGn: number}} counts
     * @param {AbortSignal} [signal]
     * @returns {Promise<MapGrid>}
     */
    async map(muOverAlpha, view, counts, signal) {
      const query = new URLSearchParams({
        ...mapQuery(muOverAlpha, view, counts),
        encoding: "base64",
      });
      const { body } = await get(`${base}/map?${query}`, signal);
      return /** @type {MapGrid} */ (decodeArrays(body));
    },

    /**
     * @param {CutWish} wish
     * @param {AbortSignal} [signal]
     * @returns {Promise<Cut>}
     */
    async cut(wish, signal) {
      const query = new URLSearchParams({ ...cutQuery(wish), encoding: "base64" });
      const { body } = await get(`${base}/cut?${query}`, signal);
      return /** @type {Cut} */ (decodeArrays(body));
    },

    /**
     * What a method is off, cell by cell.
     * @param {Parameters<typeof errorMapQuery>[0]} wish
     * @param {AbortSignal} [signal]
     * @returns {Promise<Float64Array[]>}
     */
    async errorMap(wish, signal) {
      const query = new URLSearchParams({ ...errorMapQuery(wish), encoding: "base64" });
      const { body } = await get(`${base}/map?${query}`, signal);
      return decodeArrays(body).error;
    },

    /**
     * A collision in time steps, as these have it.
     * @param {import("../state/parameters.js").Collision} collision
     * @param {Record<string, string>} accuracy
     * @param {AbortSignal} [signal]
     * @returns {Promise<Stepped>}
     */
    async stepped(collision, accuracy, signal) {
      const query = new URLSearchParams({
        ...steppedQuery(collision, accuracy),
        encoding: "base64",
      });
      return /** @type {Stepped} */ (
        decodeArrays((await get(`${base}/trace?${query}`, signal)).body)
      );
    },

    /**
     * How many steps a wanted error takes.
     * @param {Record<string, string>} query
     * @param {AbortSignal} [signal]
     * @returns {Promise<StepsAnswer>}
     */
    async steps(query, signal) {
      return (await get(`${base}/steps?${new URLSearchParams(query)}`, signal)).body;
    },

    /**
     * What was measured in a region.
     * @param {string} region
     * @param {AbortSignal} [signal]
     * @returns {Promise<Tradeoff>}
     */
    async tradeoff(region, signal) {
      return (await get(`${base}/tradeoff?scene=${region}`, signal)).body;
    },

    /** Has a region measured anew. @param {string} region @returns {Promise<Run>} */
    async startRun(region) {
      return (await get(`${base}/tradeoff/runs?scene=${region}`, undefined, "POST")).body;
    },

    /** How far a measurement is. @param {string} id @returns {Promise<Run>} */
    async run(id) {
      return (await get(`${base}/tradeoff/runs/${id}`)).body;
    },

    /** @param {string} id @returns {Promise<Run>} */
    async cancelRun(id) {
      return (await get(`${base}/tradeoff/runs/${id}`, undefined, "DELETE")).body;
    },

    /** @returns {Promise<Preset[]>} */
    async presets() {
      return (await get(`${base}/presets`)).body.items;
    },
  };
}

/** What `/collision` is asked. @param {import("../state/parameters.js").Collision} collision */
export function collisionQuery({ kappa, mu_over_alpha, gt_over_gn }) {
  return inWords({ kappa, mu_over_alpha, gt_over_gn });
}

/**
 * What `/collision` is asked where ε_t alone is wanted.
 * @param {import("../state/parameters.js").Collision} collision
 * @param {Record<string, string>} accuracy
 */
export function answerQuery(collision, accuracy) {
  return { ...collisionQuery(collision), quantities: "epsilon_t", ...accuracy };
}

/** What `/trace` is asked. @param {import("../state/parameters.js").Collision} collision */
export function traceQuery(collision) {
  return {
    ...collisionQuery(collision),
    samples: String(samplesFor(collision.kappa)),
    quantities: TRACE_COLUMNS,
  };
}

/**
 * What `/map` is asked.
 * @param {number} muOverAlpha
 * @param {import("../state/map-view.js").MapView} view
 * @param {{kappa: number, gtOverGn: number}} counts
 */
export function mapQuery(muOverAlpha, view, counts) {
  return {
    mu_over_alpha: String(muOverAlpha),
    kappa_min: String(view.kappa.min),
    kappa_max: String(view.kappa.max),
    kappa_count: String(counts.kappa),
    kappa_scale: view.scale,
    gt_over_gn_min: String(view.gtOverGn.min),
    gt_over_gn_max: String(view.gtOverGn.max),
    gt_over_gn_count: String(counts.gtOverGn),
    gt_over_gn_scale: view.scale,
  };
}

/**
 * What `/map` is asked for its error.
 * @param {{muOverAlpha: number, view: import("../state/map-view.js").MapView, counts: {kappa: number, gtOverGn: number}, accuracy: Record<string, string>}} wish
 */
export function errorMapQuery({ muOverAlpha, view, counts, accuracy }) {
  return { ...mapQuery(muOverAlpha, view, counts), quantities: "error", ...accuracy };
}

/**
 * What `/trace` is asked for the steps of a method: of the exact columns, none that costs.
 * @param {import("../state/parameters.js").Collision} collision
 * @param {Record<string, string>} accuracy
 */
export function steppedQuery(collision, accuracy) {
  return {
    ...collisionQuery(collision),
    samples: "2",
    quantities: "time",
    episode_limit: "0",
    ...accuracy,
  };
}

/** What `/cut` is asked. @param {CutWish} wish */
export function cutQuery({ kappa, muOverAlpha, view, count }) {
  return {
    along: "gt_over_gn",
    kappa: String(kappa),
    mu_over_alpha: String(muOverAlpha),
    minimum: String(view.gtOverGn.min),
    maximum: String(view.gtOverGn.max),
    count: String(count),
    scale: view.scale,
    quantities: CUT_COLUMNS,
  };
}

/**
 * Samples enough to draw the free swings of the spring, of which there are about √κ/2 in a contact.
 * @param {number} kappa
 */
function samplesFor(kappa) {
  return Math.min(2000, Math.max(300, Math.ceil(10 * Math.sqrt(kappa))));
}

/** @param {Record<string, number>} numbers */
function inWords(numbers) {
  return Object.fromEntries(Object.entries(numbers).map(([key, value]) => [key, String(value)]));
}

/** @param {string | null} serverTiming */
function computeTime(serverTiming) {
  const match = /compute;dur=([\d.eE+-]+)/.exec(serverTiming ?? "");
  return match ? Number(match[1]) : null;
}
