// @ts-check

import { PLAIN_SYMBOLS } from "../format/symbols.js";
import { knownLanguages, say } from "../format/words.js";
import { INTEGRATORS, KNOBS, METHODS, USUAL_ACCURACY } from "./accuracy.js";
import { IMPACT_PARAMETERS, impactOf, INERTIAS, SECONDS } from "./impact.js";
import { settingOf, STEPS } from "./lesson.js";
import { KIND_CHOICES, VERDICT_CHOICES } from "./paper.js";
import { BOUNCES, PARAMETERS, parseNumber, SOLID_ALPHA, SPIN_SHARE } from "./parameters.js";
import { readPins, writePins } from "./pins.js";
import { misfit, misread } from "./requirements.js";
import { PRESENTED, SCENES } from "./scenes.js";
import { REGIONS, STATISTICS, WANTED_ERRORS } from "./tradeoff-options.js";
import { readSweep, writeSweep } from "./sweep.js";

/** The options that are words, each with what it may be; the first is the default. */
const WORDS = {
  map: ["epsilon_t", "switches"],
  scale: ["linear", "log"],
  map_x: ["kappa", "alpha_kappa"],
  map_y: ["gt_over_gn", "psi"],
  shape: ["flat", "surface"],
  energy: ["hidden", "shown"],
  cut_x: ["gt_over_gn", "kappa"],
  cut_y: ["linear", "log"],
};

/** Panels that belong to one scene. */
const PANELS = {
  explorer: ["force", "velocity", "map", "cut", "contact", "compare"],
  accuracy: ["tradeoff", "error_map", "overlay", "steps", "codes"],
  spheres: ["velocities", "sphere_cut", "impact", "place"],
  paper: ["paper", "collapse", "stiff_law", "switch_law"],
};

/** The same of the page around the pictures; they stand in the address only where they are not the first. */
const PAGE_WORDS = {
  scene: SCENES.map(({ id }) => id),
  theme: ["system", "light", "dark"],
  embed: ["none", "result", ...Object.values(PANELS).flat()],
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
const ACCURACY_WORDS = {
  method: METHODS.map(({ id }) => id),
  integrator: INTEGRATORS.map(({ id }) => id),
};

/** The paper's own, of Fig. 2. What else there is, the server knows. */
const USUAL_MATERIAL = "steel";

const WORD_KEYS = /** @type {(keyof typeof WORDS)[]} */ (Object.keys(WORDS));

/**
 * What the page shows; it stands in the address bar in full.
 * @typedef {object} PageState
 * @property {import("./parameters.js").Collision} collision
 * @property {number} alpha of the bodies behind it, for the axis ακ and the ball that bounces
 * @property {string} bounce off what, and how often
 * @property {number} spin_share of g_t, the rest of which is travel
 * @property {import("./pins.js").Pins} pins collisions to compare the present one with
 * @property {import("./sweep.js").Sweep | null} sweep that a slider is ready for, or in
 * @property {import("./accuracy.js").Accuracy} accuracy
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
 * @property {import("./impact.js").Impact} impact of real spheres
 * @property {string} embed the one panel to show without the rest of the page, or `none`
 */

/**
 * The state an address describes; what makes no sense there becomes the default and a problem in words.
 * @param {string} search
 * @returns {{state: PageState, problems: string[]}}
 */
export function readAddress(search) {
  const query = new URLSearchParams(search);
  /** @type {string[]} */
  const problems = [];
  /** @type {string[]} */
  const inWords = [];
  /** @type {Record<string, string>} */
  const words = {};
  for (const [key, allowed] of Object.entries(PAGE_WORDS)) {
    words[key] = readWord(query, key, allowed, inWords);
  }
  // A panel that stands alone brings its scene along.
  const own = Object.entries(PANELS).find(([, panels]) => panels.includes(words.embed));
  words.scene = own?.[0] ?? words.scene;
  // What a step of the lesson sets need not stand in its address.
  const usual = settingOf(words.scene, words.step);
  for (const [key, allowed] of Object.entries(WORDS)) {
    const first = usual[/** @type {keyof typeof WORDS} */ (key)] ?? allowed[0];
    words[key] = readWord(query, key, allowed, inWords, first);
  }
  /** @type {Record<string, number>} */
  const collision = {};
  for (const parameter of PARAMETERS) {
    const value = readNumber(query, parameter, problems);
    collision[parameter.key] = value ?? usual.collision?.[parameter.key] ?? parameter.initial;
  }
  problems.push(...inWords);
  const accuracy = readAccuracy(query, problems, usual.accuracy ?? USUAL_ACCURACY);
  const impact = readImpact(query, problems);
  const alpha = readAlpha(query, problems);
  const spin_share = readNumber(query, SPIN_SHARE, problems) ?? SPIN_SHARE.initial;
  const pins = readPinned(query, problems);
  const sweep = readSwept(query, problems);
  return {
    state: /** @type {PageState} */ ({
      collision,
      alpha,
      spin_share,
      pins,
      sweep,
      accuracy,
      impact,
      ...words,
    }),
    problems,
  };
}

/**
 * @param {URLSearchParams} query
 * @param {string[]} problems to which those of it are added
 */
function readImpact(query, problems) {
  const inertia = query.has("inertia") ? readWord(query, "inertia", INERTIAS, problems) : null;
  const second = query.has("second") ? readWord(query, "second", SECONDS, problems) : null;
  const impact = { ...impactOf(query.get("material") ?? USUAL_MATERIAL), inertia, second };
  for (const parameter of IMPACT_PARAMETERS) {
    impact[parameter.key] = readNumber(query, parameter, problems);
  }
  if (impact.normal_restitution !== null && impact.dissipative_constant_s !== null) {
    problems.push(say("address.toldTwice"));
    impact.dissipative_constant_s = null;
  }
  return impact;
}

/**
 * The value of a parameter, null where there is none or a wrong one.
 * @param {URLSearchParams} query
 * @param {Pick<import("./parameters.js").Parameter, "admits" | "requirement"> & {key: string}} parameter
 * @param {string[]} problems to which that of it is added
 */
function readNumber(query, { key, admits, requirement }, problems) {
  const text = query.get(key);
  if (text === null) {
    return null;
  }
  const value = parseNumber(text);
  if (value !== null && admits(value)) {
    return value;
  }
  /** @type {Record<string, string>} */
  const symbols = PLAIN_SYMBOLS;
  problems.push(misread(symbols[key] ?? key, requirement(), text));
  return null;
}

/**
 * @param {URLSearchParams} query
 * @param {string[]} problems to which that of it is added
 */
function readAlpha(query, problems) {
  const text = query.get("alpha");
  const value = text === null ? SOLID_ALPHA : parseNumber(text);
  if (value !== null && value > 0 && value <= 1) {
    return value;
  }
  problems.push(misread("α", say("requirements.share"), text ?? ""));
  return SOLID_ALPHA;
}

/**
 * @param {URLSearchParams} query
 * @param {string[]} problems to which that of it is added
 */
function readPinned(query, problems) {
  const { pins, wrong } = readPins(query.get("pins") ?? "");
  if (wrong.length > 0) {
    problems.push(misfit("pins", say("requirements.pins"), wrong.join(";")));
  }
  return pins;
}

/**
 * @param {URLSearchParams} query
 * @param {string[]} problems to which that of it is added
 */
function readSwept(query, problems) {
  const text = query.get("sweep");
  const sweep = text === null ? null : readSweep(text);
  if (text !== null && !sweep) {
    problems.push(misfit("sweep", say("requirements.sweep"), text));
  }
  return sweep;
}

/**
 * @param {URLSearchParams} query
 * @param {string[]} problems to which those of it are added
 * @param {import("./accuracy.js").Accuracy} usual
 */
function readAccuracy(query, problems, usual) {
  const numbers = Object.values(KNOBS).map(({ key, admits, requirement }) => {
    const text = query.get(key);
    const value = text === null ? usual[key] : parseNumber(text);
    const isAllowed = value !== null && admits(value);
    if (!isAllowed) {
      problems.push(misread(key, requirement(), text ?? ""));
    }
    return [key, isAllowed ? value : usual[key]];
  });
  const words = Object.entries(ACCURACY_WORDS).map(([key, allowed]) => [
    key,
    readWord(query, key, allowed, problems, usual[/** @type {"method"} */ (key)]),
  ]);
  return Object.fromEntries([...numbers, ...words]);
}

/**
 * @param {URLSearchParams} query
 * @param {string} key
 * @param {string[]} allowed
 * @param {string[]} problems
 * @param {string} [usual] stands in for what is not allowed or not there
 */
function readWord(query, key, allowed, problems, usual = allowed[0]) {
  const text = query.get(key);
  if (text !== null && !allowed.includes(text)) {
    problems.push(misfit(key, allowed.join(` ${say("address.or")} `), text));
  }
  return text !== null && allowed.includes(text) ? text : usual;
}

/**
 * The address of a state, from its question mark on.
 * @param {PageState} state
 */
export function writeAddress(state) {
  const { collision, alpha, spin_share, accuracy, impact, pins, sweep, ...words } = state;
  const query = new URLSearchParams();
  for (const { key } of PARAMETERS) {
    // What is not damped says nothing of damping.
    if (key !== "damping" || collision.damping > 0) {
      query.set(key, String(collision[key]));
    }
  }
  for (const key of WORD_KEYS) {
    query.set(key, words[key]);
  }
  if (alpha !== SOLID_ALPHA) {
    query.set("alpha", String(alpha));
  }
  if (spin_share !== SPIN_SHARE.initial) {
    query.set(SPIN_SHARE.key, String(spin_share));
  }
  const step = settingOf(words.scene, words.step).accuracy ?? USUAL_ACCURACY;
  for (const [name, usual] of Object.entries(USUAL_ACCURACY)) {
    const key = /** @type {keyof typeof accuracy} */ (name);
    if (accuracy[key] !== usual || accuracy[key] !== step[key]) {
      query.set(key, String(accuracy[key]));
    }
  }
  for (const [key, value] of Object.entries(impact)) {
    if (value !== null && value !== USUAL_MATERIAL) {
      query.set(key, String(value));
    }
  }
  for (const [key, [usual]] of Object.entries(PAGE_WORDS)) {
    const word = words[/** @type {keyof typeof words} */ (key)];
    if (word !== usual) {
      query.set(key, word);
    }
  }
  // Their commas and semicolons read better as they are.
  const pinned = pins.length > 0 ? `&pins=${writePins(pins)}` : "";
  return `?${query}${pinned}${sweep ? `&sweep=${writeSweep(sweep)}` : ""}`;
}

/**
 * The state at an address of the server that leaves some options open: they stay as they are. A
 * collision is given whole, and a material without what was set by hand.
 * @param {PageState} present
 * @param {string} link from its question mark on
 * @returns {PageState}
 */
export function stateAt(present, link) {
  const options = new URLSearchParams(link);
  const query = new URLSearchParams(writeAddress(present));
  if (options.has("kappa")) {
    query.delete("damping");
  }
  if (options.has("material")) {
    IMPACT_PARAMETERS.forEach(({ key }) => query.delete(key));
  }
  options.forEach((value, key) => query.set(key, value));
  return readAddress(`?${query}`).state;
}

/**
 * Whether a state is what an address asks for. Real spheres have their collision from the velocities.
 * @param {PageState} state
 * @param {string} link
 */
export function isAt(state, link) {
  const target = readAddress(link).state;
  return [...new URLSearchParams(link).keys()].every((key) => {
    if (key in target.collision) {
      const name = /** @type {keyof PageState["collision"]} */ (key);
      return target.scene === "spheres" || target.collision[name] === state.collision[name];
    }
    const [wanted, found] = key in target.impact ? [target.impact, state.impact] : [target, state];
    return Reflect.get(wanted, key) === Reflect.get(found, key);
  });
}
