// @ts-check

import { regimeOf } from "../regimes.js";

/**
 * What the picture of a contact needs of a whole trace, worked out once for each.
 * @typedef {object} Motion
 * @property {import("../../../api/answers.js").Trace} trace
 * @property {Float64Array} slip how far one surface has slid over the other, at each sample
 * @property {{min: number, max: number}} slipRange
 * @property {number} largestElongation of the spring, to either side
 */

/**
 * The slip is what the surfaces have moved, less what the spring has taken up of it; it is summed up
 * from the columns for the drawing only.
 * @param {import("../../../api/answers.js").Trace} trace
 * @returns {Motion}
 */
export function contactMotion(trace) {
  const { time, tangential_velocity: velocity, spring_elongation: elongation } = trace;
  const slip = new Float64Array(time.length);
  const slipRange = { min: 0, max: 0 };
  let moved = 0;
  let largestElongation = 0;
  for (let i = 0; i < time.length; i += 1) {
    if (i > 0) {
      moved += 0.5 * (velocity[i - 1] + velocity[i]) * (time[i] - time[i - 1]);
    }
    slip[i] = moved - elongation[i];
    slipRange.min = Math.min(slipRange.min, slip[i]);
    slipRange.max = Math.max(slipRange.max, slip[i]);
    largestElongation = Math.max(largestElongation, Math.abs(elongation[i]));
  }
  return { trace, slip, slipRange, largestElongation };
}

/**
 * The same collision of a ball that comes from the other side.
 * @param {import("../../../api/answers.js").Trace} trace
 */
export function mirrored(trace) {
  const turned = (/** @type {Float64Array} */ column) => column.map((value) => -value);
  return {
    ...trace,
    tangential_force_over_mu: turned(trace.tangential_force_over_mu),
    tangential_velocity: turned(trace.tangential_velocity),
    spring_elongation: turned(trace.spring_elongation),
    episodes: trace.episodes.map((episode) => ({ ...episode, direction: -episode.direction })),
  };
}

/**
 * The state at an instant, between the samples.
 * @param {Motion} motion
 * @param {number} instant
 */
export function stateAt({ trace, slip }, instant) {
  const { time } = trace;
  const after = Math.min(time.length - 1, Math.max(1, firstAfter(time, instant)));
  const step = time[after] - time[after - 1];
  const rest = step > 0 ? Math.min(1, Math.max(0, (instant - time[after - 1]) / step)) : 1;
  const read = (/** @type {Float64Array} */ column) =>
    column[after - 1] + rest * (column[after] - column[after - 1]);
  return {
    compression: read(trace.compression),
    elongation: read(trace.spring_elongation),
    normalForce: read(trace.normal_force),
    tangentialForce: read(trace.tangential_force_over_mu),
    velocity: read(trace.tangential_velocity),
    slip: read(slip),
    regime: regimeAt(trace.episodes, instant),
  };
}

/**
 * The regime at an instant; the last one listed where the list is cut off.
 * @param {import("../../../api/answers.js").Episode[]} episodes
 * @param {number} instant
 */
function regimeAt(episodes, instant) {
  const episode = episodes.find(({ end }) => instant < end) ?? episodes.at(-1);
  return episode ? regimeOf(episode) : "sticking";
}

/**
 * @param {Float64Array} time ascending
 * @param {number} instant
 */
function firstAfter(time, instant) {
  let low = 0;
  let high = time.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (time[middle] <= instant) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}
