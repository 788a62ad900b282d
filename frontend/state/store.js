// @ts-check

/**
 * How a change came about.
 * @typedef {object} Change
 * @property {boolean} dragging whether more of the same kind is to be expected at once
 * @property {number} inputTimeStamp of the event behind it, in the clock of performance.now()
 * @property {boolean} [fromAddress] whether it was read from the address bar
 * @property {boolean} [isWorkedOut] whether it is the collision of an impact, which follows by itself
 */

/**
 * One value, replaced as a whole, and those who want to hear of it.
 * @template {object} State
 * @param {State} initial
 */
export function createStore(initial) {
  let state = initial;
  /** @type {Set<(state: State, previous: State, change: Change) => void>} */
  const listeners = new Set();

  return {
    get: () => state,

    /**
     * @param {Partial<State>} patch
     * @param {Partial<Change>} [change]
     */
    set(patch, change = {}) {
      const previous = state;
      state = { ...state, ...patch };
      const how = { dragging: false, inputTimeStamp: performance.now(), ...change };
      for (const listener of listeners) {
        listener(state, previous, how);
      }
    },

    /**
     * @param {(state: State, previous: State, change: Change) => void} listener
     * @returns {() => void} ends it
     */
    subscribe(listener) {
      listeners.add(listener);
      return () => listeners.delete(listener);
    },
  };
}
