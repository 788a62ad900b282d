// @ts-check

import { USUAL_ACCURACY } from "./accuracy.js";
import { BOUNCES, sameCollision, SOLID_ALPHA, SPIN_SHARE } from "./parameters.js";

/**
 * @typedef {import("./address/options.js").PageState} PageState
 * @typedef {import("./parameters.js").Collision} Collision
 * @typedef {Pick<PageState, "collision" | "accuracy" | "alpha" | "map" | "scale" | "map_x" | "map_y" | "shape" | "energy" | "bounce" | "spin_share" | "cut_x" | "cut_y">} Setting
 */

/**
 * What a goal is judged by: the answers of the server to the present collision.
 * @typedef {object} Seen
 * @property {PageState} state
 * @property {import("../api/answers.js").CollisionAnswer} exact
 * @property {import("../api/answers.js").CollisionAnswer} shown with ε_t as the chosen method has it
 */

/**
 * A question with one right option, or one that is answered by a collision.
 * @typedef {{kind: "choice", options: string[], right: string}} Choice
 * @typedef {object} Goal
 * @property {"goal"} kind
 * @property {(seen: Seen) => string} judge `met`, or the hint that helps
 * @property {string[]} hints
 * @property {string[]} steers the controls to move
 * @property {(keyof typeof READINGS)[]} readings to be watched
 */

/**
 * What is to be guessed before the pictures of a step are shown: ε_t, or one of three sketches.
 * @typedef {{kind: "gauge"}} GaugePrediction
 * @typedef {object} SketchPrediction
 * @property {"sketch"} kind
 * @property {Record<string, string>} sketches of the velocity over time, as paths of an SVG
 * @property {(seen: Seen) => string} came which of them came
 *
 * @typedef {object} Step
 * @property {string} id
 * @property {string[]} look the panels in which to see it
 * @property {number} minutes in class
 * @property {Setting} setting
 * @property {GaugePrediction | SketchPrediction} [prediction]
 * @property {Choice | Goal} question
 */

/** Numbers of the server that a goal may have watched. */
export const READINGS = {
  /** @param {Seen} seen */
  epsilon_t: ({ exact }) => exact.epsilon_t,
  /** @param {Seen} seen */
  reversals: ({ exact }) => exact.reversals,
  /** @param {Seen} seen */
  switches: ({ exact }) => exact.switches,
  /** @param {Seen} seen */
  psi: ({ exact }) => exact.parameters.psi,
  /** @param {Seen} seen */
  coulomb: ({ exact }) => exact.estimates.coulomb,
  /** @param {Seen} seen */
  steps: ({ state }) => state.accuracy.steps,
  /** @param {Seen} seen */
  stepped: ({ shown }) => shown.epsilon_t,
  /** @param {Seen} seen */
  error: ({ shown }) => shown.error_bound,
};

/** Time runs to the right, 0 … 96, and the velocity up, its zero at 32. @type {SketchPrediction} */
const TURNS = {
  kind: "sketch",
  sketches: {
    rest: "M4 6C30 6 44 30 58 32H92",
    once: "M4 6C34 6 46 52 68 54 78 55 86 50 92 48",
    swings: "M4 6C22 6 26 54 40 54S58 12 68 12 84 44 92 46",
  },
  came: ({ exact: { reversals } }) =>
    reversals === 0 ? "rest" : reversals === 1 ? "once" : "swings",
};

/** To which |ε_t| the surfaces count as stopped: some steps of a slider. */
const STOPPED = 0.02;
/** Exact laws agree but for rounding. */
const ROUNDING = 1e-9;
/** A finger on a phone moves a slider by two per cent at a time. */
const SAME_PSI = 0.03;
const WANTED_ERROR = 1e-3;

const SAME_BOUNCE = { kappa: 18, mu_over_alpha: 1.4, gt_over_gn: 0.7 };
const STEPPED = { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 0.2 };

/** @type {Step[]} */
export const STEPS = [
  {
    id: "spin",
    look: ["contact"],
    minutes: 5,
    setting: setting({ kappa: 4.5, mu_over_alpha: 1.4, gt_over_gn: 1.1 }),
    question: { kind: "choice", options: ["plus", "zero", "minus"], right: "minus" },
  },
  {
    id: "stop",
    look: ["force"],
    minutes: 5,
    setting: setting({ kappa: 4.5, mu_over_alpha: 1.4, gt_over_gn: 4 }),
    prediction: { kind: "gauge" },
    question: {
      kind: "goal",
      steers: ["gt_over_gn"],
      readings: ["epsilon_t"],
      hints: ["forward", "backward"],
      judge({ exact: { epsilon_t } }) {
        if (Math.abs(epsilon_t) <= STOPPED) {
          return "met";
        }
        return epsilon_t > 0 ? "forward" : "backward";
      },
    },
  },
  {
    id: "reversal",
    look: ["velocity"],
    minutes: 5,
    setting: setting({ kappa: 4.5, mu_over_alpha: 1.4, gt_over_gn: 1.5 }),
    prediction: TURNS,
    question: {
      kind: "goal",
      steers: ["kappa"],
      readings: ["reversals"],
      hints: ["never", "few"],
      judge({ exact: { reversals } }) {
        if (reversals !== null && reversals >= 3) {
          return "met";
        }
        return reversals === 0 ? "never" : "few";
      },
    },
  },
  {
    id: "switching",
    look: ["force"],
    minutes: 5,
    setting: setting({ kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358 }),
    question: { kind: "choice", options: ["any", "even", "odd"], right: "even" },
  },
  {
    id: "coulomb",
    look: ["cut"],
    minutes: 8,
    setting: setting({ kappa: 10, mu_over_alpha: 1.4, gt_over_gn: 1 }),
    prediction: { kind: "gauge" },
    question: {
      kind: "goal",
      steers: ["mu_over_alpha", "gt_over_gn"],
      readings: ["epsilon_t", "coulomb"],
      hints: ["sticks"],
      judge({ exact: { epsilon_t, switches, estimates } }) {
        const isExact = Math.abs(epsilon_t - estimates.coulomb) < ROUNDING;
        return switches === 0 && isExact ? "met" : "sticks";
      },
    },
  },
  {
    id: "gear",
    look: ["velocity", "cut"],
    minutes: 8,
    setting: setting({ kappa: 4.5, mu_over_alpha: 1.4, gt_over_gn: 0.2 }),
    prediction: { kind: "gauge" },
    question: {
      kind: "goal",
      steers: ["kappa"],
      readings: ["epsilon_t"],
      hints: ["forward", "backward"],
      judge({ exact: { epsilon_t } }) {
        if (epsilon_t <= -0.99) {
          return "met";
        }
        return epsilon_t > 0 ? "forward" : "backward";
      },
    },
  },
  {
    id: "stiff",
    look: ["cut"],
    minutes: 8,
    setting: setting(
      { kappa: 200, mu_over_alpha: 1.4, gt_over_gn: 1 },
      { scale: "log", cut_x: "kappa", cut_y: "log" },
    ),
    question: { kind: "choice", options: ["root", "linear", "power"], right: "power" },
  },
  {
    id: "collapse",
    look: ["map"],
    minutes: 10,
    setting: setting(SAME_BOUNCE, { map_y: "psi" }),
    question: {
      kind: "goal",
      steers: ["mu_over_alpha", "gt_over_gn"],
      readings: ["epsilon_t", "psi"],
      hints: ["other", "friction", "apart"],
      judge({ state: { collision }, exact }) {
        if (collision.kappa !== SAME_BOUNCE.kappa || collision.damping > 0) {
          return "other";
        }
        if (Math.abs(collision.mu_over_alpha / SAME_BOUNCE.mu_over_alpha - 1) < 0.2) {
          return "friction";
        }
        const psi = SAME_BOUNCE.gt_over_gn / SAME_BOUNCE.mu_over_alpha;
        const isSame = Math.abs((exact.parameters.psi ?? Infinity) / psi - 1) <= SAME_PSI;
        return isSame ? "met" : "apart";
      },
    },
  },
  {
    id: "damping",
    look: ["force"],
    minutes: 5,
    setting: setting(SAME_BOUNCE),
    question: {
      kind: "goal",
      steers: ["damping"],
      readings: ["switches"],
      hints: ["even"],
      judge: ({ exact: { switches } }) =>
        switches !== null && switches % 2 === 1 ? "met" : "even",
    },
  },
  {
    id: "timestep",
    look: ["overlay"],
    minutes: 8,
    setting: setting(STEPPED, {
      accuracy: { ...USUAL_ACCURACY, method: "timestep", steps: 20 },
    }),
    question: {
      kind: "goal",
      steers: ["steps"],
      readings: ["steps", "stepped", "epsilon_t", "error"],
      hints: ["other", "method", "sign", "coarse"],
      judge({ state: { accuracy, collision }, exact, shown }) {
        if (!sameCollision(collision, { ...STEPPED, damping: 0 })) {
          return "other";
        }
        if (accuracy.method !== "timestep") {
          return "method";
        }
        if (shown.error_bound <= WANTED_ERROR) {
          return "met";
        }
        return shown.epsilon_t * exact.epsilon_t < 0 ? "sign" : "coarse";
      },
    },
  },
];

/**
 * What a step of the lesson sets; in other scenes, nothing.
 * @param {string} scene
 * @param {string} step its number, from 1 on
 * @returns {Partial<Setting>}
 */
export function settingOf(scene, step) {
  return scene === "lesson" ? stepOf(step).setting : {};
}

/** @param {string} number from 1 on */
export function stepOf(number) {
  return STEPS[Number(number) - 1];
}

/** From 1 on, as in the address. @param {Step} step */
export function stepNumber(step) {
  return String(STEPS.indexOf(step) + 1);
}

/**
 * The controls that a step of the lesson asks to move; in other scenes, none.
 * @param {Pick<PageState, "scene" | "step">} state
 */
export function steersOf({ scene, step }) {
  const { question } = stepOf(step);
  return scene === "lesson" && question.kind === "goal" ? question.steers : [];
}

/**
 * Whether the steps of a method are shown over the exact force, as the lesson does, too.
 * @param {Pick<PageState, "scene" | "step">} state
 */
export function showsSteps({ scene, step }) {
  return scene === "accuracy" || (scene === "lesson" && stepOf(step).look.includes("overlay"));
}

/**
 * Where the texts of a step are found.
 * @param {Step} step
 */
export function textsOf({ id, question, prediction }) {
  const at = `lesson.steps.${id}`;
  return {
    title: `${at}.title`,
    text: `${at}.text`,
    question: `${at}.question`,
    notes: { aim: `${at}.aim`, answer: `${at}.answer`, misconception: `${at}.misconception` },
    ...(prediction ? { predict: `${at}.predict` } : {}),
    sketches:
      prediction?.kind === "sketch"
        ? Object.entries(prediction.sketches).map(([sketch, path]) => ({
            sketch,
            path,
            text: `${at}.sketches.${sketch}`,
          }))
        : [],
    options:
      question.kind === "choice"
        ? question.options.map((option) => ({
            option,
            text: `${at}.options.${option}`,
            reason: `${at}.reasons.${option}`,
          }))
        : [],
    verdicts:
      question.kind === "goal"
        ? Object.fromEntries(["met", ...question.hints].map((v) => [v, `${at}.verdicts.${v}`]))
        : {},
  };
}

/**
 * @param {Omit<Collision, "damping">} collision
 * @param {Partial<Setting>} [view] where it is not the usual
 * @returns {Setting}
 */
function setting(collision, view = {}) {
  return {
    collision: { ...collision, damping: 0 },
    accuracy: USUAL_ACCURACY,
    alpha: SOLID_ALPHA,
    map: "epsilon_t",
    scale: "linear",
    map_x: "kappa",
    map_y: "gt_over_gn",
    shape: "flat",
    energy: "hidden",
    bounce: BOUNCES[0].id,
    spin_share: SPIN_SHARE.initial,
    cut_x: "gt_over_gn",
    cut_y: "linear",
    ...view,
  };
}
