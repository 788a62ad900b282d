// @ts-check

/** @typedef {import("../../api/answers.js").Trace} Trace */

/**
 * How far the axes must reach to hold traces behind that of the present collision.
 * @param {Trace[]} traces
 */
export function reachOf(traces) {
  const most = (/** @type {(trace: Trace) => number} */ of) =>
    traces.reduce((largest, trace) => Math.max(largest, of(trace)), 0);
  return {
    duration: most((trace) => trace.contact_duration),
    tangentialForce: most(({ tangential_force_over_mu: forces }) =>
      forces.reduce((largest, force) => Math.max(largest, Math.abs(force)), 0),
    ),
    velocity: most(({ tangential_velocity: velocity }) => Math.abs(velocity[0])),
    leastVelocity: -most(({ tangential_velocity: velocity }) =>
      velocity.reduce((largest, value) => Math.max(largest, -value), 0),
    ),
  };
}
