// @ts-check

import { knownLanguages } from "../../format/words.js";
import { INTEGRATORS, METHODS } from "../accuracy.js";
import { STEPS } from "../lesson.js";
import { KIND_CHOICES, VERDICT_CHOICES } from "../paper.js";
import { BOUNCES } from "../parameters.js";
import { PRESENTED, SCENES } from "../scenes.js";
import { REGIONS, STATISTICS, WANTED_ERRORS } from "../tradeoff-options.js";

/** The options that are words, each with what it may be; the first is the default. */
export const WORDS = {
  map: ["epsilon_t", "switches"],
  scale: ["linear", "log"],
  map_x: ["kappa", "alpha_kappa"],
  map_y: ["gt_over_gn", "psi"],
  shape: ["flat", "surface"],
  energy: ["hidden", "shown"],
  cut_x: ["gt_over_gn", "kappa"],
  cut_y: ["linear", "log"],
};

/** The same of the page around the pictures; they stand in the address only where they are not the first. */
export const PAGE_WORDS = {
  scene: SCENES.map(({ id }) => id),
  theme: ["system", "light", "dark"],
  bounce: BOUNCES.map(({ id }) => id),
  region: REGIONS.map(({ id }) => id),
  statistic: STATISTICS.map(({ id }) => id),
  wanted_error: WANTED_ERRORS,
  velocity_law: ["epsilon_t", "coulomb"],
  velocity_scale: ["linear", "log"],
  paper_verdict: VERDICT_CHOICES,
  paper_kind: KIND_CHOICES,
  step: STEPS.map((_, i) => String(i + 1)),
  // known once the page has its words
  get lang() {
    return ["system", ...knownLanguages().map(({ id }) => id)];
  },
  notes: ["hidden", "shown"],
  handout: ["hidden", "shown"],
  face: ["usual", "plain", "expert"],
  presenting: ["off", "on"],
  left: PRESENTED,
  right: ["map", ...PRESENTED.filter((name) => name !== "map")],
};

/** How ε_t is got; it stands in the address only where it is not the usual way. */
export const ACCURACY_WORDS = {
  method: METHODS.map(({ id }) => id),
  integrator: INTEGRATORS.map(({ id }) => id),
};

/** The paper's own, of Fig. 2. What else there is, the server knows. */
export const USUAL_MATERIAL = "steel";

/** Lists of a frame, parted by commas, each with what stands for none given. */
export const LISTS = { embed: "none", sliders: "usual" };

export const WORD_KEYS = /** @type {(keyof typeof WORDS)[]} */ (Object.keys(WORDS));

/**
 * What the page shows; it stands in the address bar in full.
 * @typedef {object} PageState
 * @property {import("../parameters.js").Collision} collision
 * @property {number} alpha of the bodies behind it, for the axis ακ and the ball that bounces
 * @property {string} bounce off what, and how often
 * @property {number} spin_share of g_t, the rest of which is travel
 * @property {import("../pins.js").Pins} pins collisions to compare the present one with
 * @property {import("../sweep.js").Sweep | null} sweep that a slider is ready for, or in
 * @property {import("../accuracy.js").Accuracy} accuracy
 * @property {"epsilon_t" | "switches"} map the quantity the map shows
 * @property {"linear" | "log"} scale of the axes of map and cut
 * @property {"kappa" | "alpha_kappa"} map_x what the map's horizontal axis is labelled with
 * @property {"gt_over_gn" | "psi"} map_y what map and cut run over
 * @property {"flat" | "surface"} shape of the map
 * @property {"hidden" | "shown"} energy over time, with the velocity
 * @property {"gt_over_gn" | "kappa"} cut_x the parameter that the cut runs along
 * @property {"linear" | "log"} cut_y ε_t on the cut as it is, or its magnitude on a logarithmic axis
 * @property {string} scene
 * @property {"system" | "light" | "dark"} theme
 * @property {string} region whose measurement is shown
 * @property {string} statistic of the errors there
 * @property {string} wanted_error for which the steps are asked
 * @property {string} velocity_law whose ε_t is shown over the velocities
 * @property {"linear" | "log"} velocity_scale of the axes of velocities
 * @property {string} paper_verdict of the statements of the paper that are listed
 * @property {string} paper_kind of the same
 * @property {string} step of the lesson, from 1 on
 * @property {string} lang the language of what is translated, or `system`
 * @property {"hidden" | "shown"} notes for teachers
 * @property {"hidden" | "shown"} handout of the lesson, in place of its pictures
 * @property {"usual" | "plain" | "expert"} face of the page: plain, or with all that there is to see;
 *   usual is the one that was last chosen in this browser
 * @property {"off" | "on"} presenting on a projector: large type and one picture or two
 * @property {string} left picture of those presented
 * @property {string} right one, or the same for that alone
 * @property {import("../impact.js").Impact} impact of real spheres
 * @property {string} embed the panels to show without the rest of the page, or `none`
 * @property {string} sliders the values that may be moved there, all else being locked, or `none`; `usual`
 *   locks nothing and has no sliders
 */
