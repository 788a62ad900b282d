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
import { regimeRibbon, regimeShades } from "./regimes.js";

const RIBBON_PIXELS = 18;
const NUMBER_PIXELS = 15;
/** How far a number may stand from its switch, in widths of a number. */
const FARTHEST = 2.5;

/**
 * The force trace of Fig. 5: F_t/μ between ±F_n, the regimes shaded, the switches numbered.
 * @param {import("../../api/answers.js").Trace} trace
 * @param {import("../../figures/theme.js").Theme} theme
 * @param {import("../../figures/plot-area.js").Size} size
 * @returns {import("../../figures/plot-area.js").Figure}
 */
export function forceFigure(trace, theme, size) {
  const { time, normal_force: normalForce, episodes, contact_duration: duration } = trace;
  const reach = forceReach(normalForce);
  const { unit } = theme;
  const inner = innerSize(size, TRACE_MARGIN, theme);
  // The ribbon takes its pixels above the forces, whatever the height of the plot.
  const perPixel = (2 * reach) / Math.max(1, inner.height - unit * RIBBON_PIXELS);
  const top = reach + unit * RIBBON_PIXELS * perPixel;
  const pixelsPerTime = inner.width / duration;
  const numbers = switchNumbers(
    trace.switch_times,
    duration,
    (reach + top) / 2,
    pixelsPerTime,
    theme,
  );
  const ribbon = { base: reach + unit * perPixel, top: top - unit * perPixel };
  return {
    data: [
      regimeShades(episodes, { base: -reach, top: reach }, theme),
      regimeRibbon(episodes, ribbon, numbers.x, pixelsPerTime, theme),
      envelope(time, normalForce, theme),
      {
        name: "tangential force / mu",
        type: "scatter",
        mode: "lines",
        x: time,
        y: trace.tangential_force_over_mu,
        line: { width: 2.25 * unit, color: theme.tangentialForce, simplify: false },
      },
      numbers,
    ],
    layout: {
      ...baseLayout(theme, size, TRACE_MARGIN),
      xaxis: timeAxis(theme, duration),
      yaxis: {
        ...plainAxis(theme, [-reach, top], [-1, 0, 1], ["−1", "0", "1"]),
        zeroline: true,
        zerolinecolor: theme.grid,
        zerolinewidth: 1,
      },
    },
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
    textfont: { size: 10 * theme.unit, color: theme.ink },
    marker: {
      size: pixels,
      color: theme.paper,
      line: { width: 1.25 * theme.unit, color: theme.ink },
    },
    cliponaxis: false,
  };
}
