// @ts-check

import { withFonts } from "./embedded-fonts.js";

/** A bitmap for a slide: so many pixels to one of the page. */
const BITMAP_SCALE = 3;

/**
 * A picture as it is drawn, still without its fonts.
 * @typedef {object} Drawn
 * @property {string} svg
 * @property {{width: number, height: number}} size
 */

/**
 * The same with its fonts, as files.
 * @param {Drawn} drawn
 * @param {(address: string) => Promise<Blob>} loadFont
 */
export async function filesOf({ svg, size }, loadFont) {
  const whole = await withFonts(svg, loadFont);
  return {
    svg: async () => new Blob([whole], { type: "image/svg+xml" }),
    png: () => bitmapOf(`data:image/svg+xml,${encodeURIComponent(whole)}`, size),
  };
}

/**
 * @param {string} picture
 * @param {{width: number, height: number}} size
 * @returns {Promise<Blob>}
 */
async function bitmapOf(picture, { width, height }) {
  const image = new Image();
  image.src = picture;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = BITMAP_SCALE * width;
  canvas.height = BITMAP_SCALE * height;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return new Promise((resolve, reject) => {
    canvas.toBlob((blob) => (blob ? resolve(blob) : reject(new Error("no bitmap"))), "image/png");
  });
}
