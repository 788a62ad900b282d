// @ts-check

/**
 * The element a selector names; that it is there is the page's own promise.
 * @template {HTMLElement} [T=HTMLElement]
 * @param {string} selector
 * @param {ParentNode} [root]
 * @returns {T}
 */
export function find(selector, root = document) {
  const element = root.querySelector(selector);
  if (!element) {
    throw new Error(`the page has no ${selector}`);
  }
  return /** @type {T} */ (element);
}

/**
 * @param {string} id
 */
export function byTestId(id, root = /** @type {ParentNode} */ (document)) {
  return find(`[data-testid="${id}"]`, root);
}
