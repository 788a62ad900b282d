// @ts-check

import { say } from "../format/words.js";
import { number } from "./requirements.js";

/**
 * How ε_t is to be got: by which method, and how exactly. Named as the API names it.
 * @typedef {object} Accuracy
 * @property {string} method
 * @property {number} tolerance of `auto`
 * @property {number} steps of `timestep`, in a contact
 * @property {string} integrator of `timestep`
 * @property {number} rtol of `ode`
 */

/**
 * A number that trades speed for accuracy.
 * @typedef {object} Knob
 * @property {"tolerance" | "steps" | "rtol"} key
 * @property {number} initial
 * @property {(value: number) => boolean} admits
 * @property {() => string} requirement what `admits` wants, in words
 * @property {number[]} notches from fast to exact
 */

/** @type {Record<Knob["key"], Knob>} */
export const KNOBS = {
  tolerance: {
    key: "tolerance",
    initial: 1e-10,
    admits: (value) => value >= 1e-13 && value <= 1,
    requirement: () => say("requirements.within", { least: "1e-13", most: "1" }),
    notches: powersOfTen(-1, -13),
  },
  steps: {
    key: "steps",
    initial: 50,
    admits: (value) => Number.isInteger(value) && value >= 4 && value <= 1e6,
    requirement: () => say("requirements.integer", { least: "4", most: "1000000" }),
    notches: [
      10, 20, 30, 50, 70, 100, 150, 200, 300, 500, 700, 1000, 2000, 5000, 1e4, 2e4, 5e4, 1e5,
    ],
  },
  rtol: {
    key: "rtol",
    initial: 1e-9,
    admits: (value) => value >= 1e-13 && value <= 0.1,
    requirement: () => say("requirements.within", { least: "1e-13", most: number(0.1) }),
    notches: powersOfTen(-2, -13),
  },
};

/**
 * What can be chosen, each with its title in the language of the page.
 * @typedef {{readonly id: string, readonly title: string}} Choice
 */

/**
 * The methods by name, each with its knob, if it has one.
 * @type {(Choice & {knob: Knob | null})[]}
 */
export const METHODS = [
  methodOf("auto", KNOBS.tolerance),
  methodOf("exact"),
  methodOf("table"),
  methodOf("stiff"),
  methodOf("coulomb"),
  methodOf("timestep", KNOBS.steps),
  methodOf("ode", KNOBS.rtol),
];

/** @type {Choice[]} */
export const INTEGRATORS = ["velocity_verlet", "symplectic_euler", "forward_euler"].map((id) => ({
  id,
  get title() {
    return say(`integrators.${id}`);
  },
}));

/** @type {Accuracy} */
export const USUAL_ACCURACY = {
  method: "auto",
  tolerance: KNOBS.tolerance.initial,
  steps: KNOBS.steps.initial,
  integrator: INTEGRATORS[0].id,
  rtol: KNOBS.rtol.initial,
};

/** @param {string} method */
export function knobOf(method) {
  return METHODS.find(({ id }) => id === method)?.knob ?? null;
}

/**
 * What the API is asked of it: only what the method heeds.
 * @param {Accuracy} accuracy
 * @returns {Record<string, string>}
 */
export function accuracyQuery(accuracy) {
  const { method, integrator } = accuracy;
  const knob = knobOf(method);
  return {
    method,
    ...(knob ? { [knob.key]: String(accuracy[knob.key]) } : {}),
    ...(method === "timestep" ? { integrator } : {}),
  };
}

/**
 * Whose failing is to be shown: the exact method has none, and beside the exact value, which an error
 * needs anyway, `auto` takes no other; time steps stand in for both.
 * @param {Accuracy} accuracy
 * @returns {Accuracy}
 */
export function failingOf(accuracy) {
  return ["exact", "auto"].includes(accuracy.method) ? inSteps(accuracy) : accuracy;
}

/**
 * How the ε_t of a state is got: of real spheres by the law that is shown over the velocities.
 * @param {{scene: string, velocity_law: string, accuracy: Accuracy}} state
 * @returns {Accuracy}
 */
export function accuracyOf({ scene, velocity_law: law, accuracy }) {
  return scene === "spheres" && law === "coulomb" ? { ...accuracy, method: "coulomb" } : accuracy;
}

/**
 * What of a state is to change with a method that is chosen: of real spheres, the law that is shown, too.
 * @param {{scene: string, accuracy: Accuracy}} state
 * @param {Partial<Accuracy>} patch
 */
export function withAccuracy({ scene, accuracy }, patch) {
  const law = patch.method === "coulomb" ? "coulomb" : "epsilon_t";
  return {
    accuracy: { ...accuracy, ...patch },
    ...(scene === "spheres" && patch.method ? { velocity_law: law } : {}),
  };
}

/** The same knobs, for time steps. @param {Accuracy} accuracy @returns {Accuracy} */
export function inSteps(accuracy) {
  return { ...accuracy, method: "timestep" };
}

/**
 * Whether two ask for the same.
 * @param {Accuracy} a
 * @param {Accuracy} b
 */
export function sameAccuracy(a, b) {
  return JSON.stringify(accuracyQuery(a)) === JSON.stringify(accuracyQuery(b));
}

/**
 * The notch nearest to a value, as a ratio.
 * @param {Knob} knob
 * @param {number} value
 */
export function nearestNotch({ notches }, value) {
  const distances = notches.map((notch) => Math.abs(Math.log(notch / value)));
  return distances.indexOf(Math.min(...distances));
}

/** Methods that the kernel in the page answers by as well: both are exact. */
export const METHODS_BY_KERNEL = ["auto", "exact"];

/**
 * Whether a method answers a collision at all: a request that is refused leaves its mark in the
 * browser's console.
 * @param {string} method
 * @param {import("./parameters.js").Collision} collision
 */
export function canAnswer(method, { kappa, mu_over_alpha, gt_over_gn, damping }) {
  const psi = gt_over_gn / mu_over_alpha;
  switch (method) {
    case "stiff":
      return damping === 0;
    case "table":
      return (
        damping === 0 && kappa >= 1e-2 && kappa <= 1e3 && (psi === 0 || (psi >= 1e-3 && psi <= 1e3))
      );
    case "ode":
      return kappa <= 1e5;
    case "exact":
      return kappa <= 1e8;
    default:
      return true;
  }
}

/**
 * @param {number} first
 * @param {number} last
 */
function powersOfTen(first, last) {
  return Array.from({ length: first - last + 1 }, (_, i) => Number(`1e${first - i}`));
}

/**
 * @param {string} id
 * @param {Knob | null} knob
 */
function methodOf(id, knob = null) {
  return {
    id,
    knob,
    // asked for once the page has its words
    get title() {
      return say(`methods.${id}`);
    },
  };
}

/**
 * @param {Choice[]} choices
 * @param {string} wanted
 */
export function titleOf(choices, wanted) {
  return choices.find(({ id }) => id === wanted)?.title ?? wanted;
}
