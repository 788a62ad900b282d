// @ts-check

import { regimeOf } from "../regimes.js";
import { arrowPath, round } from "./arrow.js";
import { stateAt } from "./contact-motion.js";

/**
 * @typedef {import("./contact-motion.js").Motion} Motion
 * @typedef {import("../../../figures/plot-area.js").Size} Size
 * @typedef {import("./arrow.js").Point} Point
 */

/** The ground under the bodies, with the tracks in it, in pixels. */
export const GROUND = 44;
/** How deep a compression of one flattens the ball, in radii; undamped, it reaches 1.09. */
const RADII_PER_COMPRESSION = 0.12;
/** The longest arrow that leaves its label room, for the largest undamped force, 1.14. */
const LONGEST_ARROW = 50;
const LABEL = 15;
const SPRING_WINDINGS = 7;
const SPRING_HALF_WIDTH = 6;
const SHOE = { width: 30, height: 8 };
const TRACKS = { first: 9, step: 5 };

/**
 * A ball pressed on a plane, seen from the side: its foot is dragged over the plane, and a spring
 * joins the foot to the ball. The foot shows the slip, and what the ball is ahead of its foot is the
 * spring's elongation, each to a scale of its own that fills the picture.
 *
 * @param {Motion} motion
 * @param {number} share of the contact, 0 … 1
 * @param {Size} size in pixels of the design
 * @param {boolean} [isWall] whether it is pressed on a wall, and not on a ball as itself
 */
export function contactScene(motion, share, size, isWall = true) {
  const { contact_duration: duration, episodes } = motion.trace;
  const instant = share * duration;
  const state = stateAt(motion, instant);
  const place = placing(motion, size);
  const ground = size.height - GROUND;
  const shoe = { x: place.foot(state.slip), y: ground - SHOE.height };
  const center = shoe.x + place.ahead(state.elongation);
  const anchor = { x: center, y: ground - place.anchorHeight };
  return {
    ...state,
    instant,
    ground,
    radius: place.radius,
    other: isWall ? "" : otherPath(size, ground, place),
    ball: ballPath(
      center,
      ground,
      place.radius,
      RADII_PER_COMPRESSION * place.radius * state.compression,
    ),
    anchor,
    shoe: { ...shoe, ...SHOE },
    spring: springPath(shoe, anchor),
    normalArrow: arrowPath(anchor, { x: 0, y: -place.pixelsPerForce * state.normalForce }),
    tangentialArrow: arrowPath(anchor, { x: place.pixelsPerForce * state.tangentialForce, y: 0 }),
    tracks: tracks(motion, instant, ground, place.foot, episodes),
    enlarged: place.enlarged,
  };
}

/**
 * How large the ball is and where things come to lie along the plane.
 * @param {Motion} motion
 * @param {Size} size
 */
function placing({ slipRange, largestElongation }, { width, height }) {
  const room = height - GROUND;
  const radius = Math.min(0.27 * width, 1.6 * room, Math.max(150, 0.75 * room));
  const reach = 0.46 * radius;
  const way = Math.max(40, width - 2 * radius - 2 * reach);
  const range = slipRange.max - slipRange.min;
  const middle = slipRange.min / 2 + slipRange.max / 2;
  // As shares of the largest, for the numbers of a collision may be near the ends of what a double holds.
  const slipPerStretch = largestElongation > 0 ? range / largestElongation : Infinity;
  const used = Math.min(way, reach * slipPerStretch);
  const slides = range > 0 && Number.isFinite(range);
  const anchorHeight = 0.47 * Math.min(radius, room);
  const above = room - anchorHeight - LABEL;
  return {
    radius,
    anchorHeight,
    reach: used / 2 + reach + SHOE.width,
    pixelsPerForce: Math.max(0, Math.min(LONGEST_ARROW, above)) / 1.15,
    enlarged: slides ? (reach * slipPerStretch) / used : 1,
    ahead: (/** @type {number} */ elongation) =>
      largestElongation > 0 ? reach * (elongation / largestElongation) : 0,
    foot: (/** @type {number} */ slip) =>
      width / 2 + (slides ? used * ((slip - middle) / range) : 0),
  };
}

/**
 * A circle of which the plane has cut off so much; a pixel at least, for an arc that ends where it
 * begins is not drawn.
 * @param {number} x of its middle
 * @param {number} ground
 * @param {number} radius
 * @param {number} depth
 */
function ballPath(x, ground, radius, depth) {
  const half = Math.sqrt(Math.max(0.25, depth * (2 * radius - depth)));
  const [left, right] = [x - half, x + half].map(round);
  const r = round(radius);
  return `M${left},${ground}A${r},${r} 0 1 1 ${right},${ground}Z`;
}

/**
 * The ball below, flat as far as the foot may come.
 * @param {Size} size
 * @param {number} ground
 * @param {{radius: number, reach: number}} place
 */
function otherPath({ width }, ground, { radius, reach }) {
  const [left, right] = [width / 2 - reach, width / 2 + reach].map(round);
  const r = round(Math.max(radius, 1.2 * reach));
  return `M${left},${ground}A${r},${r} 0 1 0 ${right},${ground}Z`;
}

/**
 * A coil from one point to another, as long as they are apart.
 * @param {Point} from
 * @param {Point} to
 */
function springPath(from, to) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy) || 1;
  const aside = { x: (-dy / length) * SPRING_HALF_WIDTH, y: (dx / length) * SPRING_HALF_WIDTH };
  let path = `M${round(from.x)},${round(from.y)}`;
  for (let i = 0; i < 2 * SPRING_WINDINGS; i += 1) {
    const along = 0.1 + (0.8 * (i + 0.5)) / (2 * SPRING_WINDINGS);
    const side = i % 2 === 0 ? 1 : -1;
    const x = from.x + along * dx + side * aside.x;
    const y = from.y + along * dy + side * aside.y;
    path += `L${round(x)},${round(y)}`;
  }
  return `${path}L${round(to.x)},${round(to.y)}`;
}

/**
 * What the foot has done until an instant, one under another: how far it slid, or where it stuck.
 * @param {Motion} motion
 * @param {number} instant
 * @param {number} ground
 * @param {(slip: number) => number} foot
 * @param {import("../../../api/answers.js").Episode[]} episodes
 */
function tracks(motion, instant, ground, foot, episodes) {
  const step = Math.min(TRACKS.step, (GROUND - TRACKS.first - 5) / Math.max(1, episodes.length));
  return episodes
    .filter(({ start }) => start <= instant)
    .map((episode, i) => ({
      regime: regimeOf(episode),
      from: round(foot(stateAt(motion, episode.start).slip)),
      to: round(foot(stateAt(motion, Math.min(instant, episode.end)).slip)),
      y: round(ground + TRACKS.first + i * step),
    }));
}
