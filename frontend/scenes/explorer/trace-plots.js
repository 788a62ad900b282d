// @ts-check

import { significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { NO_GHOSTS } from "./ghosts.js";
import { forceFigure } from "./force-figure.js";
import { velocityFigure } from "./velocity-figure.js";

/**
 * The force trace.
 * @param {HTMLElement} element
 */
export function mountForceTrace(element) {
  const plot = createTracePlot(element, forceFigure);
  return {
    ...plot,
    /**
     * @param {import("../../api/answers.js").Trace} trace
     * @param {string} sentence about the collision
     */
    describe(trace, sentence) {
      element.setAttribute(
        "aria-label",
        `${say("force.described", { count: trace.switches })} ${sentence}`,
      );
    },
  };
}

/**
 * The velocity on the same axis of time.
 * @param {HTMLElement} element
 */
export function mountVelocity(element) {
  let withEnergy = false;
  const plot = createTracePlot(element, (trace, theme, size, ghosts) =>
    velocityFigure(trace, theme, size, withEnergy, ghosts),
  );
  return {
    ...plot,
    /** Whether the energy is shown too, from the next picture on. @param {boolean} wanted */
    showEnergy(wanted) {
      withEnergy = wanted;
    },
    /** @param {import("../../api/answers.js").Trace} trace */
    describe(trace) {
      const [before, after] = [trace.tangential_velocity[0], trace.tangential_velocity.at(-1)];
      element.setAttribute(
        "aria-label",
        say("velocity.described", {
          before: significant(before),
          after: significant(after),
          count: trace.reversals,
        }),
      );
    },
  };
}

/**
 * A plot of a trace, or the reason why there is none.
 * @param {HTMLElement} element
 * @param {(...args: Parameters<typeof forceFigure>) => import("../../figures/plot-area.js").Figure} makeFigure
 */
function createTracePlot(element, makeFigure) {
  let ghosts = NO_GHOSTS;
  const plot = createPlot(
    element,
    (/** @type {Parameters<typeof forceFigure>[0]} */ trace, theme, size) =>
      makeFigure(trace, theme, size, ghosts),
  );
  const stage = /** @type {HTMLElement} */ (element.parentElement);

  return {
    /**
     * @param {import("../../api/answers.js").Trace} trace
     * @param {boolean} dragging
     */
    show(trace, dragging) {
      if (stage.hasAttribute("data-reason")) {
        showReason(stage, "");
      }
      return plot.show(trace, dragging);
    },
    /** What lies behind the next picture. @param {typeof ghosts} next */
    showGhosts(next) {
      ghosts = next;
    },
    /** @param {string} reason */
    showReason: (reason) => showReason(stage, reason),
  };
}
