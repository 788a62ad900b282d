// @ts-check

import { ONE_STEP } from "./address/bar.js";
import { writeAddress } from "./address/writing.js";

/** @typedef {import("./address/options.js").PageState} PageState */

/** How the page looks, speaks and moves is nothing that is shown: it stays as it is. */
const USUAL_LOOKS = /** @type {const} */ ({
  theme: "system",
  lang: "system",
  face: "usual",
  presenting: "off",
  left: "contact",
  right: "map",
  sweep: null,
});

/** To turn to another page is always a step of its own. */
const TURNS = ["scene", "step"];

/**
 * The states that one was in, in steps that can be taken back: a whole drag is one, and so are changes of
 * the same kind that follow one another fast. A new step cuts off those that were taken back.
 * @param {PageState} initial
 */
export function createUndoStack(initial) {
  let steps = [stepTo(initial)];
  let at = 0;
  /** What the last change changed, and when. */
  let last = { keys: "", time: -Infinity };

  /** @param {number} to */
  function move(to) {
    if (!(to in steps)) {
      return null;
    }
    const [from, there] = [steps[at], steps[to]];
    at = to;
    last = { keys: "", time: -Infinity };
    return { state: there.state, changed: differences(from.address, there.address) };
  }

  return {
    canUndo: () => at > 0,
    canRedo: () => at + 1 < steps.length,

    /**
     * Takes in a state at rest.
     * @param {PageState} state
     * @param {import("./store.js").Change} change
     */
    follow(state, { fromAddress, isWorkedOut, inputTimeStamp: time }) {
      const present = steps[at];
      if (isWorkedOut) {
        const { collision, alpha } = state;
        steps[at] = stepTo({ ...present.state, collision, alpha });
        return;
      }
      const next = stepTo(state);
      if (next.address === present.address) {
        return;
      }
      const isNext = (/** @type {number} */ i) => steps[i]?.address === next.address;
      // Back and forward of the browser go along the same steps.
      const neighbour = fromAddress ? [at - 1, at + 1].find(isNext) : undefined;
      if (neighbour !== undefined) {
        move(neighbour);
        return;
      }
      const changed = differences(present.address, next.address).map(({ key }) => key);
      const keys = changed.join();
      const isTurn = TURNS.some((key) => changed.includes(key));
      const goesOn = keys === last.keys && time - last.time < ONE_STEP && !isTurn && !fromAddress;
      const kept = steps.slice(0, goesOn ? at : at + 1);
      last = { keys, time };
      // There and back again is no step.
      steps = kept.at(-1)?.address === next.address ? kept : [...kept, next];
      at = steps.length - 1;
    },

    /** The state before, and what is another there; null where there is none. */
    undo: () => move(at - 1),

    /** The state that was taken back last. */
    redo: () => move(at + 1),
  };
}

/**
 * A state with the looks that the page has now.
 * @param {PageState} state
 * @param {PageState} present
 * @returns {PageState}
 */
export function withLooks(state, { theme, lang, face, presenting, left, right, sweep }) {
  return { ...state, theme, lang, face, presenting, left, right, sweep };
}

/** @param {PageState} state */
function stepTo(state) {
  return { state, address: writeAddress({ ...state, ...USUAL_LOOKS }) };
}

/**
 * The options in which two addresses differ.
 * @param {string} from
 * @param {string} to
 */
function differences(from, to) {
  const [before, after] = [new URLSearchParams(from), new URLSearchParams(to)];
  return [...new Set([...before.keys(), ...after.keys()])]
    .map((key) => ({ key, from: before.get(key), to: after.get(key) }))
    .filter((each) => each.from !== each.to);
}
