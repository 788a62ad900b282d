// @ts-check

const PREFIX = "restitution.";

/**
 * What a browser keeps of the page, if it keeps anything: in a sandboxed frame it may not.
 * @param {() => Storage} storage
 */
function createMemory(storage) {
  return {
    /** @param {string} name @returns {string | null} */
    recall(name) {
      try {
        return storage().getItem(PREFIX + name);
      } catch {
        return null;
      }
    },

    /**
     * @param {string} name
     * @param {string} value
     */
    remember(name, value) {
      try {
        storage().setItem(PREFIX + name, value);
      } catch {
        // Then it holds until the page is loaded anew.
      }
    },
  };
}

/** From one visit to the next. */
export const ofVisits = createMemory(() => localStorage);

/** As long as the tab is open, also when the page is loaded anew in another language. */
export const ofTab = createMemory(() => sessionStorage);
