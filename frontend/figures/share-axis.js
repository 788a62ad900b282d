// @ts-check

import { alphaInWords, brief, powerOfTen } from "../format/number.js";
import { PLOT_SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import { plainAxis } from "./plot-area.js";

/** @typedef {import("../state/scales.js").Scale} Scale */

/**
 * An axis that runs over the shares of a scale, 0 … 1, so that only its ticks tell the values.
 * @param {import("./theme.js").Theme} theme
 * @param {Scale} scale
 * @param {"linear" | "log"} kind
 */
export function shareAxis(theme, scale, kind) {
  const { tickvals, ticktext } = shareTicks(scale, kind);
  return plainAxis(theme, [0, 1], tickvals, ticktext);
}

/**
 * What a horizontal axis is; ακ says of which α.
 * @param {{symbol: keyof typeof PLOT_SYMBOLS, alpha?: number}} axis
 */
export function horizontalName({ symbol, alpha }) {
  if (alpha === undefined) {
    return PLOT_SYMBOLS[symbol];
  }
  const value = alphaInWords(alpha);
  return say(value === "2/7" ? "map.withAlphaOfSpheres" : "map.withAlpha", {
    axis: PLOT_SYMBOLS[symbol],
    alpha: "<i>α</i>",
    value,
  });
}

/**
 * @param {Scale} scale
 * @param {"linear" | "log"} kind
 */
export function shareTicks(scale, kind) {
  const values = kind === "log" ? decades(scale) : evenTicks(scale);
  return {
    tickvals: values.map((value) => scale.toShare(value)),
    ticktext: values.map((value) =>
      // "10000" would lie on its neighbours.
      kind === "log" && value >= 1e4 ? powerOfTen(Math.round(Math.log10(value))) : brief(value),
    ),
  };
}

/** @param {Scale} scale */
function decades({ min, max }) {
  const first = Math.ceil(Math.log10(min) - 1e-9);
  const last = Math.floor(Math.log10(max) + 1e-9);
  const every = Math.ceil((last - first + 1) / 7);
  const count = Math.floor((last - first) / every) + 1;
  return Array.from({ length: count }, (_, i) => Number(`1e${first + every * i}`));
}

/** @param {Scale} scale */
function evenTicks({ min, max }) {
  const rough = (max - min) / 6;
  const decade = 10 ** Math.floor(Math.log10(rough));
  const step = ([1, 2, 5, 10].find((factor) => factor * decade >= rough) ?? 10) * decade;
  const count = Math.floor(max / step + 1e-9);
  const rounds = Array.from({ length: count }, (_, i) => Number(((i + 1) * step).toPrecision(12)));
  return [min, ...rounds.filter((value) => value - min > step / 2)];
}
