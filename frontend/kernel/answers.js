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

/** Cells that are computed before the clock is looked at: at most some ten milliseconds. */
const SLICE = 1024;

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
   * A map, whose computation lets the page have its turns.
   * @param {import("../api/queries.js").MapWish} wish
   * @param {AbortSignal} [signal]
   * @returns {Promise<import("../api/answers.js").MapGrid | null>}
   */
  async function map(wish, signal) {
    const { kappa, gtOverGn } = mapValues(wish);
    const size = kappa.length * gtOverGn.length;
    const kappas = new Float64Array(size).map((_, i) => kappa[i % kappa.length]);
    const tangentials = new Float64Array(size).map((_, i) => gtOverGn[(i / kappa.length) | 0]);
    const epsilonT = new Float64Array(size);
    const switches = new Float64Array(size);
    let turn = performance.now();
    for (let begin = 0; begin < size; begin += SLICE) {
      if (performance.now() - turn > LONGEST) {
        await new Promise((resolve) => setTimeout(resolve));
        signal?.throwIfAborted();
        turn = performance.now();
      }
      const found = kernel.collisions(
        {
          kappa: kappas.subarray(begin, begin + SLICE),
          gtOverGn: tangentials.subarray(begin, begin + SLICE),
          muOverAlpha: wish.muOverAlpha,
          damping: wish.view.damping,
        },
        MOST_SWITCHES_OF_A_CELL,
      );
      if (!found) {
        return null;
      }
      epsilonT.set(found.epsilonT, begin);
      switches.set(counted(found.switches), begin);
    }
    /** @param {Float64Array} cells */
    const rows = (cells) =>
      Array.from({ length: gtOverGn.length }, (_, row) =>
        cells.subarray(row * kappa.length, (row + 1) * kappa.length),
      );
    return { kappa, gt_over_gn: gtOverGn, epsilon_t: rows(epsilonT), switches: rows(switches) };
  }

  /**
   * @param {import("../api/queries.js").CutWish} wish
   * @returns {Promise<import("../api/answers.js").Cut | null>}
   */
  async function cut(wish) {
    const values = cutValues(wish);
    const held = new Float64Array(values.length).fill(wish.held);
    const [kappa, gtOverGn] = wish.along === "kappa" ? [values, held] : [held, values];
    const { muOverAlpha, view } = wish;
    const list = { kappa, gtOverGn, muOverAlpha, damping: view.damping };
    const first = { kappa: kappa[0], mu_over_alpha: muOverAlpha, gt_over_gn: gtOverGn[0] };
    const one = kernel.collision({ ...first, damping: view.damping });
    const found = one && kernel.collisions(list, MOST_SWITCHES_OF_A_CELL);
    const laws = found && kernel.simpleLaws(list, one.epsilonN);
    return (
      laws && {
        values,
        epsilon_t: found.epsilonT,
        switches: counted(found.switches),
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
    method: isFollowed ? /** @type {const} */ ("exact") : /** @type {const} */ ("stiff"),
    switches: isFollowed ? outcome.switches : null,
    switches_certain: isFollowed ? outcome.isCertain : null,
    reversals: null,
    first_episode_share: null,
    episodes: [],
  };
}

/** Switches that were counted. @param {Int32Array} switches */
function counted(switches) {
  return switches.includes(-1)
    ? Float64Array.from(switches, (count) => (count < 0 ? NaN : count))
    : switches;
}
