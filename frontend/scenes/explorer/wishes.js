// @ts-check

import { axesFor, sameAxes } from "../../state/map-view.js";
import { bounceOf, sameCollision } from "../../state/parameters.js";

/**
 * @typedef {import("../../api/queries.js").MapWish} MapWish
 * @typedef {import("../../api/queries.js").CutWish} CutWish
 * @typedef {import("../../state/map-view.js").Counts} Counts
 * @typedef {import("../../state/address/options.js").PageState} PageState
 */

/** @type {Counts} */
export const FULL_MAP = { kappa: 240, gtOverGn: 180 };

/** While μ/α is dragged: the trace goes first. @type {Counts} */
export const QUICK_MAP = { kappa: 80, gtOverGn: 60 };

/** Points along the cut. */
export const FULL_CUT = 800;

/** While κ or μ/α is dragged: the trace goes first. */
export const QUICK_CUT = 200;

/**
 * The map that belongs to a state. It depends on its axes and μ/α alone, and over ψ not on that.
 * @param {Pick<PageState, "collision" | "scale" | "map_y">} state
 * @param {boolean} dragging
 * @param {MapWish | null} asked before
 * @returns {MapWish}
 */
export function mapWish(state, dragging, asked) {
  return {
    ...axesFor(state, dragging, asked?.view),
    counts: dragging ? QUICK_MAP : FULL_MAP,
  };
}

/** Whether it is one of a drag. @param {MapWish} wish */
export function isQuickMap({ counts }) {
  return counts === QUICK_MAP;
}

/** Whether it is one of a drag. @param {CutWish} wish */
export function isQuickCut({ count }) {
  return count === QUICK_CUT;
}

/** @param {MapWish} asked @param {MapWish} wish */
export function isEnoughMap(asked, wish) {
  return sameAxes(asked, wish) && asked.counts.kappa >= wish.counts.kappa;
}

/**
 * The cut that belongs to a state: along the vertical axis of the map at the present κ, or along κ
 * at the present impact.
 * @param {Pick<PageState, "collision" | "scale" | "map_y" | "cut_x">} state
 * @param {boolean} dragging
 * @param {CutWish | null} asked before
 * @returns {CutWish}
 */
export function cutWish(state, dragging, asked) {
  const { kappa, gt_over_gn, mu_over_alpha } = state.collision;
  const axes = axesFor(state, dragging, asked?.view);
  const count = dragging ? QUICK_CUT : FULL_CUT;
  return state.cut_x === "kappa"
    ? { ...axes, along: "kappa", held: gt_over_gn, muOverAlpha: mu_over_alpha, count }
    : { ...axes, along: "gt_over_gn", held: kappa, count };
}

/** @param {CutWish} asked @param {CutWish} wish */
export function isEnoughCut(asked, wish) {
  return (
    asked.along === wish.along &&
    asked.held === wish.held &&
    sameAxes(asked, wish) &&
    asked.count >= wish.count
  );
}

/**
 * The ball that belongs to a state.
 * @param {Pick<PageState, "collision" | "alpha" | "bounce" | "spin_share">} state
 * @param {boolean} dragging
 * @returns {import("../../state/loading/collision-load.js").BallWish}
 */
export function ballWish({ collision, alpha, bounce, spin_share: spinShare }, dragging) {
  const { partner, times } = bounceOf(bounce);
  return { collision, alpha, partner, spinShare, times, dragging };
}

/**
 * Whether what was asked for does: its factors hold for every collision, the next collision does not.
 * @param {import("../../state/loading/collision-load.js").BallWish} asked
 * @param {import("../../state/loading/collision-load.js").BallWish} wish
 */
export function isEnoughBall(asked, wish) {
  const isSameBody = asked.alpha === wish.alpha && asked.partner === wish.partner;
  const isFollowed = asked.times === 2 && sameCollision(asked.collision, wish.collision);
  return isSameBody && (wish.times === 1 || isFollowed);
}
