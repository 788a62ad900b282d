// @ts-check

import { speedOf } from "./motions.js";

/**
 * @typedef {import("./motions.js").Motion} Motion
 * @typedef {import("../../../figures/plot-area.js").Size} Size
 * @typedef {{x: number, y: number, turn: number}} Place of the ball's centre in pixels of the design, turned clockwise by so many degrees
 */

/**
 * A flight before, between or after collisions. Times are counted from a touch in units in which the
 * ball comes one height nearer, and lengths are heights.
 * @typedef {object} Flight
 * @property {Motion} motion at that touch
 * @property {number} begin
 * @property {number} end
 * @property {number} from where along the wall that touch is
 * @property {number} fall half of gravity, 0 without
 */

/**
 * What of a course is drawn for a size, with the scale that lets it fill that.
 * @typedef {object} Course
 * @property {number} radius of the ball, in pixels
 * @property {number} pixels to a height
 * @property {number} ground where the bodies touch
 * @property {number} approach what the ball comes with along the normal
 * @property {number[]} touches where along the wall
 * @property {(flight: number, progress: number) => Place} at
 * @property {Place[]} ghosts at equal times, and where it touches
 * @property {string} path of the centre
 * @property {{motion: Motion, touch: number, place: Place, comes: boolean, reach: {x: number, y: number}}[]} marked
 *   each motion with the touch that it leads to or from, where its spin is shown, and how far it gets in half a height's time
 */

/** Around the ball, for the arrow of its spin. */
const PAD = 11;
const RADII = { least: 9, most: 46 };
/** Of the height to which a ball falls back it is seen coming and going for so many times its fall. */
const SEEN = 1.4;
/** A number beyond what a picture can tell. */
const FASTEST = 1e100;

/**
 * The way of a ball, as large as it finds room. Only between two bounces it is bent by gravity: what a
 * collision does to angles is seen best on straight lines.
 * @param {Motion[]} motions before, after, and after the second collision
 * @param {{isWall: boolean, times: 1 | 2, floor: number, first?: number, last?: number, most?: number}} what against a wall of so many pixels or a ball, which flights, and at most so many pixels to a height
 * @param {Size} size
 * @returns {Course}
 */
export function courseOf(
  motions,
  { isWall, times, floor, first = 0, last = times, most: limit = Infinity },
  { width, height },
) {
  const flights = flightsOf(motions.map(inOwnUnits(motions[0])), times);
  const shown = [...flights.keys()].slice(first, last + 1);
  const ground = isWall ? height - floor : height / 2;
  const radius = Math.max(
    RADII.least,
    Math.min(RADII.most, (isWall ? 0.16 : 0.22) * ground, 0.11 * width),
  );
  const ends = shown.flatMap((i) => [flights[i].begin, flights[i].end].map(alongAt(flights[i])));
  // Against a ball the other one mirrors it about the touch.
  const extent = isWall ? ends : [...ends, ...ends.map((end) => -end)];
  const [least, most] = [Math.min(...extent), Math.max(...extent)];
  const room = {
    width: Math.max(radius, width - 2 * (radius + PAD)),
    height: Math.max(radius, ground - 2 * radius - PAD),
  };
  const pixels = Math.min(limit, room.height, room.width / Math.max(1e-9, most - least));
  const origin = width / 2 - (pixels * (least + most)) / 2;
  const turns = turnsBefore(flights);
  const step = stepFor(flights, pixels / radius);

  /** @param {number} i @param {number} time @returns {Place} */
  function placeAt(i, time) {
    const { motion, fall } = flights[i];
    const risen = motion.normal * time - fall * time ** 2;
    return {
      x: origin + pixels * alongAt(flights[i])(time),
      y: ground - radius - pixels * Math.max(0, risen),
      turn: degrees((turns[i] + motion.spin * time) * (pixels / radius)),
    };
  }

  return {
    radius,
    pixels,
    ground,
    approach: -motions[0].normal,
    touches: flights.slice(1).map(({ from }) => origin + pixels * from),
    at: (i, progress) =>
      placeAt(i, flights[i].begin + progress * (flights[i].end - flights[i].begin)),
    ghosts: shown.flatMap((i) => timesOf(flights[i], step).map((time) => placeAt(i, time))),
    path: shown.map((i) => pathOf(flights[i], (time) => placeAt(i, time))).join(""),
    marked: shown.map((i) => ({
      motion: motions[i],
      touch: Math.max(0, i - 1),
      comes: i === 0,
      place: placeAt(i, showingTime(flights[i], i, times)),
      reach: {
        x: 0.5 * pixels * flights[i].motion.centre,
        y: -0.5 * pixels * Math.abs(flights[i].motion.normal),
      },
    })),
  };
}

/** In units of what the ball comes with along the normal. @param {Motion} before @returns {(motion: Motion) => Motion} */
function inOwnUnits(before) {
  const own = (/** @type {number} */ value) =>
    Math.max(-FASTEST, Math.min(FASTEST, value / -before.normal));
  return ({ normal, centre, spin }) => ({
    normal: own(normal),
    centre: own(centre),
    spin: own(spin),
  });
}

/**
 * @param {Motion[]} motions
 * @param {1 | 2} times
 * @returns {Flight[]}
 */
function flightsOf([before, ...afters], times) {
  if (times === 1) {
    return [
      { motion: before, begin: -1, end: 0, from: 0, fall: 0 },
      { motion: afters[0], begin: 0, end: 1, from: 0, fall: 0 },
    ];
  }
  // Half of gravity lets a ball that loses nothing rise to a height of one: its flight takes four.
  const fall = 0.25;
  const back = afters[0].normal / fall;
  const comes = { motion: before, begin: -SEEN, end: 0, from: 0, fall };
  const hops = { motion: afters[0], begin: 0, end: back, from: 0, fall };
  const leaves = afters[1] && {
    motion: afters[1],
    begin: 0,
    end: SEEN * afters[1].normal,
    from: afters[0].centre * back,
    fall,
  };
  return leaves ? [comes, hops, leaves] : [comes, hops];
}

/** @param {Flight} flight @returns {(time: number) => number} */
function alongAt({ motion, from }) {
  return (time) => from + motion.centre * time;
}

/** How far it has turned before each flight's first touch. @param {Flight[]} flights */
function turnsBefore(flights) {
  let turned = 0;
  return flights.map(({ motion, begin, end }) => {
    const before = turned;
    turned += begin < 0 ? 0 : motion.spin * (end - begin);
    return before;
  });
}

/** When a flight's spin is shown: farthest from the touch. @param {Flight} flight @param {number} i @param {number} times */
function showingTime({ begin, end }, i, times) {
  if (i === 0) {
    return begin;
  }
  return i === times ? end : end / 2;
}

/**
 * The time between two ghosts: as many as stay apart from one another.
 * @param {Flight[]} flights
 * @param {number} radii that a height has
 */
function stepFor(flights, radii) {
  if (flights.some(({ fall }) => fall > 0)) {
    return SEEN / 2;
  }
  const slowest = Math.min(...flights.map(({ motion }) => speedOf(motion)));
  return 1 / Math.min(5, Math.max(2, Math.floor((radii * slowest) / 1.7)));
}

/** Instants of a flight at equal times from its touch, that included. @param {Flight} flight @param {number} step */
function timesOf({ begin, end }, step) {
  const count = Math.floor((end - begin) / step + 1e-6);
  return Array.from({ length: count + 1 }, (_, i) => (begin < 0 ? -i * step : i * step));
}

/**
 * @param {Flight} flight
 * @param {(time: number) => Place} placeAt
 */
function pathOf({ begin, end, fall }, placeAt) {
  const count = fall > 0 ? 24 : 1;
  const points = Array.from({ length: count + 1 }, (_, i) => {
    const { x, y } = placeAt(begin + ((end - begin) * i) / count);
    return `${x.toFixed(1)},${y.toFixed(1)}`;
  });
  return `M${points.join("L")}`;
}

/** In one turn. @param {number} radians */
function degrees(radians) {
  return ((180 / Math.PI) * radians) % 360;
}
