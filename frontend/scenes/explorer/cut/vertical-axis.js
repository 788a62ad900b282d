// @ts-check

import { axisTitle, plainAxis } from "../../../figures/plot-area.js";
import { brief, powerOfTen } from "../../../format/number.js";
import { PLOT_SYMBOLS } from "../../../format/symbols.js";

/**
 * How ε_t is laid along the vertical axis of the cut: as it is, or the logarithm of its magnitude.
 * @typedef {object} VerticalAxis
 * @property {(value: number) => number} place of a value, in the numbers of `range`
 * @property {(value: number) => number} share of the range, below 0 for what is smaller than the floor
 * @property {number} floor what nothing is drawn below, in the same numbers
 * @property {[number, number]} range with room below the floor for ribbon and letters
 * @property {number} perPixel
 * @property {Record<string, any>} layout
 */

const TICKS = [-1, -0.5, 0, 0.5, 1];

/** A logarithmic axis reaches down to where a tenth of the curve is smaller, three decades at least. */
const DEEP_SHARE = 0.1;
const SHALLOWEST = -3;
const DEEPEST = -15;
const MOST_TICKS = 5;

/**
 * @param {"linear" | "log"} kind
 * @param {Float64Array} values the curve for which a logarithmic axis is made
 * @param {number} height
 * @param {number} below pixels for ribbon and letters
 * @param {import("../../../figures/theme.js").Theme} theme
 * @returns {VerticalAxis}
 */
export function verticalAxis(kind, values, height, below, theme) {
  const isLog = kind === "log";
  const floor = isLog ? deepest(values) : -1;
  const ceiling = isLog ? -0.02 * floor : 1.04;
  const perPixel = (ceiling - floor) / Math.max(1, height - below);
  /** @type {[number, number]} */
  const range = [floor - below * perPixel, ceiling];
  const every = Math.ceil(-floor / MOST_TICKS);
  const powers = Array.from({ length: Math.floor(-floor / every) + 1 }, (_, i) => -i * every);
  const plain = (/** @type {number} */ value) => (isLog ? Math.log10(Math.abs(value)) : value);
  return {
    share(value) {
      const at = plain(value);
      return isLog && at < floor ? -1 : (at - range[0]) / (ceiling - range[0]);
    },
    place: (value) => (isLog ? Math.max(floor, plain(value)) : value),
    floor,
    range,
    perPixel,
    layout: {
      ...(isLog
        ? plainAxis(theme, range, powers, powers.map(tickOf))
        : plainAxis(theme, range, TICKS, TICKS.map(brief))),
      title: axisTitle(isLog ? `|${PLOT_SYMBOLS.epsilon_t}|` : PLOT_SYMBOLS.epsilon_t, 2, theme),
      zeroline: true,
      zerolinecolor: theme.grid,
      zerolinewidth: 1,
    },
  };
}

/** @param {number} power */
function tickOf(power) {
  return power === 0 ? "1" : powerOfTen(power);
}

/** @param {Float64Array} values */
function deepest(values) {
  const magnitudes = values.map(Math.abs).filter((value) => value > 0);
  const small = magnitudes.sort()[Math.floor(DEEP_SHARE * magnitudes.length)] ?? 1;
  return Math.max(DEEPEST, Math.min(SHALLOWEST, Math.floor(Math.log10(small))));
}
