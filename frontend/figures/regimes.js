// @ts-check

/**
 * @typedef {import("../api/client.js").Episode} Episode
 * @typedef {import("./theme.js").Theme} Theme
 */

/** The three things a contact does, in the order of the legend. */
export const REGIMES = /** @type {const} */ (["forward", "backward", "sticking"]);

/** @param {Episode} episode */
export function regimeOf({ regime, direction }) {
  if (regime === "sticking") {
    return "sticking";
  }
  return direction < 0 ? "backward" : "forward";
}

/**
 * Full-height shading of the two directions of sliding, each a trace of rectangles.
 * @param {Episode[]} episodes
 * @param {number} bottom
 * @param {number} top
 * @param {Theme} theme
 */
export function slidingShades(episodes, bottom, top, theme) {
  const colors = { forward: theme.slidingShade, backward: theme.slidingBackShade };
  return /** @type {const} */ (["forward", "backward"]).map((direction) => ({
    name: `sliding ${direction}`,
    type: "scatter",
    mode: "lines",
    ...rectangles(
      episodes.filter((episode) => regimeOf(episode) === direction),
      bottom,
      top,
    ),
    fill: "toself",
    fillcolor: colors[direction],
    line: { width: 0 },
  }));
}

/**
 * The ribbon that names the regimes: a thick line for each of the three.
 * @param {Episode[]} episodes
 * @param {number} height where it lies on the vertical axis
 * @param {number} thickness in px
 * @param {Theme} theme
 */
export function regimeRibbon(episodes, height, thickness, theme) {
  const colors = { forward: theme.sliding, backward: theme.slidingBack, sticking: theme.sticking };
  return REGIMES.map((regime) => {
    /** @type {(number | null)[]} */
    const x = [];
    for (const episode of episodes) {
      if (regimeOf(episode) === regime) {
        x.push(episode.start, episode.end, null);
      }
    }
    return {
      name: `ribbon ${regime}`,
      type: "scatter",
      mode: "lines",
      x,
      y: x.map((time) => (time === null ? null : height)),
      line: { width: thickness, color: colors[regime] },
    };
  });
}

const WORDS = {
  forward: ["slides →", "→"],
  backward: ["← slides", "←"],
  sticking: ["sticks", ""],
};

/**
 * The words on the ribbon, where there is room for them.
 * @param {Episode[]} episodes
 * @param {number} height
 * @param {number} pixelsPerTime
 * @param {Theme} theme
 */
export function ribbonWords(episodes, height, pixelsPerTime, theme) {
  const placed = episodes.map((episode) => {
    const room = (episode.end - episode.start) * pixelsPerTime;
    const [word, sign] = WORDS[regimeOf(episode)];
    const text = room > 72 ? word : sign;
    return { x: (episode.start + episode.end) / 2, text: room > 30 ? text : "" };
  });
  const shown = placed.filter(({ text }) => text !== "");
  return {
    name: "ribbon words",
    type: "scatter",
    mode: "text",
    x: shown.map(({ x }) => x),
    y: shown.map(() => height),
    text: shown.map(({ text }) => text),
    textfont: { size: 11, color: theme.onRegime },
    cliponaxis: false,
  };
}

/**
 * @param {Episode[]} episodes
 * @param {number} bottom
 * @param {number} top
 */
function rectangles(episodes, bottom, top) {
  /** @type {(number | null)[]} */
  const x = [];
  /** @type {(number | null)[]} */
  const y = [];
  for (const { start, end } of episodes) {
    x.push(start, end, end, start, start, null);
    y.push(bottom, bottom, top, top, bottom, null);
  }
  return { x, y };
}
