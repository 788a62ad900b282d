// @ts-check

import { say } from "../format/words.js";

/** @typedef {{readonly id: string, readonly title: string}} Choice with its title in the language of the page */

/** The regions of collisions that are measured, as the API names them. */
export const REGIONS = ["figure4", "stiff", "solids", "damped", "extremes"].map((id) =>
  choice(id, () => say(`tradeoff.regions.${id}`)),
);

/** What is said of many errors. */
export const STATISTICS = ["p95", "median", "max"].map((id) =>
  choice(id, () => say(`tradeoff.statistics.${id}`)),
);

/** Errors that one may ask the calculator for. */
export const WANTED_ERRORS = ["1e-3", "1e-1", "1e-2", "1e-4", "1e-5", "1e-6"];

/**
 * @param {string} id
 * @param {() => string} title asked for once the page has its words
 * @returns {Choice}
 */
function choice(id, title) {
  return {
    id,
    get title() {
      return title();
    },
  };
}
