// @ts-check

import { NO_GHOSTS } from "./ghosts.js";
import { reachOf } from "./reach.js";

/** @typedef {import("../../api/answers.js").Trace} Trace */

/** So many of the last traces stay behind, the older the fainter. */
const MOST = 7;

/** Of the youngest, and of the oldest. */
const OPACITIES = [0.5, 0.08];

/** Apart by this share of the range, so that they are half of it. */
const APART = 1 / 12;

/**
 * What a sweep leaves behind in force and velocity, evenly spaced on the slider.
 * @param {(trails: import("./ghosts.js").Ghosts) => void} showTrails
 */
export function createTrails(showTrails) {
  /** The oldest first. @type {{trace: Trace, share: number}[]} */
  let kept = [];

  return {
    /**
     * @param {Trace} trace
     * @param {number} share of the slider
     * @param {number} span of the sweep, in the same
     */
    add(trace, share, span) {
      const last = kept.at(-1);
      if (!last || Math.abs(share - last.share) >= APART * span) {
        kept = [...kept, { trace, share }].slice(-MOST);
        showTrails(trailsOf(kept.map((each) => each.trace)));
      }
    },

    clear() {
      if (kept.length > 0) {
        kept = [];
        showTrails(NO_GHOSTS);
      }
    },
  };
}

/**
 * @param {Trace[]} traces the oldest first
 * @returns {import("./ghosts.js").Ghosts}
 */
export function trailsOf(traces) {
  const [youngest, oldest] = OPACITIES;
  return {
    ...NO_GHOSTS,
    ...reachOf(traces),
    lines: (column, theme, factor = 1) =>
      // All have their lines from the beginning, for a drag moves lines but makes none.
      Array.from({ length: MOST }, (_, i) => {
        const trace = traces[i - MOST + traces.length];
        const values = trace ? trace[column] : NOTHING.y;
        return {
          name: `trail ${i + 1}`,
          type: "scatter",
          mode: "lines",
          hoverinfo: "skip",
          x: trace ? trace.time : NOTHING.x,
          y: factor === 1 ? values : values.map((value) => factor * value),
          opacity: oldest + ((youngest - oldest) * i) / (MOST - 1),
          line: {
            width: 1.25 * theme.unit,
            color: column === "tangential_velocity" ? theme.velocity : theme.tangentialForce,
            simplify: false,
          },
        };
      }),
  };
}

/** A line too short to be seen. */
const NOTHING = { x: Float64Array.of(0, 1e-6), y: Float64Array.of(0, 0) };
