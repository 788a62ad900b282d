// @ts-check

/**
 * Copies a text. The clipboard is there on a secure page only, and not in every frame; the older way
 * works with a selection.
 * @param {string} text
 * @returns {Promise<boolean>} whether it is copied
 */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = document.createElement("textarea");
    field.className = "unseen";
    field.value = text;
    const before = /** @type {HTMLElement | null} */ (document.activeElement);
    // Inside an open dialog nothing else can be selected.
    (before?.closest("dialog") ?? document.body).append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    before?.focus();
    return done;
  }
}
