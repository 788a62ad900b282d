// @ts-check

import { IMPACT_PARAMETERS } from "./impact.js";
import { stepOf } from "./lesson.js";
import { ofVisits } from "./memory.js";
import { PARAMETERS, SPIN_SHARE } from "./parameters.js";

/** @typedef {import("./address/options.js").PageState} PageState */

/**
 * The scenes of the page in the order of its navigation; the first is the usual one. What belongs to
 * some of them alone carries their ids as `data-scene`.
 * @type {{id: string, hasTrace: boolean}[]} `hasTrace`: whether it shows the collision over time
 */
export const SCENES = [
  { id: "explorer", hasTrace: true },
  { id: "spheres", hasTrace: false },
  { id: "accuracy", hasTrace: true },
  { id: "paper", hasTrace: false },
  { id: "lesson", hasTrace: true },
];

/** Panels that belong to one scene. */
export const PANELS = {
  explorer: ["force", "velocity", "map", "cut", "contact", "compare"],
  accuracy: ["tradeoff", "error_map", "overlay", "steps", "codes"],
  spheres: ["velocities", "sphere_cut", "impact", "place"],
  paper: ["paper", "collapse", "stiff_law", "switch_law"],
};

/** The values that a frame of a scene may have sliders for. @param {string} scene */
export function slidersOf(scene) {
  if (scene === "paper") {
    return [];
  }
  const keys = (scene === "spheres" ? IMPACT_PARAMETERS : PARAMETERS).map(({ key }) => key);
  return scene === "explorer" ? [...keys, SPIN_SHARE.key] : keys;
}

/** Scenes with a plain face, the explorer's pictures; what the others are about are numbers that it leaves out. */
const TWO_FACED = ["explorer", "lesson"];

/** The explorer's pictures, by the names of their panels, of which a lecturer picks one or two. */
export const PRESENTED = ["contact", "force", "velocity", "map", "cut"];

/**
 * The panels that are presented: those that a step of the lesson looks at, else those picked.
 * @param {Pick<PageState, "scene" | "step" | "left" | "right">} state
 */
export function presentedIn({ scene, step, left, right }) {
  return [...new Set(scene === "lesson" ? stepOf(step).look : [left, right])];
}

/** @param {Pick<PageState, "scene" | "presenting" | "embed">} state */
export function isPresented({ scene, presenting, embed }) {
  return presenting === "on" && TWO_FACED.includes(scene) && embed === "none";
}

/** Whether a state of the page has a plain face and an expert one. @param {Pick<PageState, "scene" | "embed">} state */
export function isTwoFaced({ scene, embed }) {
  return TWO_FACED.includes(scene) && embed === "none";
}

/** The panels that stand alone, in their order. @param {Pick<PageState, "embed">} state */
export function embedded({ embed }) {
  return embed === "none" ? [] : embed.split(",");
}

/**
 * The values that may be moved where the author of a frame has said which; null where nothing is locked.
 * @param {Pick<PageState, "embed" | "sliders">} state
 */
export function offered({ embed, sliders }) {
  if (embed === "none" || sliders === "usual") {
    return null;
  }
  return sliders === "none" ? [] : sliders.split(",");
}

/**
 * Whoever chose a face finds it at the next visit; the lesson begins plain, and what is presented is.
 * @param {Pick<PageState, "scene" | "embed" | "face" | "presenting">} state
 */
export function isPlain(state) {
  const { scene, face } = state;
  const usual = scene !== "lesson" && ofVisits.recall("face") === "expert" ? "expert" : "plain";
  const chosen = face === "usual" ? usual : face;
  return isTwoFaced(state) && (isPresented(state) || chosen === "plain");
}

/**
 * Which of the explorer's pictures that are asked for by themselves are to be seen.
 * @param {Pick<PageState, "scene" | "embed" | "face" | "step" | "presenting" | "left" | "right">} state
 */
export function picturesOf(state) {
  const { scene, embed } = state;
  const isHere = TWO_FACED.includes(scene);
  const alone = embedded(state);
  const isShown = (/** @type {string} */ name) =>
    isHere && (embed === "none" || alone.includes(name));
  const isPicked = (scene === "lesson" || isPresented(state)) && presentedIn(state).includes("cut");
  const cut = isShown("cut") && (isPicked || !isPlain(state));
  // The cut has the colours of the map.
  return { map: isShown("map") || cut, cut, contact: isShown("contact") };
}
