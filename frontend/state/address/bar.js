// @ts-check

import { readAddress } from "./reading.js";
import { writeAddress } from "./writing.js";

/** Of the name of a window that holds an address. */
const PREFIX = "restitution:";

/** Browsers refuse more than some twenty changes of the address a second. */
const PAUSE = 150;
/** Changes that follow one another faster, as of a held arrow key, are one step back. */
export const ONE_STEP = 1000;

/**
 * The address bar, which holds the whole state: a drag moves along one entry of the history and adds
 * a single new one when it ends.
 * @param {(state: import("./options.js").PageState, problems: string[]) => void} onReturn back or forward was pressed
 */
export function createAddressBar(onReturn) {
  let settled = presentSearch();
  let settledAt = -ONE_STEP;
  /** Which page of the book, so to say: to turn it is always a step of its own. */
  let page = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  addEventListener("popstate", () => {
    clearTimeout(timer);
    settled = presentSearch();
    // What was returned to stays in the history, however soon something is changed.
    settledAt = -ONE_STEP;
    const { state, problems } = readAddress(settled);
    page = pageOf(state);
    onReturn(state, problems);
  });

  return {
    /** @param {import("./options.js").PageState} state */
    correct(state) {
      settled = writeAddress(state);
      page = pageOf(state);
      changeSearch("replaceState", settled);
    },

    /**
     * @param {import("./options.js").PageState} state
     * @param {import("../store.js").Change} change
     */
    follow(state, { dragging, isWorkedOut }) {
      const address = writeAddress(state);
      clearTimeout(timer);
      if (dragging) {
        timer = setTimeout(() => changeSearch("replaceState", address), PAUSE);
        return;
      }
      if (isWorkedOut || parent !== window) {
        // No step of its own, or from the one before it back would lead here again; in a frame back
        // belongs to the page around it.
        settled = address;
        changeSearch("replaceState", address);
        return;
      }
      if (address !== settled) {
        const now = performance.now();
        if (now - settledAt < ONE_STEP && page === pageOf(state)) {
          changeSearch("replaceState", address);
        } else {
          changeSearch("replaceState", settled);
          changeSearch("pushState", address);
        }
        settled = address;
        settledAt = now;
        page = pageOf(state);
      }
    },
  };
}

/** @param {import("./options.js").PageState} state */
function pageOf({ scene, step }) {
  return `${scene} ${step}`;
}

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
