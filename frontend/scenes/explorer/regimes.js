// @ts-check

import { say } from "../../format/words.js";

/**
 * @typedef {import("../../api/answers.js").Episode} Episode
 * @typedef {import("../../api/answers.js").Trace} Trace
 * @typedef {import("../../figures/theme.js").Theme} Theme
 * @typedef {{base: number, top: number}} Extent on the vertical axis
 */

/**
 * A piece of the contact that is drawn as one: an episode, or many that are too brief to be told apart.
 * @typedef {object} Piece
 * @property {number} start
 * @property {number} end
 * @property {"forward" | "backward" | "sticking" | "many"} kind
 * @property {number} switches within it
 */

/** A piece of ribbon without a word has a space, so that a word can come to stand there. */
export const SPACE = "\u00a0";

/** What is written on the ribbon: the first that has room, or where there is a little, a sign. */
const NAMES = {
  forward: { keys: ["regimes.forward"], sign: "→" },
  backward: { keys: ["regimes.backward"], sign: "←" },
  sticking: { keys: ["regimes.sticks"], sign: SPACE },
  many: { keys: ["regimes.manyTooBrief", "regimes.many"], sign: "…" },
};
const ROOM_FOR_SIGN = 30;

/** The pixels of the design that a text wants: some languages say at length what others say in a word. */
const roomFor = (/** @type {string} */ text) => 38 + 5.5 * text.length;

/** Two episodes in fewer pixels of the design are a pattern that shimmers. */
const LEAST_PIXELS = 8;

/**
 * @param {Episode} episode
 * @returns {"forward" | "backward" | "sticking"}
 */
export function regimeOf({ regime, direction }) {
  if (regime === "sticking") {
    return "sticking";
  }
  return direction < 0 ? "backward" : "forward";
}

/**
 * The whole contact in pieces that can be drawn. The list of episodes may end before it: they are many.
 * @param {Trace} trace
 * @param {number} pixelsPerTime of the design
 * @returns {Piece[]}
 */
export function regimePieces(trace, pixelsPerTime) {
  const { episodes, contact_duration: duration, switch_times: switches } = trace;
  const isBrief = (/** @type {number} */ i) =>
    i >= 0 &&
    i + 1 < episodes.length &&
    (episodes[i + 1].end - episodes[i].start) * pixelsPerTime < LEAST_PIXELS;
  /** @type {Omit<Piece, "switches">[]} */
  const pieces = [];
  const add = (/** @type {Omit<Piece, "switches">} */ piece) => {
    const last = pieces.at(-1);
    if (last?.kind === "many" && piece.kind === "many") {
      last.end = piece.end;
    } else {
      pieces.push(piece);
    }
  };
  for (const [i, episode] of episodes.entries()) {
    const { start, end } = episode;
    add({ start, end, kind: isBrief(i - 1) || isBrief(i) ? "many" : regimeOf(episode) });
  }
  const told = episodes.at(-1)?.end ?? 0;
  if (told < duration) {
    add({ start: told, end: duration, kind: "many" });
  }
  return pieces.map((piece) => ({
    ...piece,
    switches: switches.filter((time) => time >= piece.start && time <= piece.end).length,
  }));
}

/**
 * Each piece of sliding shaded over the height of the plot.
 * @param {Piece[]} pieces
 * @param {Extent} extent
 * @param {Theme} theme
 */
export function regimeShades(pieces, extent, theme) {
  const colors = {
    forward: theme.slidingShade,
    backward: theme.slidingBackShade,
    sticking: "rgba(0,0,0,0)",
    many: theme.manyShade,
  };
  return { name: "regimes", ...bars(pieces, extent, colors) };
}

/**
 * The ribbon that gives each piece the colour of its regime and, where there is room, its name.
 * @param {Piece[]} pieces
 * @param {Extent} extent
 * @param {number[]} marks where something lies on it, in time
 * @param {number} pixelsPerTime
 * @param {Theme} theme
 */
export function regimeRibbon(pieces, extent, marks, pixelsPerTime, theme) {
  const colors = {
    forward: theme.sliding,
    backward: theme.slidingBack,
    sticking: theme.sticking,
    many: theme.many,
  };
  return {
    name: "ribbon",
    ...bars(pieces, extent, colors),
    text: pieces.map((piece) => words(piece, marks, pixelsPerTime / (theme.unit * theme.words))),
    textposition: "inside",
    insidetextanchor: "middle",
    insidetextfont: { size: 11 * theme.unit * theme.words, color: theme.onRegime },
    textangle: 0,
    constraintext: "none",
  };
}

/**
 * Bars along the axis of time: one trace for all regimes, for each costs a millisecond of a frame.
 * @param {Piece[]} pieces
 * @param {Extent} extent
 * @param {Record<Piece["kind"], string>} colors
 */
function bars(pieces, { base, top }, colors) {
  return {
    type: "bar",
    x: pieces.map(({ start, end }) => (start + end) / 2),
    width: pieces.map(({ start, end }) => end - start),
    base: pieces.map(() => base),
    y: pieces.map(() => top - base),
    marker: { color: pieces.map(({ kind }) => colors[kind]), line: { width: 0 } },
  };
}

/**
 * @param {Piece} piece
 * @param {number[]} marks
 * @param {number} pixelsPerTime of the design
 */
function words({ start, end, kind, switches }, marks, pixelsPerTime) {
  const middle = (start + end) / 2;
  const free = [end, ...marks].map((place) => Math.abs(place - middle));
  const room = 2 * Math.min(...free) * pixelsPerTime;
  const { keys, sign } = NAMES[kind];
  const texts = keys.map((key) => say(key, { count: switches }));
  const fitting = texts.find((text) => room > roomFor(text));
  return fitting ?? (room > ROOM_FOR_SIGN ? sign : SPACE);
}
