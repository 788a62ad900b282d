// @ts-check

import { say } from "./words.js";

/** |ε_t| from which on the outcome is called that of smooth spheres or of gear wheels. */
const LAST_WORD = 0.995;
/** Error of ε_t from which on a percentage cannot be told. */
const COARSE = 0.005;
/** Below this, next to nothing is left. */
const NEXT_TO_NOTHING = 0.001;

/**
 * The parameters of a collision; without damping nothing is said of it.
 * @param {{kappa: number, mu_over_alpha: number, gt_over_gn: number, damping: number}} collision
 * @param {(value: number) => string} written
 */
export function collisionInALine({ kappa, mu_over_alpha: mu, gt_over_gn: gt, damping }, written) {
  const damped = damping > 0 ? `, η = ${written(damping)}` : "";
  return `κ = ${written(kappa)}, μ/α = ${written(mu)}, g_t/g_n = ${written(gt)}${damped}`;
}

/**
 * A collision as a screen reader says it: how it went and what is left.
 * @param {object} collision an answer about it, exact
 * @param {number} collision.epsilon_t
 * @param {number} collision.error_bound
 * @param {number | null} collision.switches
 * @param {number | null} collision.reversals
 * @param {number | null} collision.first_episode_share
 * @param {boolean} collision.limit
 */
export function sentenceOf({ switches, reversals, first_episode_share: share, limit, ...answer }) {
  const outcome = outcomeOf(answer.epsilon_t, answer.error_bound);
  if (limit) {
    return say("collision.resting");
  }
  if (switches === null || share === null) {
    return say("collision.onlyOutcome", {
      outcome: `${outcome[0].toUpperCase()}${outcome.slice(1)}`,
    });
  }
  if (switches === 0) {
    return say("collision.slidesOnly", { outcome });
  }
  // With damping a collision may begin with sticking: then it switches an odd number of times.
  const beginsSticking = switches % 2 === 1;
  const again = beginsSticking ? (switches - 1) / 2 : switches / 2 - 1;
  return say("collision.story", {
    begins: say(beginsSticking ? "collision.sticksFirst" : "collision.slidesFirst", {
      share: percent(share),
    }),
    again: again > 0 ? say(`collision.again.${howOften(again)}`, { count: again }) : "",
    turns: reversals ? say(`collision.turns.${howOften(reversals)}`, { count: reversals }) : "",
    outcome,
  });
}

/**
 * @param {number} epsilon
 * @param {number} bound on its error
 */
function outcomeOf(epsilon, bound) {
  if (bound > COARSE) {
    const most = Math.abs(epsilon) + bound;
    return most >= 1
      ? say("collision.unknown")
      : say("collision.atMost", { share: `${Math.ceil(100 * most)} %` });
  }
  if (Math.abs(epsilon) >= LAST_WORD) {
    return say(epsilon > 0 ? "collision.smooth" : "collision.gearWheels");
  }
  if (Math.abs(epsilon) < NEXT_TO_NOTHING) {
    return say("collision.nothing");
  }
  const kept = { share: percent(Math.abs(epsilon)) };
  return say(epsilon < 0 ? "collision.reversed" : "collision.left", kept);
}

/** @param {number} share */
function percent(share) {
  return share >= 0.01 ? `${(100 * share).toFixed(0)} %` : say("collision.underOnePercent");
}

/** Once and twice have words of their own. @param {number} count */
function howOften(count) {
  return ["once", "twice"][count - 1] ?? "often";
}
