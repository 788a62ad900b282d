// @ts-check

/** What this browser keeps of the page for the next visit, if it keeps anything. */
const PREFIX = "restitution.";

/**
 * @param {string} name
 * @returns {string | null} nothing, too, where a page may not keep anything, as in a sandboxed frame
 */
export function recall(name) {
  try {
    return localStorage.getItem(PREFIX + name);
  } catch {
    return null;
  }
}

/**
 * @param {string} name
 * @param {string} value
 */
export function remember(name, value) {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // Then it holds for this page alone.
  }
}
