// @ts-check

/**
 * Writes a text, unless it stands there already: most steps of a drag change nothing.
 * @param {Element} element
 * @param {string} text
 */
export function write(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}
