// @ts-check

/**
 * The address of the page from its question mark on. Where the browser lets none be changed, as in the frame of
 * a text, the name of the window holds it, which stays when the page is loaded anew.
 */

const PREFIX = "restitution:";

export function presentSearch() {
  const { name } = window;
  return location.search || (name.startsWith(PREFIX) ? name.slice(PREFIX.length) : "");
}

/**
 * @param {"pushState" | "replaceState"} how
 * @param {string} search
 */
export function changeSearch(how, search) {
  try {
    history[how](null, "", search);
  } catch {
    window.name = PREFIX + search;
  }
}

/** The whole address, as far as there is one. @param {string} search */
export function linkTo(search) {
  return URL.canParse(search, location.href) ? new URL(search, location.href).href : search;
}
