// @ts-check

import { stepOf } from "./lesson.js";
import { ofVisits } from "./memory.js";

/** @typedef {import("./url.js").PageState} PageState */

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
  const isShown = (/** @type {string} */ name) => isHere && (embed === "none" || embed === name);
  const isPicked = (scene === "lesson" || isPresented(state)) && presentedIn(state).includes("cut");
  const cut = isShown("cut") && (isPicked || !isPlain(state));
  // The cut has the colours of the map.
  return { map: isShown("map") || cut, cut, contact: isShown("contact") };
}
