// @ts-check

import { decodeArrays } from "./arrays.js";
import {
  answerQuery,
  bounceQuery,
  collisionQuery,
  cutQuery,
  errorMapQuery,
  mapQuery,
  steppedQuery,
  stepsQuery,
  traceQuery,
} from "./queries.js";

/**
 * @typedef {import("./answers.js").CollisionAnswer} CollisionAnswer
 * @typedef {import("./answers.js").Answer} Answer
 * @typedef {import("./answers.js").Trace} Trace
 * @typedef {import("./answers.js").MapGrid} MapGrid
 * @typedef {import("./answers.js").Cut} Cut
 * @typedef {import("./answers.js").Scaling} Scaling
 * @typedef {import("./answers.js").CodesAnswer} CodesAnswer
 * @typedef {import("./answers.js").VelocityMap} VelocityMap
 * @typedef {import("./answers.js").Stepped} Stepped
 * @typedef {import("./answers.js").Tradeoff} Tradeoff
 * @typedef {import("./answers.js").Run} Run
 * @typedef {import("./answers.js").StepsAnswer} StepsAnswer
 * @typedef {import("./answers.js").Preset} Preset
 * @typedef {import("./answers.js").Bounces} Bounces
 */

/** The server could not be asked, or is too busy: asking again later may help. */
export class Unreachable extends Error {
  /**
   * @param {"silent" | "busy" | "brokenOff"} reason
   * @param {ErrorOptions} [options]
   */
  constructor(reason, options) {
    super(reason, options);
    this.reason = reason;
  }
}

/** The server answered that it will not answer this: its reason, if it gives one, is the message. */
export class Refused extends Error {
  /**
   * @param {number} status
   * @param {string} [reason]
   */
  constructor(status, reason = "") {
    super(reason);
    this.status = status;
  }
}

/** This is asked of a server alone, and there is none: the page is one file. */
export class NeedsServer extends Error {}

const LONGEST_WAIT = 15_000;

/**
 * Whether the server says that too many ask, and when to come again.
 * @param {Response} response
 */
function isCrowded(response) {
  return response.status === 503 && response.headers.has("retry-after");
}

/**
 * Wait as long as the server says and up to as long again, for a class that was sent away together
 * shall not come back together.
 * @param {Response} response
 * @param {AbortSignal} signal
 */
function politePause(response, signal) {
  const wait = 1000 * Number(response.headers.get("retry-after")) * (1 + Math.random());
  return new Promise((resolve, reject) => {
    const timer = setTimeout(resolve, Number.isFinite(wait) ? wait : 1000);
    signal.addEventListener("abort", () => {
      clearTimeout(timer);
      reject(signal.reason);
    });
  });
}

/** The only place that knows the server. */
export function createClient({ base = "api/v1", fetch = globalThis.fetch.bind(globalThis) } = {}) {
  /**
   * @param {string} url
   * @param {AbortSignal} [signal]
   * @param {RequestInit} [how]
   */
  async function ask(url, signal, how = {}) {
    const limit = AbortSignal.timeout(LONGEST_WAIT);
    const until = signal ? AbortSignal.any([signal, limit]) : limit;
    let response;
    try {
      response = await fetch(url, { ...how, signal: until });
      if (isCrowded(response)) {
        await politePause(response, until);
        response = await fetch(url, { ...how, signal: until });
      }
    } catch (error) {
      throw new Unreachable("silent", { cause: error });
    }
    if ([502, 503, 504].includes(response.status)) {
      throw new Unreachable("busy");
    }
    if (!response.ok) {
      const body = await response.json().catch(() => null);
      throw new Refused(response.status, body?.detail);
    }
    return response;
  }

  /** @type {(...request: Parameters<typeof ask>) => Promise<{body: any, milliseconds: number}>} */
  async function get(...request) {
    const response = await ask(...request);
    const body = await response.json().catch(() => null);
    if (body === null) {
      throw new Unreachable("brokenOff");
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
     * Rejects unless the server itself, and nobody's cache, answers about a collision.
     * @param {import("../state/parameters.js").Collision} collision
     */
    async isAnswering(collision) {
      const query = new URLSearchParams({ ...collisionQuery(collision), episode_limit: "0" });
      await get(`${base}/collision?${query}`, undefined, { cache: "no-store" });
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
     * A ball before and after its collision, and the next one where it falls back.
     * @param {import("./queries.js").Ball} ball
     * @param {AbortSignal} [signal]
     * @returns {Promise<Bounces>}
     */
    async bounce(ball, signal) {
      return (await get(`${base}/bounce?${new URLSearchParams(bounceQuery(ball))}`, signal)).body;
    },

    /**
     * @param {import("./queries.js").MapWish} wish
     * @param {AbortSignal} [signal]
     * @returns {Promise<MapGrid>}
     */
    async map(wish, signal) {
      const query = new URLSearchParams({ ...mapQuery(wish), encoding: "base64" });
      const { body } = await get(`${base}/map?${query}`, signal);
      return /** @type {MapGrid} */ (decodeArrays(body));
    },

    /**
     * @param {import("./queries.js").CutWish} wish
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
     * @param {import("./queries.js").ErrorMapWish} wish
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
     * @param {import("../state/parameters.js").Collision | string} where a collision, or a region by its name
     * @param {string} error
     * @param {AbortSignal} [signal]
     * @returns {Promise<StepsAnswer>}
     */
    async steps(where, error, signal) {
      const query = new URLSearchParams(stepsQuery(where, error));
      return (await get(`${base}/steps?${query}`, signal)).body;
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

    /** @returns {Promise<import("../state/impact.js").Material[]>} */
    async materials() {
      return (await get(`${base}/materials`)).body.items;
    },

    /**
     * A collision of real bodies.
     * @param {Record<string, any>} body
     * @param {AbortSignal} [signal]
     * @returns {Promise<Scaling>}
     */
    async scaling(body, signal) {
      return (await get(`${base}/scaling`, signal, posted(body))).body;
    },

    /**
     * What DEM codes take for a collision.
     * @param {Record<string, any>} body
     * @param {AbortSignal} [signal]
     * @returns {Promise<CodesAnswer>}
     */
    async codes(body, signal) {
      return (await get(`${base}/codes`, signal, posted(body))).body;
    },

    /**
     * ε_t over the velocities of an impact.
     * @param {Record<string, any>} body
     * @param {AbortSignal} [signal]
     * @returns {Promise<VelocityMap>}
     */
    async velocityMap(body, signal) {
      const { body: answer } = await get(
        `${base}/scaling/map?encoding=base64`,
        signal,
        posted(body),
      );
      return /** @type {VelocityMap} */ (decodeArrays(answer));
    },

    /**
     * What is answered to a request, as a file.
     * @param {import("../format/requests.js").Request} request
     * @returns {Promise<Blob>}
     */
    async file({ call, query, body }) {
      const url = `${base}/${call}?${new URLSearchParams(query)}`;
      const response = await ask(url, undefined, body && posted(body));
      return response.blob().catch(() => {
        throw new Unreachable("brokenOff");
      });
    },

    /**
     * A file of a font.
     * @param {string} address
     */
    async font(address) {
      const response = await fetch(address);
      if (!response.ok) {
        throw new Refused(response.status);
      }
      return response.blob();
    },

    /** Has a region measured anew. @param {string} region @returns {Promise<Run>} */
    async startRun(region) {
      return (await get(`${base}/tradeoff/runs?scene=${region}`, undefined, { method: "POST" }))
        .body;
    },

    /** How far a measurement is. @param {string} id @returns {Promise<Run>} */
    async run(id) {
      return (await get(`${base}/tradeoff/runs/${id}`)).body;
    },

    /** @param {string} id @returns {Promise<Run>} */
    async cancelRun(id) {
      return (await get(`${base}/tradeoff/runs/${id}`, undefined, { method: "DELETE" })).body;
    },

    /** @returns {Promise<import("../state/paper.js").Paper>} */
    async paper() {
      return (await get(`${base}/paper`)).body;
    },

    /**
     * An answer with its arrays.
     * @param {string} call
     * @param {Record<string, string>} query
     */
    async columns(call, query) {
      const marks = new URLSearchParams({ ...query, encoding: "base64" });
      return decodeArrays((await get(`${base}/${call}?${marks}`)).body);
    },

    /**
     * The words of a language that do not come with the page.
     * @param {string} language
     * @returns {Promise<Record<string, any>>}
     */
    async words(language) {
      return (await get(`words/${language}`)).body;
    },

    /** The kernel that computes collisions in the page. */
    async kernel() {
      const response = await ask(new URL("../kernel/kernel.wasm", import.meta.url).href);
      return WebAssembly.compile(await response.arrayBuffer());
    },

    /** @returns {Promise<Preset[]>} */
    async presets() {
      return (await get(`${base}/presets`)).body.items;
    },
  };
}

/** @param {Record<string, any>} body @returns {RequestInit} */
function posted(body) {
  return {
    method: "POST",
    headers: { "Content-Type": "application/json" },
    body: JSON.stringify(body),
  };
}

/** NaN where the server does not tell, or a proxy has cut it off. @param {string | null} serverTiming */
function computeTime(serverTiming) {
  const match = /compute;dur=([\d.eE+-]+)/.exec(serverTiming ?? "");
  return match ? Number(match[1]) : NaN;
}
