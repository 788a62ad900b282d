// @ts-check

/**
 * A line that says something for as long as it is true, and is not there otherwise.
 * @param {HTMLElement} element
 */
export function mountMessage(element) {
  return {
    /** @param {string} text */
    say(text) {
      element.textContent = text;
    },
    clear() {
      element.textContent = "";
    },
  };
}
