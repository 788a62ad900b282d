// @ts-check

/**
 * Tells the browser of every drawn canvas that it will be read back. To set type in depth Plotly reads
 * its letters from one without having said so, of which browsers complain in the console.
 */
export function announceCanvasReading() {
  const { getContext } = HTMLCanvasElement.prototype;
  /** @this {HTMLCanvasElement} @param {string} kind @param {any} [options] */
  function getReadableContext(kind, options) {
    const wanted = kind === "2d" ? { willReadFrequently: true, ...options } : options;
    return getContext.call(this, kind, wanted);
  }
  HTMLCanvasElement.prototype.getContext = /** @type {any} */ (getReadableContext);
}
