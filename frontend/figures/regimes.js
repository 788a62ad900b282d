// @ts-check

/**
 * @typedef {import("../api/client.js").Episode} Episode
 * @typedef {import("./theme.js").Theme} Theme
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
const ROOM_FOR_WORD = 72;
const ROOM_FOR_SIGN = 30;

/** @param {Episode} episode */
export function regimeOf({ regime, direction }) {
  if (regime === "sticking") {
    return "sticking";
  }
  return direction < 0 ? "backward" : "forward";
}

/**
 * The regimes as bars along the axis of time: each episode's shade and, above it, its piece of the
 * ribbon that names it. One trace for all of them, for each costs a millisecond of every frame.
 * @param {Episode[]} episodes
 * @param {Extent} shade
 * @param {Extent | null} ribbon
 * @param {number} pixelsPerTime
 * @param {Theme} theme
 */
export function regimeBars(episodes, shade, ribbon, pixelsPerTime, theme) {
  const shades = {
    forward: theme.slidingShade,
    backward: theme.slidingBackShade,
    sticking: "rgba(0,0,0,0)",
  };
  const solids = {
    forward: theme.sliding,
    backward: theme.slidingBack,
    sticking: theme.sticking,
  };
  /** @type {{extent: Extent, colors: typeof solids, text: (episode: Episode) => string}[]} */
  const rows = [{ extent: shade, colors: shades, text: () => "" }];
  if (ribbon) {
    rows.push({
      extent: ribbon,
      colors: solids,
      text: (episode) => words(episode, pixelsPerTime / theme.unit),
    });
  }
  /** @param {(episode: Episode, row: (typeof rows)[number]) => any} read */
  const each = (read) => rows.flatMap((row) => episodes.map((episode) => read(episode, row)));
  return {
    name: "regimes",
    type: "bar",
    x: each(({ start, end }) => (start + end) / 2),
    width: each(({ start, end }) => end - start),
    base: each((_, { extent }) => extent.base),
    y: each((_, { extent }) => extent.top - extent.base),
    marker: {
      color: each((episode, { colors }) => colors[regimeOf(episode)]),
      line: { width: 0 },
    },
    text: each((episode, row) => row.text(episode)),
    textposition: "inside",
    insidetextanchor: "middle",
    insidetextfont: { size: 11 * theme.unit, color: theme.onRegime },
    textangle: 0,
    constraintext: "none",
  };
}

/**
 * @param {Episode} episode
 * @param {number} pixelsPerTime of the design
 */
function words(episode, pixelsPerTime) {
  const room = (episode.end - episode.start) * pixelsPerTime;
  const { word, sign } = WORDS[regimeOf(episode)];
  if (room > ROOM_FOR_WORD) {
    return word;
  }
  return room > ROOM_FOR_SIGN ? sign : SPACE;
}
