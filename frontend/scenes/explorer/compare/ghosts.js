// @ts-check

import { say } from "../../../format/words.js";
import { clamp } from "../../../state/scales.js";
import { reachOf } from "../reach.js";
import { DASHES, inALine, letterAt } from "./pinned.js";

/** @typedef {import("./pinned.js").Pinned} Pinned */
/** @typedef {import("../../../figures/theme.js").Theme} Theme */

const LETTER_PIXELS = 15;

/** Where along its contact a line has its letter: those of collisions that resemble one another stand apart. */
const LETTER_SHARES = [0.2, 0.36, 0.52];

/** Where what is beyond the axes lies. */
const SIDEWAYS = ["←", "", "→"];
const UPWARDS = ["↓", "", "↑"];

/**
 * What is pinned, for the pictures of the present collision.
 * @param {Pinned[]} pinned
 * @returns {import("../ghosts.js").Ghosts}
 */
export function createGhosts(pinned) {
  const drawn = pinned.flatMap((pin) => {
    const trace = pin.loaded?.trace;
    return trace ? [{ ...pin, trace }] : [];
  });
  const placed = pinned.flatMap(({ index, collision, loaded }) =>
    loaded ? [{ index, collision, epsilon_t: loaded.result.epsilon_t }] : [],
  );
  return {
    ...reachOf(drawn.map(({ trace }) => trace)),

    lines: (column, theme, factor = 1) =>
      drawn.map(({ index, trace }) => ({
        name: `pinned ${letterAt({ index })}`,
        type: "scatter",
        mode: "lines",
        x: trace.time,
        // The very array, so that a drag finds it drawn already.
        y: factor === 1 ? trace[column] : trace[column].map((value) => factor * value),
        line: {
          width: 1.75 * theme.unit,
          color: colorsOf(theme)[index],
          dash: DASHES[index],
          simplify: false,
        },
      })),

    letters(column, theme, factor = 1) {
      const marked = drawn.map(({ index, trace }) => {
        const instant = LETTER_SHARES[index] * trace.contact_duration;
        const at = trace.time.findIndex((time) => time >= instant);
        const text = letterAt({ index });
        return { index, x: trace.time[at], y: factor * trace[column][at], text };
      });
      return letterMarks(marked, theme);
    },

    marks(placeOf, { layout }, theme) {
      const [bottom, top] = layout.yaxis.range;
      const marked = placed.map((ghost) => {
        const { x, y, beyond } = placeOf(ghost);
        const arrows = `${SIDEWAYS[beyond.x + 1]}${UPWARDS[beyond.y + 1]}`;
        return {
          index: ghost.index,
          x: clamp(x),
          y: bottom + clamp(y) * (top - bottom),
          text: `${letterAt(ghost)}${arrows}`,
        };
      });
      return letterMarks(marked, theme);
    },

    tables: (tableOf) =>
      drawn.map(({ trace, ...pin }) => {
        const { caption, ...table } = tableOf(trace);
        const values = { letter: letterAt(pin), collision: inALine(pin.collision), caption };
        return { ...table, caption: say("compare.captionOf", values) };
      }),
  };
}

/** @param {Theme} theme */
function colorsOf({ pinA, pinB, pinC }) {
  return [pinA, pinB, pinC];
}

/**
 * Letters in rings; none where there are no places, for Plotly leaves out a trace without any.
 * @param {{index: number, x: number, y: number, text: string}[]} marked
 * @param {Theme} theme
 */
function letterMarks(marked, theme) {
  const colors = marked.map(({ index }) => colorsOf(theme)[index]);
  const trace = {
    name: "letters of what is pinned",
    type: "scatter",
    mode: "markers+text",
    hoverinfo: "skip",
    x: marked.map(({ x }) => x),
    y: marked.map(({ y }) => y),
    text: marked.map(({ text }) => text),
    textfont: { size: 10 * theme.unit, color: colors },
    marker: {
      size: LETTER_PIXELS * theme.unit,
      color: theme.paper,
      line: { width: 1.5 * theme.unit, color: colors },
    },
    cliponaxis: false,
  };
  return marked.length > 0 ? [trace] : [];
}
