// @ts-check

/**
 * What pictures over the map's axes are made of.
 * @typedef {import("../state/map-view.js").MapAxes} MapAxes
 * @typedef {MapAxes & {counts: import("../state/map-view.js").Counts}} MapWish
 * @typedef {MapAxes & {along: "gt_over_gn" | "kappa", held: number}} CutAxes with the value that
 *   the other of the two has all along the cut
 * @typedef {CutAxes & {count: number}} CutWish
 * @typedef {MapWish & {accuracy: Record<string, string>}} ErrorMapWish
 */

const TRACE_COLUMNS =
  "time,compression,normal_force,tangential_force_over_mu,tangential_velocity,spring_elongation,tangential_energy";
const CUT_COLUMNS = "epsilon_t,switches,coulomb,stiff_bound,stiff_asymptote";

/** What `/collision` is asked. @param {import("../state/parameters.js").Collision} collision */
export function collisionQuery({ kappa, mu_over_alpha, gt_over_gn, damping }) {
  return { ...inWords({ kappa, mu_over_alpha, gt_over_gn }), ...dampingQuery(damping) };
}

/** Only where there is any. @param {number} damping @returns {Record<string, string>} */
function dampingQuery(damping) {
  return damping > 0 ? { damping: String(damping) } : {};
}

/**
 * What `/collision` is asked where ε_t alone is wanted.
 * @param {import("../state/parameters.js").Collision} collision
 * @param {Record<string, string>} accuracy
 */
export function answerQuery(collision, accuracy) {
  return { ...collisionQuery(collision), quantities: "epsilon_t", ...accuracy };
}

/** What `/trace` is asked. @param {import("../state/parameters.js").Collision} collision */
export function traceQuery(collision) {
  return {
    ...collisionQuery(collision),
    samples: String(samplesFor(collision.kappa)),
    quantities: TRACE_COLUMNS,
  };
}

/**
 * A ball that bounces: its collision and what that does not tell of it.
 * @typedef {object} Ball
 * @property {import("../state/parameters.js").Collision} collision
 * @property {number} alpha
 * @property {"wall" | "sphere"} partner
 * @property {number} spinShare
 */

/** What `/bounce` is asked. @param {Ball} ball */
export function bounceQuery({ collision, alpha, partner, spinShare }) {
  return {
    ...collisionQuery(collision),
    alpha: String(alpha),
    partner,
    spin_share: String(spinShare),
  };
}

/** What `/map` is asked. @param {MapWish} wish */
export function mapQuery({ muOverAlpha, view, counts }) {
  return {
    mu_over_alpha: String(muOverAlpha),
    kappa_min: String(view.kappa.min),
    kappa_max: String(view.kappa.max),
    kappa_count: String(counts.kappa),
    kappa_scale: view.scale,
    gt_over_gn_min: String(view.gtOverGn.min),
    gt_over_gn_max: String(view.gtOverGn.max),
    gt_over_gn_count: String(counts.gtOverGn),
    gt_over_gn_scale: view.scale,
    ...dampingQuery(view.damping),
  };
}

/** What `/map` is asked for its error. @param {ErrorMapWish} wish */
export function errorMapQuery({ accuracy, ...wish }) {
  return { ...mapQuery(wish), quantities: "error", ...accuracy };
}

/**
 * What `/trace` is asked for the steps of a method: of the exact columns, none that costs.
 * @param {import("../state/parameters.js").Collision} collision
 * @param {Record<string, string>} accuracy
 */
export function steppedQuery(collision, accuracy) {
  return {
    ...collisionQuery(collision),
    samples: "2",
    quantities: "time",
    episode_limit: "0",
    ...accuracy,
  };
}

/**
 * What `/steps` is asked.
 * @param {import("../state/parameters.js").Collision | string} where a collision, or a region by its name
 * @param {string} error
 * @returns {Record<string, string>}
 */
export function stepsQuery(where, error) {
  return { ...(typeof where === "string" ? { region: where } : collisionQuery(where)), error };
}

/** What `/cut` is asked. @param {CutWish} wish */
export function cutQuery({ along, held, muOverAlpha, view, count }) {
  const { min, max } = along === "kappa" ? view.kappa : view.gtOverGn;
  return {
    along,
    [along === "kappa" ? "gt_over_gn" : "kappa"]: String(held),
    mu_over_alpha: String(muOverAlpha),
    minimum: String(min),
    maximum: String(max),
    count: String(count),
    scale: view.scale,
    quantities: CUT_COLUMNS,
    ...dampingQuery(view.damping),
  };
}

/**
 * Samples enough to draw the free swings of the spring, of which there are about √κ/2 in a contact.
 * @param {number} kappa
 */
export function samplesFor(kappa) {
  return Math.min(2000, Math.max(300, Math.ceil(10 * Math.sqrt(kappa))));
}

/**
 * The values of an axis, as the server has them, but for rounding.
 * @param {import("../state/scales.js").Scale} axis
 * @param {"linear" | "log"} scale
 * @param {number} count
 */
function valuesOf({ min, max }, scale, count) {
  const [from, to] = scale === "log" ? [Math.log(min), Math.log(max)] : [min, max];
  return Float64Array.from({ length: count }, (_, i) => {
    const value = from + (to - from) * (i / (count - 1));
    return Math.min(max, Math.max(min, scale === "log" ? Math.exp(value) : value));
  });
}

/** The values along both axes of a map. @param {MapWish} wish */
export function mapValues({ view, counts }) {
  return {
    kappa: valuesOf(view.kappa, view.scale, counts.kappa),
    gtOverGn: valuesOf(view.gtOverGn, view.scale, counts.gtOverGn),
  };
}

/** The values along a cut. @param {CutWish} wish */
export function cutValues({ along, view, count }) {
  return valuesOf(along === "kappa" ? view.kappa : view.gtOverGn, view.scale, count);
}

/** @param {Record<string, number>} numbers */
function inWords(numbers) {
  return Object.fromEntries(Object.entries(numbers).map(([key, value]) => [key, String(value)]));
}
