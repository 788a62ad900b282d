// @ts-check

import { significant, typable } from "../format/number.js";
import { TEXT_SYMBOLS } from "../format/symbols.js";
import { say } from "../format/words.js";
import {
  clamp,
  isBeyond,
  linearScale,
  logScale,
  placeWithin,
  relabelled,
  stepAbove,
} from "./scales.js";

/**
 * What is to be asked of `/map` and how its axes lie. Over ψ, the map is that of μ/α = 1, whose
 * g_t/g_n are ψ.
 * @typedef {object} MapView
 * @property {"linear" | "log"} scale
 * @property {"gt_over_gn" | "psi"} vertical
 * @property {import("./scales.js").Scale} kappa
 * @property {import("./scales.js").Scale} gtOverGn
 * @property {number} damping η of every collision on it
 */

/**
 * What the horizontal axis is labelled with; what lies where does not change.
 * @typedef {object} HorizontalAxis
 * @property {"kappa" | "alpha_kappa"} symbol
 * @property {number} [alpha] by which the paper's axis differs from κ
 * @property {import("./scales.js").Scale} scale
 */

/** @typedef {import("./parameters.js").Collision} Collision */

/**
 * The usual axes, where the paper draws Figs. 3 and 4, and how far they may reach for a collision
 * beyond them: as far as the sliders. On a linear axis of more there is nothing to see.
 */
const AXES = {
  linear: { kappa: [0.1, 70], gt_over_gn: [0.01, 4], psi: [0.01, 3], reach: 15 },
  log: { kappa: [0.1, 1000], gt_over_gn: [0.005, 5], psi: [0.005, 5], reach: 1e9 },
};

/**
 * The axes of the map around a collision: the usual ones, or the next of 1, 2, 5, 10 … that reach it.
 * @param {Collision} collision
 * @param {{scale: "linear" | "log", map_y: "gt_over_gn" | "psi"}} options
 * @returns {MapView}
 */
export function mapView(collision, { scale, map_y: vertical }) {
  const make = scale === "log" ? logScale : linearScale;
  const { kappa, [vertical]: usual, reach } = AXES[scale];
  const both = scale === "log";
  return {
    scale,
    vertical,
    kappa: make(...reaching(kappa, collision.kappa, reach, both)),
    gtOverGn: make(...reaching(usual, heightOf(vertical, collision), reach, both)),
    damping: collision.damping,
  };
}

/**
 * @typedef {object} MapAxes
 * @property {MapView} view
 * @property {number} muOverAlpha to ask with, so that the answer lies on these axes
 *
 * @typedef {{kappa: number, gtOverGn: number}} Counts cells along each axis
 */

/**
 * What a map or a cut of a state is asked for with. A drag keeps the axes, perhaps beyond them; they follow when it is over.
 * @param {{collision: Collision} & Parameters<typeof mapView>[1]} state
 * @param {boolean} dragging
 * @param {MapView} [held] the axes so far
 * @returns {MapAxes}
 */
export function axesFor({ collision, ...options }, dragging, held) {
  const view = dragging && held ? heldView(held, collision) : mapView(collision, options);
  return { view, muOverAlpha: axesMuOverAlpha(view, collision) };
}

/**
 * @param {MapView} view
 * @param {Collision} collision
 */
function heldView(view, { damping }) {
  return view.damping === damping ? view : { ...view, damping };
}

/**
 * Whether two wishes are for the same axes and the same μ/α there.
 * @param {MapAxes} asked
 * @param {MapAxes} wish
 */
export function sameAxes(asked, wish) {
  return asked.muOverAlpha === wish.muOverAlpha && sameView(asked.view, wish.view);
}

/**
 * The scale on which the map can show a collision, for one that is chosen and not dragged to.
 * @param {Collision} collision
 * @param {Parameters<typeof mapView>[1]} options
 */
export function scaleFor(collision, options) {
  return isBeyond(placeOnMap(mapView(collision, options), collision)) ? "log" : options.scale;
}

/**
 * @param {MapView} view
 * @param {HorizontalAxis["symbol"]} symbol
 * @param {number} alpha of the bodies, for the axis of Figs. 3 and 4
 * @returns {HorizontalAxis}
 */
export function horizontalAxis({ kappa }, symbol, alpha) {
  return symbol === "kappa"
    ? { symbol, scale: kappa }
    : { symbol, alpha, scale: relabelled(kappa, alpha) };
}

/**
 * The parameter at a share of the axis that a cut runs along, to four digits.
 * @param {MapView} view
 * @param {"gt_over_gn" | "kappa"} along
 * @param {number} share
 * @param {number} muOverAlpha
 */
export function placeOnCut(view, along, share, muOverAlpha) {
  const { kappa, gt_over_gn } = collisionAt(view, share, share, muOverAlpha);
  return along === "kappa" ? { kappa } : { gt_over_gn };
}

/**
 * The μ/α to ask with, so that the answer lies on the axes of the view.
 * @param {MapView} view
 * @param {Collision} collision
 */
export function axesMuOverAlpha({ vertical }, collision) {
  return vertical === "psi" ? 1 : collision.mu_over_alpha;
}

/**
 * Whether two views ask for the same axes.
 * @param {MapView} a
 * @param {MapView} b
 */
export function sameView(a, b) {
  return (
    a.scale === b.scale &&
    a.vertical === b.vertical &&
    a.damping === b.damping &&
    a.kappa.min === b.kappa.min &&
    a.kappa.max === b.kappa.max &&
    a.gtOverGn.min === b.gtOverGn.min &&
    a.gtOverGn.max === b.gtOverGn.max
  );
}

/**
 * Where a collision stands on the map, as shares from the left and from the bottom.
 * @param {MapView} view
 * @param {Collision} collision
 */
export function placeOnMap(view, collision) {
  const x = view.kappa.toShare(collision.kappa);
  return placeWithin(x, view.gtOverGn.toShare(heightOf(view.vertical, collision)));
}

/**
 * The parameters at a place of the map, to four digits.
 * @param {MapView} view
 * @param {number} x share from the left
 * @param {number} y share from the bottom
 * @param {number} muOverAlpha
 */
export function collisionAt(view, x, y, muOverAlpha) {
  return {
    kappa: Number(view.kappa.fromShare(clamp(x)).toPrecision(4)),
    gt_over_gn: gtOverGnAt(view, y, muOverAlpha),
  };
}

/**
 * The g_t/g_n at a share of the vertical axis, to four digits.
 * @param {MapView} view
 * @param {number} share
 * @param {number} muOverAlpha
 */
export function gtOverGnAt({ vertical, gtOverGn }, share, muOverAlpha) {
  const value = gtOverGn.fromShare(clamp(share));
  return Number((vertical === "psi" ? value * muOverAlpha : value).toPrecision(4));
}

/**
 * Where a collision lies on the vertical axis. Without friction ψ is infinite, at rest too.
 * @param {MapView["vertical"]} vertical
 * @param {Collision} collision
 */
export function heightOf(vertical, { gt_over_gn, mu_over_alpha }) {
  if (vertical === "gt_over_gn") {
    return gt_over_gn;
  }
  return mu_over_alpha === 0 ? Infinity : gt_over_gn / mu_over_alpha;
}

/** What the vertical axis is called. @param {MapView["vertical"]} vertical */
export const impactName = (vertical) =>
  vertical === "psi" ? TEXT_SYMBOLS.psi : TEXT_SYMBOLS.gt_over_gn;

/**
 * What a collision has along each axis of a map, in words.
 * @param {MapView} view
 * @param {Collision} collision
 */
export function axesInWords({ vertical }, collision) {
  const { kappa, gt_over_gn: ratio } = collision;
  return {
    x: `κ = ${typable(kappa)}`,
    y:
      vertical === "psi"
        ? `${impactName(vertical)} = ${significant(heightOf(vertical, collision))}`
        : `${impactName(vertical)} = ${typable(ratio)}`,
  };
}

/**
 * What the rows of a table over a map mean, in words, and where a collision stands among them.
 * @param {MapView} view
 * @param {Collision} collision
 */
export function rowsOf({ vertical }, collision) {
  return {
    along: impactName(vertical),
    here: heightOf(vertical, collision),
    frame:
      vertical === "psi"
        ? say("map.atAnyFriction")
        : say("map.atFriction", { value: significant(collision.mu_over_alpha) }),
  };
}

/**
 * @param {number[]} usual
 * @param {number} value
 * @param {number} reach the factor by which an end may move out
 * @param {boolean} both whether the lower end moves too
 * @returns {[number, number]}
 */
function reaching([min, max], value, reach, both) {
  const high = value > max && value <= max * reach ? stepAbove(value) : max;
  const low = both && value < min && value >= min / reach ? 1 / stepAbove(1 / value) : min;
  return [low, high];
}
