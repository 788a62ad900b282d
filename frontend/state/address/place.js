// @ts-check

const PREFIX = "restitution:";

/**
 * The address of the page from its question mark on. Where the browser lets none be changed, as in the frame of
 * a text, the name of the window holds it, beside the address that stays: it outlives the page's being loaded anew.
 */
export function presentSearch() {
  const kept = `${PREFIX}${location.href} `;
  return window.name.startsWith(kept) ? window.name.slice(kept.length) : location.search;
}

/**
 * @param {"pushState" | "replaceState"} how
 * @param {string} search
 */
export function changeSearch(how, search) {
  try {
    history[how](null, "", search);
  } catch {
    window.name = `${PREFIX}${location.href} ${search}`;
  }
}

/** The whole address, as far as there is one. @param {string} search */
export function linkTo(search) {
  return URL.canParse(search, location.href) ? new URL(search, location.href).href : search;
}
