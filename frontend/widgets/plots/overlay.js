// @ts-check

/**
 * Lays an element over the frame of the plot beside it, to the fraction of a pixel: Plotly draws in
 * whole pixels and leaves the rest of its place empty, as `noteRest` knows.
 * @param {HTMLElement} element
 * @param {{l: number, r: number, t: number, b: number}} margin of the plot, in pixels of the design
 */
export function layOver(element, { l, r, t, b }) {
  const below = `${rem(b)} * var(--words-in-pictures, 1)`;
  const sides = {
    left: rem(l),
    right: withRest(rem(r), "x"),
    top: rem(t),
    bottom: withRest(below, "y"),
  };
  for (const [side, length] of Object.entries(sides)) {
    element.style.setProperty(side, length);
  }
}

/**
 * The whole pixels of a plot's place; what is laid over it learns of the rest.
 * @param {HTMLElement} element of the plot
 * @param {import("../../figures/plot-area.js").Size} place
 */
export function noteRest(element, place) {
  const [width, height] = [Math.floor(place.width), Math.floor(place.height)];
  const stage = element.parentElement;
  stage?.style.setProperty("--rest-x", `${place.width - width}px`);
  stage?.style.setProperty("--rest-y", `${place.height - height}px`);
  return { width, height };
}

/** @param {number} pixels */
function rem(pixels) {
  return `${pixels / 16}rem`;
}

/**
 * @param {string} length
 * @param {"x" | "y"} along
 */
function withRest(length, along) {
  return `calc(${length} + var(--rest-${along}, 0px))`;
}
