// @ts-check

import {
  baseLayout,
  forceReach,
  innerSize,
  plainAxis,
  timeAxis,
  TRACE_MARGIN,
} from "../../figures/plot-area.js";
import { spreadApart } from "../../figures/spread.js";
import { powerOfTen } from "../../format/number.js";
import { say } from "../../format/words.js";
import { NO_GHOSTS } from "./ghosts.js";
import { regimePieces, regimeRibbon, regimeShades, SPACE } from "./regimes.js";

const RIBBON_PIXELS = 18;
const NUMBER_PIXELS = 15;
/** How far a number may stand from its switch, in widths of a number. */
const FARTHEST = 2.5;

/**
 * The force trace of Fig. 5: F_t/μ between ±F_n, the regimes shaded, the switches numbered.
 * @param {import("../../api/answers.js").Trace} trace
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @param {import("./ghosts.js").Ghosts} [ghosts]
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function forceFigure(trace, theme, size, ghosts = NO_GHOSTS) {
  const { time, normal_force: normalForce, contact_duration: duration } = trace;
  const reach = Math.max(forceReach(normalForce), 1.05 * ghosts.tangentialForce);
  const span = Math.max(duration, ghosts.duration);
  const { unit } = theme;
  const inner = innerSize(size, TRACE_MARGIN, theme);
  // The ribbon takes its pixels above the forces, whatever the height of the plot.
  const perPixel = (2 * reach) / Math.max(1, inner.height - unit * RIBBON_PIXELS);
  const top = reach + unit * RIBBON_PIXELS * perPixel;
  const pixelsPerTime = inner.width / span;
  const numbers = switchNumbers(
    trace.switch_times,
    duration,
    (reach + top) / 2,
    pixelsPerTime,
    theme,
  );
  const pieces = regimePieces(trace, pixelsPerTime / unit);
  const factor = enlargement(trace.tangential_force_over_mu, ghosts.tangentialForce);
  const ribbon = { base: reach + unit * perPixel, top: top - unit * perPixel };
  return {
    data: [
      regimeShades(pieces, { base: -reach, top: reach }, theme),
      regimeRibbon(pieces, ribbon, numbers.x, pixelsPerTime, theme),
      envelope(time, normalForce, theme),
      ...ghosts.lines("tangential_force_over_mu", theme, factor),
      {
        name: "tangential force / mu",
        type: "scatter",
        mode: "lines",
        x: time,
        y: enlarged(trace.tangential_force_over_mu, factor),
        line: { width: 2.25 * unit, color: theme.tangentialForce, simplify: false },
      },
      enlargementNote(factor, reach, span, theme),
      numbers,
      ...ghosts.letters("tangential_force_over_mu", theme, factor),
    ],
    layout: {
      ...baseLayout(theme, size, TRACE_MARGIN),
      xaxis: timeAxis(theme, span),
      yaxis: {
        ...plainAxis(theme, [-reach, top], [-1, 0, 1], ["−1", "0", "1"]),
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
    },
  };
}

/** A force of this share of the normal one lies on the axis. */
const FLAT = 0.03;

/**
 * The power of ten by which a force is drawn larger than it is, so that one sees what it does.
 * @param {Float64Array} forces
 * @param {number} least that is to be seen, too
 */
function enlargement(forces, least) {
  const largest = forces.reduce((most, force) => Math.max(most, Math.abs(force)), least);
  // Nothing is not enlarged, and what no double holds is not, either.
  return largest > 1e-300 && largest < FLAT ? 10 ** -Math.ceil(Math.log10(largest)) : 1;
}

/**
 * @param {Float64Array} forces
 * @param {number} factor
 */
function enlarged(forces, factor) {
  return factor === 1 ? forces : forces.map((force) => factor * force);
}

/**
 * What is written beside a force that is drawn larger.
 * @param {number} factor
 * @param {number} reach
 * @param {number} duration
 * @param {import("../../figures/theme.js").Theme} theme
 */
function enlargementNote(factor, reach, duration, theme) {
  const text = say("force.enlarged", { factor: powerOfTen(Math.round(Math.log10(factor))) });
  return {
    name: "enlargement",
    type: "scatter",
    // Text alone has nothing that a drag can move.
    mode: "markers+text",
    marker: { size: 1, color: "rgba(0,0,0,0)" },
    x: [0.02 * duration],
    y: [-0.85 * reach],
    // A place that is kept: a drag moves what is there.
    text: [factor === 1 ? SPACE : text],
    textposition: "middle right",
    textfont: { size: 12 * theme.unit * theme.words, color: theme.tangentialForce },
  };
}

/**
 * ±F_n as one closed line: it is zero at both ends.
 * @param {Float64Array} time
 * @param {Float64Array} normalForce
 * @param {import("../../figures/theme.js").Theme} theme
 */
function envelope(time, normalForce, theme) {
  const count = time.length;
  const x = new Float64Array(2 * count);
  const y = new Float64Array(2 * count);
  for (let i = 0; i < count; i += 1) {
    x[i] = time[i];
    y[i] = normalForce[i];
    x[2 * count - 1 - i] = time[i];
    y[2 * count - 1 - i] = -normalForce[i];
  }
  return {
    name: "plus and minus normal force",
    type: "scatter",
    mode: "lines",
    x,
    y,
    line: { width: 1.25 * theme.unit, color: theme.normalForce, dash: "5px,4px", simplify: false },
  };
}

/**
 * A number in a circle at each switch, moved aside where they would cover one another; where there
 * are too many for each to stand by its switch, the shading alone tells.
 * @param {ArrayLike<number>} times
 * @param {number} duration
 * @param {number} height
 * @param {number} pixelsPerTime
 * @param {import("../../figures/theme.js").Theme} theme
 */
function switchNumbers(times, duration, height, pixelsPerTime, theme) {
  const pixels = theme.unit * NUMBER_PIXELS;
  const gap = pixels / pixelsPerTime;
  const spread = spreadApart(times, gap, 0, duration) ?? [];
  const x = spread.every((place, i) => Math.abs(place - times[i]) < FARTHEST * gap) ? spread : [];
  return {
    name: "switches",
    type: "scatter",
    mode: "markers+text",
    x,
    y: x.map(() => height),
    text: x.map((_, i) => String(i + 1)),
    textfont: { size: 11 * theme.unit, color: theme.ink },
    marker: {
      size: pixels,
      color: theme.paper,
      line: { width: 1.25 * theme.unit, color: theme.ink },
    },
    cliponaxis: false,
  };
}
