// @ts-check

import { forceFigure } from "../figures/force-figure.js";
import { velocityFigure } from "../figures/velocity-figure.js";
import { createPlot } from "./plot.js";

/**
 * The force trace.
 * @param {HTMLElement} element
 */
export function mountForceTrace(element) {
  const plot = createPlot(element, forceFigure);
  return {
    show: plot.show,
    /** @param {import("../api/client.js").Trace} trace */
    describe(trace) {
      element.setAttribute(
        "aria-label",
        `Tangential force over μ between plus and minus the normal force, with ${trace.switches} switches. ${trace.summary}`,
      );
    },
    unmount: plot.destroy,
  };
}

/**
 * The velocity on the same axis of time.
 * @param {HTMLElement} element
 */
export function mountVelocity(element) {
  const plot = createPlot(element, velocityFigure);
  return {
    show: plot.show,
    /** @param {import("../api/client.js").Trace} trace */
    describe(trace) {
      const [before, after] = [trace.tangential_velocity[0], trace.tangential_velocity.at(-1)];
      element.setAttribute(
        "aria-label",
        `Tangential velocity, from ${before} to ${after} in ${trace.reversals} turns.`,
      );
    },
    unmount: plot.destroy,
  };
}
