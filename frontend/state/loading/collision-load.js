// @ts-check

import { sentenceOf } from "../../format/sentence.js";
import {
  accuracyQuery,
  canAnswer,
  METHODS_BY_KERNEL,
  sameAccuracy,
  USUAL_ACCURACY,
} from "../accuracy.js";
import { mayBeTooStiffToDraw, MOST_SWITCHES_DRAWN, whyNotDrawn } from "../drawable.js";

/**
 * @typedef {import("../parameters.js").Collision} Collision
 * @typedef {import("../../api/answers.js").CollisionAnswer} CollisionAnswer
 * @typedef {import("../../api/answers.js").Trace} Trace
 */

/**
 * @typedef {object} CollisionWish
 * @property {Collision} collision
 * @property {import("../accuracy.js").Accuracy} accuracy
 * @property {import("../store.js").Change} change
 * @property {boolean} isPictured whether its trace is wanted
 */

/**
 * @typedef {object} LoadedCollision
 * @property {CollisionAnswer} result with ε_t as the chosen method has it
 * @property {string} sentence about the collision, as it is exactly
 * @property {Trace | null} trace exact
 * @property {string} reason why there is none, where one was wanted
 * @property {boolean} isOffered whether the chosen method has answered, or else the exact one stands in
 * @property {boolean} isAlone whether there was no server to ask
 */

/**
 * What answers of the client's calls.
 * @typedef {Pick<ReturnType<typeof import("../../api/client.js").createClient>, "collision" | "trace" | "answer" | "map" | "cut" | "bounce">} Server
 */

/**
 * Who is asked.
 * @typedef {object} Source
 * @property {(dragging: boolean) => boolean} isNear whether the kernel in the page is
 * @property {(dragging: boolean) => Server} of
 * @property {(told: CollisionAnswer) => void} compare what the server says with what the kernel does
 */

/** As long as there is nobody else. @param {Server} server @returns {Source} */
export function serverAlone(server) {
  return { isNear: () => false, of: () => server, compare() {} };
}

/**
 * A collision as it is exactly: with its trace, or, where it switches too often for a picture, without.
 * @param {Server} server
 * @param {Collision} collision
 * @param {AbortSignal} signal
 */
async function loadPictured(server, collision, signal) {
  if (mayBeTooStiffToDraw(collision)) {
    const result = await server.collision(collision, signal);
    if (result.switches === null || result.switches > MOST_SWITCHES_DRAWN) {
      return { result, trace: null, reason: whyNotDrawn(result) };
    }
  }
  const trace = await server.trace(collision, signal);
  return { result: trace, trace, reason: "" };
}

/**
 * @param {Server} server
 * @param {Collision} collision
 * @param {AbortSignal} signal
 */
async function loadAlone(server, collision, signal) {
  return { result: await server.collision(collision, signal), trace: null, reason: "" };
}

/**
 * How a collision is asked for.
 * @param {Source} source
 */
export function createCollisionLoad(source) {
  /**
   * @param {CollisionWish} wish
   * @param {AbortSignal} signal
   * @returns {Promise<LoadedCollision>}
   */
  return async function load({ collision, accuracy, change, isPictured }, signal) {
    const server = source.of(change.dragging);
    const isUsual = sameAccuracy(accuracy, USUAL_ACCURACY);
    // Who is alone with the kernel has the exact collision and no other method.
    const isAlone = source.isNear(false);
    const isKnown = !isAlone || METHODS_BY_KERNEL.includes(accuracy.method);
    const isOffered = isKnown && canAnswer(accuracy.method, collision);
    const [exactly, answer] = await Promise.all([
      (isPictured ? loadPictured : loadAlone)(server, collision, signal),
      isUsual || isAlone || !isOffered
        ? null
        : server.answer(collision, accuracyQuery(accuracy), signal),
    ]);
    if (!source.isNear(change.dragging)) {
      source.compare(exactly.result);
    }
    const sentence = sentenceOf(exactly.result);
    return { ...exactly, sentence, result: { ...exactly.result, ...answer }, isOffered, isAlone };
  };
}

/**
 * @typedef {import("../../api/queries.js").Ball & {times: 1 | 2, dragging: boolean}} BallWish
 * @typedef {import("../../api/answers.js").Bounces} Bounces
 */

/**
 * @typedef {object} LoadedBall
 * @property {Bounces} answer whose factors hold for every collision of these bodies
 * @property {import("../../api/answers.js").Trace | null} trace of the second collision, where it is wanted
 * @property {import("../parameters.js").Collision} collision that it is asked for
 */

/**
 * How a ball is asked for: what it leaves with, and the next collision with its trace.
 * @param {Source} source
 */
export function createBallLoad(source) {
  /**
   * @param {BallWish} wish
   * @param {AbortSignal} signal
   * @returns {Promise<LoadedBall>}
   */
  return async function load(wish, signal) {
    const server = source.of(wish.dragging);
    const answer = await server.bounce(wish, signal);
    const collision = wish.collision;
    if (wish.times === 1 || !answer.second) {
      return { answer, trace: null, collision };
    }
    const { trace } = await loadPictured(server, answer.second, signal);
    return { answer, trace, collision };
  };
}
