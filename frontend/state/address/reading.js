// @ts-check

import { PLAIN_SYMBOLS } from "../../format/symbols.js";
import { say } from "../../format/words.js";
import { KNOBS, USUAL_ACCURACY } from "../accuracy.js";
import { IMPACT_PARAMETERS, impactOf, INERTIAS, SECONDS } from "../impact.js";
import { settingOf } from "../lesson.js";
import { PARAMETERS, parseNumber, SOLID_ALPHA, SPIN_SHARE } from "../parameters.js";
import { readPins } from "../pins.js";
import { misfit, misread } from "../requirements.js";
import { PANELS, slidersOf } from "../scenes.js";
import { readSweep } from "../sweep.js";
import { WORDS, PAGE_WORDS, ACCURACY_WORDS, LISTS, USUAL_MATERIAL } from "./options.js";

/** @typedef {import("./options.js").PageState} PageState */

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
  Object.assign(words, readFrame(query, words.scene, inWords));
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
 * The panels that stand alone, which bring their scene along, and the values that may be moved there.
 * @param {URLSearchParams} query
 * @param {string} usual the scene of what belongs to several
 * @param {string[]} problems to which those of it are added
 */
function readFrame(query, usual, problems) {
  const own = Object.entries(PANELS);
  const named = query.get("embed")?.split(",") ?? [];
  const first = named.find((name) => own.some(([, panels]) => panels.includes(name)));
  const [scene, panels] = own.find(([, those]) => those.includes(first ?? "")) ?? [
    usual,
    own.flatMap(([, those]) => those),
  ];
  const embed = readList(query, "embed", ["result", ...panels], problems) ?? LISTS.embed;
  const sliders = readList(query, "sliders", slidersOf(scene), problems) ?? LISTS.sliders;
  return { scene, embed, sliders: embed === LISTS.embed ? LISTS.sliders : sliders };
}

/**
 * What of a list parted by commas may be in it, each once, or `none`; null where nothing is.
 * @param {URLSearchParams} query
 * @param {string} key
 * @param {string[]} allowed
 * @param {string[]} problems to which that of it is added
 */
function readList(query, key, allowed, problems) {
  const text = query.get(key);
  if (text === null || text === "none") {
    return text;
  }
  const names = [...new Set(text.split(","))];
  const wrong = names.filter((name) => !allowed.includes(name));
  if (wrong.length > 0) {
    const requirement = ["none", ...allowed].join(` ${say("address.or")} `);
    problems.push(misfit(key, requirement, wrong.join(",")));
  }
  return names.filter((name) => allowed.includes(name)).join(",") || null;
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
 * @param {Pick<import("../parameters.js").Parameter, "admits" | "requirement"> & {key: string}} parameter
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
 * @param {import("../accuracy.js").Accuracy} usual
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
