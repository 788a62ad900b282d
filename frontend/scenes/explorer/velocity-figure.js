// @ts-check

import {
  baseLayout,
  innerSize,
  plainAxis,
  timeAxis,
  TRACE_MARGIN,
} from "../../figures/plot-area.js";
import { brief, powerOfTen } from "../../format/number.js";
import { NO_GHOSTS } from "./ghosts.js";
import { regimePieces, regimeShades } from "./regimes.js";

/** Nearer to one another, the marks of the turns would hide the curve between them. */
const TURN_PIXELS = 36;

/** Beyond these, pixels per unit or the length of the axis leave the range of a double. */
const SHORTEST_REACH = 1e-290;
const LONGEST_REACH = 8e307;

/**
 * The tangential velocity of Fig. 6 over the contact, with its turns marked.
 * @param {import("../../api/answers.js").Trace} trace
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @param {boolean} [withEnergy] whether the share of the energy that is left is drawn too
 * @param {import("./ghosts.js").Ghosts} [ghosts]
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function velocityFigure(trace, theme, size, withEnergy = false, ghosts = NO_GHOSTS) {
  const { time, tangential_velocity: velocity, contact_duration: duration } = trace;
  const reach = roundedUp(Math.max(Math.abs(velocity[0]), ghosts.velocity));
  const span = Math.max(duration, ghosts.duration);
  const { unit } = theme;
  // Where plain digits would not fit beside the axis, it is numbered in a power of ten.
  const power = reach >= 0.01 && reach < 1000 ? 0 : Math.floor(Math.log10(reach));
  const last = time.length - 1;
  const width = innerSize(size, TRACE_MARGIN, theme).width / unit;
  const turns = turnsShown(trace, width);
  const pieces = regimePieces(trace, width / span);
  // Most collisions come back slowly: half of the axis below zero is enough for them.
  const bottom =
    Math.min(smallest(velocity), ghosts.leastVelocity) < -reach / 2 ? -reach : -reach / 2;
  const range = [bottom - 0.03 * reach, 1.03 * reach];
  return {
    data: [
      regimeShades(pieces, { base: bottom, top: reach }, theme),
      ...ghosts.lines("tangential_velocity", theme),
      {
        name: "tangential velocity",
        type: "scatter",
        mode: "lines",
        x: time,
        y: velocity,
        line: { width: 2.25 * unit, color: theme.velocity, simplify: false },
      },
      {
        name: "turns",
        type: "scatter",
        mode: "markers",
        x: turns,
        y: turns.map(() => 0),
        marker: {
          size: 7 * unit,
          color: theme.paper,
          line: { width: 1.75 * unit, color: theme.velocity },
        },
      },
      {
        name: "before and after",
        type: "scatter",
        mode: "markers",
        x: [time[0], time[last]],
        y: [velocity[0], velocity[last]],
        marker: { size: 8 * unit, color: theme.velocity },
        cliponaxis: false,
      },
      ...ghosts.letters("tangential_velocity", theme),
      // Last, for what has an axis of its own is drawn after all else.
      ...(withEnergy ? [energyLine(trace, reach, theme)] : []),
    ],
    layout: {
      ...baseLayout(theme, size, TRACE_MARGIN),
      xaxis: timeAxis(theme, span),
      yaxis: {
        ...plainAxis(
          theme,
          /** @type {[number, number]} */ (range),
          [-reach, -reach / 2, 0, reach / 2, reach],
          [-1, -0.5, 0, 0.5, 1].map((share) => brief((share * reach) / 10 ** power)),
        ),
        title: { text: power === 0 ? "" : `× ${powerOfTen(power)}`, standoff: 0 },
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
      ...(withEnergy ? { yaxis2: energyAxis(theme, range, reach) } : {}),
    },
  };
}

/**
 * The tangential energy as a share of that at the beginning, which lies at the top of the axis.
 * @param {import("../../api/answers.js").Trace} trace
 * @param {number} reach
 * @param {import("../../figures/theme.js").Theme} theme
 */
function energyLine({ time, tangential_energy: energy }, reach, { ink, unit }) {
  const share = (/** @type {number} */ value) => value / energy[0];
  return {
    name: "tangential energy",
    type: "scatter",
    mode: "lines",
    x: time,
    // None at the beginning, or one beyond a double: nothing can be a share of it.
    y: energy.map((value) => (Number.isFinite(share(value)) ? reach * share(value) : 0)),
    yaxis: "y2",
    line: { width: 1.5 * unit, color: ink, dash: "2px,3px", simplify: false },
  };
}

/**
 * The shares of the energy at the right edge, within the plot: the axis of time stays where it is.
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {number[]} range the same as that of the velocity
 * @param {number} reach
 */
function energyAxis(theme, range, reach) {
  const ticks = [reach / 2, reach];
  return {
    ...plainAxis(theme, /** @type {[number, number]} */ (range), ticks, ["50 %", "100 %"]),
    overlaying: "y",
    side: "right",
    ticklabelposition: "inside",
    ticks: "",
    layer: "above traces",
    tickfont: { size: 11 * theme.unit * theme.words, color: theme.ink },
  };
}

/**
 * The next of 1, 1.5, 2, 3, 4, 5, 6, 8, 10 …, so that the axis seldom moves while dragging.
 * @param {number} value
 */
function roundedUp(value) {
  if (!(value > 0)) {
    return 1;
  }
  const decade = 10 ** Math.floor(Math.log10(value));
  const step = [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((factor) => factor * decade >= value) ?? 10;
  const rounded = Number((step * decade).toPrecision(2));
  return Math.min(LONGEST_REACH, Math.max(SHORTEST_REACH, rounded));
}

/**
 * The instants at which the surfaces turn round, or none: where two lie between neighbouring samples
 * the number would be wrong, and where they are many the marks would be a smear.
 * @param {import("../../api/answers.js").Trace} trace
 * @param {number} width of the plot in pixels of the design
 */
function turnsShown({ time, tangential_velocity: velocity, reversals }, width) {
  const turns = zeroCrossings(time, velocity);
  return turns.length === reversals && turns.length * TURN_PIXELS < width ? turns : [];
}

/**
 * Where a sampled quantity changes its sign, read off the straight line between two samples.
 * @param {Float64Array} time
 * @param {Float64Array} values
 */
function zeroCrossings(time, values) {
  /** @type {number[]} */
  const crossings = [];
  for (let i = 1; i < time.length; i += 1) {
    if (values[i - 1] * values[i] < 0) {
      const share = values[i - 1] / (values[i - 1] - values[i]);
      crossings.push(time[i - 1] + share * (time[i] - time[i - 1]));
    }
  }
  return crossings;
}

/** @param {Float64Array} values */
function smallest(values) {
  return values.reduce((least, value) => Math.min(least, value), 0);
}
