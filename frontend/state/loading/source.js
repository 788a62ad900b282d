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
 * @param {Answers} kernel
 * @param {object} options
 * @param {() => boolean} options.isAway
 * @param {(...what: unknown[]) => void} options.onFault told if the kernel breaks down, after which it is not asked
 *   again, or does not agree with the server, once
 * @returns {import("./collision-load.js").Source}
 */
export function createSource(server, kernel, { isAway, onFault }) {
  let isWhole = true;
  let isToBeConfirmed = true;

  /** @param {keyof Answers} call */
  const nearby = (call) => async (/** @type {any} */ wish, /** @type {AbortSignal} */ signal) => {
    try {
      const found = await kernel[call](wish, signal);
      if (found) {
        return found;
      }
    } catch (error) {
      signal?.throwIfAborted();
      isWhole = false;
      onFault("broke down:", error);
    }
    return server[call](wish, signal);
  };
  /** @type {Server} */
  const near = { ...server, ...Object.fromEntries(CALLS.map((call) => [call, nearby(call)])) };

  /** @param {boolean} dragging */
  const isNear = (dragging) => isWhole && (dragging || isAway());

  return {
    isNear,
    of: (dragging) => (isNear(dragging) ? near : server),

    async compare(told) {
      const isAsked = isWhole && isToBeConfirmed;
      const own = isAsked && (await kernel.collision(told.parameters, UNENDING));
      if (own && isToBeConfirmed && differ(own, told)) {
        isToBeConfirmed = false;
        onFault("differs from the server:", own, told);
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
function differ(own, told) {
  const bounds = own.error_bound + told.error_bound;
  const areCounted = own.switches_certain && told.switches_certain;
  return (
    Math.abs(own.epsilon_t - told.epsilon_t) > bounds ||
    (areCounted === true && own.switches !== told.switches)
  );
}
