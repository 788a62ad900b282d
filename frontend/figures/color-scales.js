// @ts-check

/**
 * Colours for ε_t from −1 to 1, safe for the colour-blind: close to Crameri's vik (light) and berlin
 * (dark), so that zero takes the colour of the page.
 */
const DIVERGING = {
  light: [
    "#04205f",
    "#0d4a82",
    "#3f86b0",
    "#96c0d5",
    "#f3efe8",
    "#e3b595",
    "#c67d50",
    "#963c10",
    "#5a0a05",
  ],
  dark: [
    "#b4c4ff",
    "#7bade8",
    "#3f86b5",
    "#1f4f6e",
    "#191c22",
    "#5f2d17",
    "#a1533a",
    "#d78a7b",
    "#ffc3bd",
  ],
};

/** Colours for switch counts, from none to many. */
const COUNTING = {
  light: [
    "#f1ede3",
    "#d5e5c4",
    "#a3d4b4",
    "#63b8b3",
    "#3493b0",
    "#2b6ca3",
    "#2e4b8c",
    "#2b2e66",
    "#1a173c",
  ],
  dark: [
    "#1f242b",
    "#2d3162",
    "#33528c",
    "#2f7894",
    "#2f9c8e",
    "#5bbc77",
    "#a2d25c",
    "#e0df62",
    "#fdf6b0",
  ],
};

/** Colours for errors, from none, the colour of the page, to as large as ε_t itself. */
const FAILING = {
  light: ["#f6f2ea", "#f4dcae", "#eeb37a", "#dd7f5e", "#b94a55", "#7e264f", "#3b1136"],
  dark: ["#191c22", "#33213f", "#6a2a58", "#a53a5a", "#da5f4e", "#f3a053", "#fbe6a0"],
};

/** @param {boolean} dark */
export function errorColors(dark) {
  return FAILING[dark ? "dark" : "light"];
}

/**
 * Stops [share, colour] from the least error to the largest.
 * @param {boolean} dark
 * @returns {[number, string][]}
 */
export function errorStops(dark) {
  const colors = errorColors(dark);
  return colors.map((color, i) => [i / (colors.length - 1), color]);
}

/**
 * How much of the colours is spent at |ε_t|: its root, for most of the map lies near zero.
 * @param {number} epsilon
 */
function spent(epsilon) {
  return Math.sign(epsilon) * Math.sqrt(Math.abs(epsilon));
}

/**
 * Stops [share, colour] over −1 … 1.
 * @param {boolean} dark
 * @returns {[number, string][]}
 */
export function restitutionStops(dark) {
  const colors = DIVERGING[dark ? "dark" : "light"];
  // As many stops as make the bends of the root invisible.
  return Array.from({ length: 65 }, (_, i) => {
    const place = i / 32 - 1;
    const epsilon = Math.sign(place) * place * place;
    return [(epsilon + 1) / 2, between(colors, (spent(epsilon) + 1) / 2)];
  });
}

/**
 * Where a value of ε_t lies along a legend of these colours drawn with even spending, 0 … 1.
 * @param {number} epsilon
 */
export function restitutionPlace(epsilon) {
  return (spent(epsilon) + 1) / 2;
}

/** @param {boolean} dark */
export function restitutionColors(dark) {
  return DIVERGING[dark ? "dark" : "light"];
}

/**
 * The classes of switch counts on a map: 0, 2, 4 … up to the largest, the ninth being "and more"; with
 * damping, where counts are odd, 1, 3, 5 ….
 * @param {number} most
 * @param {boolean} dark
 */
export function switchClasses(most, dark) {
  const colors = COUNTING[dark ? "dark" : "light"];
  const least = most % 2;
  const count = Math.min(colors.length, Math.floor(most / 2) + 1);
  return Array.from({ length: count }, (_, i) => {
    const switches = least + 2 * i;
    return {
      switches,
      label: i === colors.length - 1 && most > switches ? `≥ ${switches}` : String(switches),
      color: between(colors, count === 1 ? 0 : i / Math.max(4, count - 1)),
    };
  });
}

/**
 * A colour scale in steps of two switches, from one less than the first class to one more than the last.
 * @param {{color: string}[]} classes
 * @returns {[number, string][]}
 */
export function switchStops(classes) {
  return classes.flatMap(({ color }, i) => [
    /** @type {[number, string]} */ ([i / classes.length, color]),
    /** @type {[number, string]} */ ([(i + 1) / classes.length, color]),
  ]);
}

/**
 * @param {string[]} colors
 * @param {number} share
 */
function between(colors, share) {
  const place = share * (colors.length - 1);
  const i = Math.min(colors.length - 2, Math.floor(place));
  const [a, b] = [colors[i], colors[i + 1]].map(channels);
  const mixed = a.map((value, k) => Math.round(value + (place - i) * (b[k] - value)));
  return `#${mixed.map((value) => value.toString(16).padStart(2, "0")).join("")}`;
}

/** Red, green and blue, 0 … 255. @param {string} color as #rrggbb */
export function channels(color) {
  return [1, 3, 5].map((at) => Number.parseInt(color.slice(at, at + 2), 16));
}
