// @ts-check

import { typable } from "../format/number.js";
import { PLAIN_SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import { createUndoStack, withLooks } from "../state/undo-stack.js";
import { byTestId } from "../widgets/find.js";

/** @typedef {import("../state/address/options.js").PageState} PageState */

/** What has a Ctrl+Z of its own, or stands before the page. */
const ELSEWHERE = "input:not([type=range], [type=radio], [type=checkbox]), textarea, dialog";

const IS_MAC = /^(Mac|iP)/.test(navigator.platform);

/**
 * Two buttons and the usual keys that take back what was changed, and bring it back.
 * @param {object} page
 * @param {() => PageState} page.present
 * @param {(state: PageState) => void} page.set
 */
export function mountUndo({ present, set }) {
  const stack = createUndoStack(present());
  const said = byTestId("said");
  const ways = {
    undo: { button: titled("undo", say("undo.undo.key")), move: stack.undo },
    redo: { button: titled("redo", say("undo.redo.key")), move: stack.redo },
  };

  for (const [name, { button, move }] of Object.entries(ways)) {
    button.addEventListener("click", () => {
      go(name, move);
      // The keyboard stays where it can go on.
      if (button.disabled) {
        Object.values(ways)
          .find((way) => way.button !== button)
          ?.button.focus();
      }
    });
  }
  addEventListener("keydown", (event) => {
    const way = wayOf(event);
    const target = /** @type {Element | null} */ (event.target);
    if (way && !event.defaultPrevented && !target?.closest?.(ELSEWHERE)) {
      event.preventDefault();
      go(way, ways[way].move);
    }
  });

  /**
   * @param {string} way
   * @param {typeof stack.undo} move
   */
  function go(way, move) {
    const step = move();
    if (step) {
      set(withLooks(step.state, present()));
      said.textContent = [say(`undo.${way}.done`), inWords(step.changed)]
        .filter(Boolean)
        .join(": ");
    }
  }

  return {
    /**
     * @param {PageState} state
     * @param {import("../state/store.js").Change} change
     */
    follow(state, change) {
      if (!change.dragging) {
        stack.follow(state, change);
        said.textContent = change.isWorkedOut ? said.textContent : "";
        ways.undo.button.disabled = !stack.canUndo();
        ways.redo.button.disabled = !stack.canRedo();
      }
    },
  };
}

/**
 * @param {string} name
 * @param {string} key
 */
function titled(name, key) {
  const element = /** @type {HTMLButtonElement} */ (byTestId(name));
  element.title = `${element.ariaLabel} (${IS_MAC ? key.replace(/^\w+/, "Cmd") : key})`;
  return element;
}

/** @param {KeyboardEvent} event */
function wayOf({ key, ctrlKey, metaKey, shiftKey, altKey }) {
  const letter = key.toLowerCase();
  if (altKey || ctrlKey === metaKey) {
    return null;
  }
  if (letter === "z") {
    return shiftKey ? "redo" : "undo";
  }
  return letter === "y" && ctrlKey ? "redo" : null;
}

/**
 * The parameters that changed, for a screen reader.
 * @param {{key: string, from: string | null, to: string | null}[]} changed
 */
function inWords(changed) {
  return changed
    .flatMap(({ key, from, to }) => {
      const symbol = PLAIN_SYMBOLS[/** @type {keyof typeof PLAIN_SYMBOLS} */ (key)];
      return symbol && from && to
        ? `${symbol} ${typable(Number(from))} → ${typable(Number(to))}`
        : [];
    })
    .join(", ");
}
