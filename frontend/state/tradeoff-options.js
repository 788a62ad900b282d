// @ts-check

/** The regions of collisions that are measured, as the API names them. @type {{id: string, title: string}[]} */
export const REGIONS = [
  { id: "figure4", title: "Fig. 4" },
  { id: "stiff", title: "stiff" },
  { id: "solids", title: "solids" },
  { id: "damped", title: "damped" },
  { id: "extremes", title: "extremes" },
];

/** What is said of many errors. @type {{id: string, title: string}[]} */
export const STATISTICS = [
  { id: "p95", title: "95 %" },
  { id: "median", title: "median" },
  { id: "max", title: "worst" },
];

/** Errors that one may ask the calculator for. */
export const WANTED_ERRORS = ["1e-3", "1e-1", "1e-2", "1e-4", "1e-5", "1e-6"];
