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

/** Whether a state of the page has a plain face and an expert one. @param {Pick<PageState, "scene" | "embed">} state */
export function isTwoFaced({ scene, embed }) {
  return TWO_FACED.includes(scene) && embed === "none";
}

/**
 * Whoever chose a face finds it at the next visit; the lesson begins plain.
 * @param {Pick<PageState, "scene" | "embed" | "face">} state
 */
export function isPlain(state) {
  const { scene, face } = state;
  const usual = scene !== "lesson" && ofVisits.recall("face") === "expert" ? "expert" : "plain";
  return isTwoFaced(state) && (face === "usual" ? usual : face) === "plain";
}

/**
 * Which of the explorer's pictures that are asked for by themselves are to be seen.
 * @param {Pick<PageState, "scene" | "embed" | "face" | "step">} state
 */
export function picturesOf(state) {
  const { scene, embed, step } = state;
  const isHere = TWO_FACED.includes(scene);
  const isShown = (/** @type {string} */ name) => isHere && (embed === "none" || embed === name);
  const isLookedAt = scene === "lesson" && stepOf(step).look.includes("cut");
  const cut = isShown("cut") && (isLookedAt || !isPlain(state));
  // The cut has the colours of the map.
  return { map: isShown("map") || cut, cut, contact: isShown("contact") };
}
