// @ts-check

/**
 * @typedef {import("./collision-load.js").Server} Server
 * @typedef {import("../../api/answers.js").CollisionAnswer} CollisionAnswer
 */

/**
 * What the kernel in the page answers as the server does; null for what it leaves to that.
 * @typedef {{
 *   [Call in "collision" | "trace" | "map" | "cut" | "bounce"]: (
 *     ...asked: Parameters<Server[Call]>
 *   ) => Promise<Awaited<ReturnType<Server[Call]>> | null>;
 * }} Answers
 */

/** @type {(keyof Answers)[]} */
const CALLS = ["collision", "trace", "map", "cut", "bounce"];

/**
 * Who is asked: the kernel in the page while a hand drags and while the server is away, else the server.
 * @param {Server} server
 * @param {object} options
 * @param {() => boolean} options.isAway
 * @param {(own: CollisionAnswer, told: CollisionAnswer) => void} options.onDifference told once, if both do not agree
 */
export function createSource(server, { isAway, onDifference }) {
  /** @type {Answers | null} */
  let kernel = null;
  let isToBeConfirmed = true;

  /** @param {keyof Answers} call */
  const nearby = (call) => async (/** @type {any} */ wish, /** @type {AbortSignal} */ signal) =>
    (await kernel?.[call](wish, signal)) ?? server[call](wish, signal);
  /** @type {Server} */
  const near = { ...server, ...Object.fromEntries(CALLS.map((call) => [call, nearby(call)])) };

  /** Whether the kernel is asked. @param {boolean} dragging */
  const isNear = (dragging) => kernel !== null && (dragging || isAway());

  return {
    isNear,

    /** @param {boolean} dragging */
    of: (dragging) => (isNear(dragging) ? near : server),

    /** @param {Answers} answers from now on */
    takeKernel(answers) {
      kernel = answers;
    },

    /**
     * Whether the kernel agrees with the server about a collision.
     * @param {CollisionAnswer} told
     */
    async compare(told) {
      const own = isToBeConfirmed && (await kernel?.collision(told.parameters, UNENDING));
      if (own && isToBeConfirmed && differ(own, told)) {
        isToBeConfirmed = false;
        onDifference(own, told);
      }
    },
  };
}

const UNENDING = new AbortController().signal;

/**
 * Whether two answers cannot both be right.
 * @param {CollisionAnswer} own
 * @param {CollisionAnswer} told
 */
export function differ(own, told) {
  const bounds = own.error_bound + told.error_bound;
  const areCounted = own.switches_certain && told.switches_certain;
  return (
    Math.abs(own.epsilon_t - told.epsilon_t) > bounds ||
    (areCounted === true && own.switches !== told.switches)
  );
}
