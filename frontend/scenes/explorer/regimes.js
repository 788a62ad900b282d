// @ts-check

/**
 * @typedef {import("../../api/answers.js").Episode} Episode
 * @typedef {import("../../figures/theme.js").Theme} Theme
 * @typedef {{base: number, top: number}} Extent on the vertical axis
 */

/** A piece of ribbon without a word has a space, so that a word can come to stand there. */
const SPACE = "\u00a0";

/** What is written on the ribbon where there is room, and where there is a little. */
const WORDS = {
  forward: { word: "slides →", sign: "→" },
  backward: { word: "← slides", sign: "←" },
  sticking: { word: "sticks", sign: SPACE },
};
const ROOM_FOR_WORD = 82;
const ROOM_FOR_SIGN = 30;

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
 * Each episode of sliding shaded over the height of the plot.
 * @param {Episode[]} episodes
 * @param {Extent} extent
 * @param {Theme} theme
 */
export function regimeShades(episodes, extent, theme) {
  const colors = {
    forward: theme.slidingShade,
    backward: theme.slidingBackShade,
    sticking: "rgba(0,0,0,0)",
  };
  return { name: "regimes", ...bars(episodes, extent, colors) };
}

/**
 * The ribbon that gives each episode the colour of its regime and, where there is room, its name.
 * @param {Episode[]} episodes
 * @param {Extent} extent
 * @param {number[]} marks where something lies on it, in time
 * @param {number} pixelsPerTime
 * @param {Theme} theme
 */
export function regimeRibbon(episodes, extent, marks, pixelsPerTime, theme) {
  const colors = {
    forward: theme.sliding,
    backward: theme.slidingBack,
    sticking: theme.sticking,
  };
  return {
    name: "ribbon",
    ...bars(episodes, extent, colors),
    text: episodes.map((episode) => words(episode, marks, pixelsPerTime / theme.unit)),
    textposition: "inside",
    insidetextanchor: "middle",
    insidetextfont: { size: 11 * theme.unit, color: theme.onRegime },
    textangle: 0,
    constraintext: "none",
  };
}

/**
 * Bars along the axis of time: one trace for all regimes, for each costs a millisecond of a frame.
 * @param {Episode[]} episodes
 * @param {Extent} extent
 * @param {Record<ReturnType<typeof regimeOf>, string>} colors
 */
function bars(episodes, { base, top }, colors) {
  return {
    type: "bar",
    x: episodes.map(({ start, end }) => (start + end) / 2),
    width: episodes.map(({ start, end }) => end - start),
    base: episodes.map(() => base),
    y: episodes.map(() => top - base),
    marker: {
      color: episodes.map((episode) => colors[regimeOf(episode)]),
      line: { width: 0 },
    },
  };
}

/**
 * @param {Episode} episode
 * @param {number[]} marks
 * @param {number} pixelsPerTime of the design
 */
function words(episode, marks, pixelsPerTime) {
  const middle = (episode.start + episode.end) / 2;
  const free = [episode.end, ...marks].map((place) => Math.abs(place - middle));
  const room = 2 * Math.min(...free) * pixelsPerTime;
  const { word, sign } = WORDS[regimeOf(episode)];
  if (room > ROOM_FOR_WORD) {
    return word;
  }
  return room > ROOM_FOR_SIGN ? sign : SPACE;
}
