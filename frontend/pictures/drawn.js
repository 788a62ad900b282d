// @ts-check

import { download } from "./download.js";
import { withFonts } from "./embedded-fonts.js";

/** A bitmap for a slide: so many pixels to one of the page. */
const BITMAP_SCALE = 3;

/**
 * @typedef {object} Saving
 * @property {"png" | "svg"} format
 * @property {string} fileName
 * @property {(address: string) => Promise<Blob>} loadFont
 */

/**
 * Gives the reader a picture that is drawn, as it is or as a bitmap, with its fonts.
 * @param {string} svg
 * @param {{width: number, height: number}} size
 * @param {Saving} saving
 */
export async function downloadDrawn(svg, size, { format, fileName, loadFont }) {
  const picture = `data:image/svg+xml,${encodeURIComponent(await withFonts(svg, loadFont))}`;
  download(format === "svg" ? picture : await bitmapOf(picture, size), fileName);
}

/**
 * @param {string} picture
 * @param {{width: number, height: number}} size
 */
async function bitmapOf(picture, { width, height }) {
  const image = new Image();
  image.src = picture;
  await image.decode();
  const canvas = document.createElement("canvas");
  canvas.width = BITMAP_SCALE * width;
  canvas.height = BITMAP_SCALE * height;
  canvas.getContext("2d")?.drawImage(image, 0, 0, canvas.width, canvas.height);
  return canvas.toDataURL("image/png");
}
