// @ts-check

import { cutValues, mapValues, samplesFor } from "../api/queries.js";

/**
 * @typedef {import("../api/answers.js").CollisionAnswer} CollisionAnswer
 * @typedef {import("./kernel.js").Collision} Collision
 * @typedef {import("./kernel.js").Outcome} Outcome
 */

/** As many are listed, as by the server. */
const MOST_EPISODES = 200;

/** A cell of a map that switches more often is not followed: its ε_t is next to 0 there. */
const MOST_SWITCHES_OF_A_CELL = 500;

/** Collisions of a list that are computed before the clock is looked at: some milliseconds at most. */
const SLICE = 128;

/** After which the page gets its turn, in ms. */
const LONGEST = 8;

/**
 * The server's answers, made by the kernel in the page; null where the server is to be asked.
 * @param {import("./kernel.js").Kernel} kernel
 */
export function createAnswers(kernel) {
  /**
   * @param {Collision} given
   * @returns {Promise<CollisionAnswer | null>}
   */
  async function collision(given) {
    const found = kernel.trace(given, 2);
    if (found) {
      return followed(given, found);
    }
    const outcome = kernel.collision(given);
    return outcome && unfollowed(given, outcome);
  }

  /**
   * @param {Collision} given
   * @returns {Promise<import("../api/answers.js").Trace | null>}
   */
  async function trace(given) {
    const found = kernel.trace(given, samplesFor(given.kappa));
    return (
      found && {
        ...followed(given, found),
        switch_times: found.starts.slice(1),
        time: found.time,
        compression: found.compression,
        normal_force: found.normalForce,
        tangential_force_over_mu: found.tangentialForceOverMu,
        tangential_velocity: found.tangentialVelocity,
        spring_elongation: found.springElongation,
        tangential_energy: found.tangentialEnergy,
      }
    );
  }

  /**
   * The collisions of a list; its computation lets the page have its turns.
   * @param {import("./kernel.js").List} list
   * @param {AbortSignal} [signal]
   */
  async function listed({ kappa, gtOverGn, muOverAlpha, damping }, signal) {
    const epsilonT = new Float64Array(kappa.length);
    const switches = new Float64Array(kappa.length);
    let turn = performance.now();
    for (let begin = 0; begin < kappa.length; begin += SLICE) {
      if (performance.now() - turn > LONGEST) {
        await new Promise((resolve) => setTimeout(resolve));
        signal?.throwIfAborted();
        turn = performance.now();
      }
      const slice = {
        kappa: kappa.subarray(begin, begin + SLICE),
        gtOverGn: gtOverGn.subarray(begin, begin + SLICE),
        ...{ muOverAlpha, damping },
      };
      const found = kernel.collisions(slice, MOST_SWITCHES_OF_A_CELL);
      if (!found) {
        return null;
      }
      epsilonT.set(found.epsilonT, begin);
      switches.set(found.switches, begin);
    }
    return { epsilonT, switches: switches.map(counted) };
  }

  /**
   * @param {import("../api/queries.js").MapWish} wish
   * @param {AbortSignal} [signal]
   * @returns {Promise<import("../api/answers.js").MapGrid | null>}
   */
  async function map(wish, signal) {
    const { kappa, gtOverGn } = mapValues(wish);
    const { muOverAlpha, view } = wish;
    const columns = kappa.length;
    const size = columns * gtOverGn.length;
    const list = {
      kappa: new Float64Array(size).map((_, i) => kappa[i % columns]),
      gtOverGn: new Float64Array(size).map((_, i) => gtOverGn[Math.floor(i / columns)]),
      ...{ muOverAlpha, damping: view.damping },
    };
    const found = await listed(list, signal);
    /** @param {Float64Array} cells */
    const rows = (cells) =>
      Array.from(gtOverGn, (_, row) => cells.subarray(row * columns, (row + 1) * columns));
    return (
      found && {
        kappa,
        gt_over_gn: gtOverGn,
        epsilon_t: rows(found.epsilonT),
        switches: rows(found.switches),
      }
    );
  }

  /**
   * @param {import("../api/queries.js").CutWish} wish
   * @param {AbortSignal} [signal]
   * @returns {Promise<import("../api/answers.js").Cut | null>}
   */
  async function cut(wish, signal) {
    const values = cutValues(wish);
    const held = new Float64Array(values.length).fill(wish.held);
    const [kappa, gtOverGn] = wish.along === "kappa" ? [values, held] : [held, values];
    const { muOverAlpha, view } = wish;
    const list = { kappa, gtOverGn, muOverAlpha, damping: view.damping };
    const first = { kappa: kappa[0], mu_over_alpha: muOverAlpha, gt_over_gn: gtOverGn[0] };
    const one = kernel.collision({ ...first, damping: view.damping });
    const found = one && (await listed(list, signal));
    const laws = found && kernel.simpleLaws(list, one.epsilonN);
    return (
      laws && {
        values,
        epsilon_t: found.epsilonT,
        switches: found.switches,
        coulomb: laws.coulomb,
        stiff_bound: laws.stiffBound,
        stiff_asymptote: laws.stiffAsymptote,
      }
    );
  }

  /**
   * @param {import("../api/queries.js").Ball} ball
   * @returns {Promise<import("../api/answers.js").Bounces | null>}
   */
  async function bounce({ collision: given, alpha, partner }) {
    const first = kernel.collision(given);
    if (!first) {
      return null;
    }
    const found = kernel.bounce(alpha, partner, given, first);
    const { kappa, gtOverGn: gt_over_gn, damping } = found;
    const again = { kappa, mu_over_alpha: given.mu_over_alpha, gt_over_gn, damping };
    const second = partner === "wall" ? kernel.collision(again) : null;
    const side = first.epsilonT > 0 ? 1 : -1;
    return {
      mass_share: found.massShare,
      centre_change: found.centreChange,
      spin_change: found.spinChange,
      second: second && {
        ...again,
        direction: gt_over_gn > 0 ? side : 0,
        epsilon_t: second.epsilonT,
        epsilon_n: second.epsilonN,
      },
    };
  }

  return { collision, trace, map, cut, bounce };
}

/**
 * What is the same of every collision.
 * @param {Collision} collision
 * @param {Outcome} outcome
 */
function outcomeOf(collision, outcome) {
  const { epsilonT, epsilonN, errorBound, contactDuration, psi } = outcome;
  return {
    parameters: { ...collision, psi: Number.isFinite(psi) ? psi : null },
    epsilon_t: epsilonT,
    epsilon_n: epsilonN,
    error_bound: errorBound,
    contact_duration: contactDuration,
    energy: { dissipated_share: outcome.dissipatedShare },
    estimates: { coulomb: outcome.coulomb },
    limit: psi === 0,
    milliseconds: null,
  };
}

/**
 * @param {Collision} collision
 * @param {import("./kernel.js").Trace} trace
 */
function followed(collision, trace) {
  const { starts, directions, contactDuration } = trace;
  return {
    ...outcomeOf(collision, trace),
    method: /** @type {const} */ ("exact"),
    switches: trace.switches,
    switches_certain: trace.isCertain,
    reversals: trace.reversals,
    first_episode_share: trace.firstEpisodeShare,
    episodes: Array.from(starts.subarray(0, MOST_EPISODES), (start, i) => ({
      regime: directions[i] === 0 ? "sticking" : "sliding",
      start,
      end: i + 1 < starts.length ? starts[i + 1] : contactDuration,
      direction: directions[i],
    })),
  };
}

/**
 * A collision without its episodes, which are too many to list or were not followed.
 * @param {Collision} collision
 * @param {Outcome} outcome
 */
function unfollowed(collision, outcome) {
  const isFollowed = outcome.switches >= 0;
  return {
    ...outcomeOf(collision, outcome),
    method: isFollowed ? /** @type {const} */ ("exact") : unfollowedBy(collision),
    switches: isFollowed ? outcome.switches : null,
    switches_certain: isFollowed ? outcome.isCertain : null,
    reversals: null,
    first_episode_share: null,
    episodes: [],
  };
}

/** Whose law stands in, by its name. @param {Collision} collision @returns {"stiff" | "coulomb"} */
function unfollowedBy({ damping }) {
  return damping > 0 ? "coulomb" : "stiff";
}

/** NaN where a collision was not followed. @param {number} switches */
function counted(switches) {
  return switches < 0 ? NaN : switches;
}
