// @ts-check

import { channels } from "./color-scales.js";

/**
 * A heat map as Plotly makes an image of it: a pixel for each of its values, stretched over their
 * cells. Rows go up in the trace and down in the image.
 *
 * @typedef {object} HeatMap
 * @property {ArrayLike<number>[]} z
 * @property {number} x0
 * @property {number} dx
 * @property {number} y0
 * @property {number} dy
 * @property {number} zmin
 * @property {number} zmax
 * @property {[number, string][]} colorscale shares of the range and their colours, the first at 0, the last at 1
 */

/**
 * Red, green, blue and opacity of every pixel; what is not a number is not seen.
 * @param {HeatMap} map
 */
export function heatPixels({ z, zmin, zmax, colorscale }) {
  const columns = z[0].length;
  const pixels = new Uint8ClampedArray(4 * columns * z.length);
  const places = Float64Array.from(colorscale, ([place]) => zmin + place * (zmax - zmin));
  const colors = colorscale.map(([, color]) => channels(color));
  z.forEach((row, i) => {
    const start = 4 * columns * (z.length - 1 - i);
    for (let k = 0; k < columns; k += 1) {
      if (!Number.isNaN(row[k])) {
        const value = Math.min(zmax, Math.max(zmin, row[k]));
        const after = Math.max(1, firstBeyond(places, value));
        const [from, to] = [places[after - 1], places[after]];
        const share = to > from ? (value - from) / (to - from) : 1;
        for (let c = 0; c < 3; c += 1) {
          const [a, b] = [colors[after - 1][c], colors[after][c]];
          pixels[start + 4 * k + c] = a + share * (b - a);
        }
        pixels[start + 4 * k + 3] = 255;
      }
    }
  });
  return pixels;
}

/**
 * The image's place; its size is in whole pixels, as Plotly's. The middles of its outermost cells are its first and last values.
 * @param {HeatMap} map
 * @param {import("./pixels.js").PixelScale} scale
 */
export function heatPlace({ z, x0, dx, y0, dy }, scale) {
  const x = scale.x(x0 - dx / 2);
  const y = scale.y(y0 + (z.length - 0.5) * dy);
  return {
    x,
    y,
    width: Math.round(scale.x(x0 + (z[0].length - 0.5) * dx) - x),
    height: Math.round(scale.y(y0 - dy / 2) - y),
  };
}

/**
 * The index of the first stop that lies beyond a value, or the last one.
 * @param {Float64Array} places in order
 * @param {number} value
 */
function firstBeyond(places, value) {
  let [low, high] = [0, places.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    [low, high] = places[middle] > value ? [low, middle] : [middle + 1, high];
  }
  return low;
}
