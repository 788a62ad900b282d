// @ts-check

/**
 * A way there and back, in shares of a slider.
 * @typedef {object} Course
 * @property {number} from
 * @property {number} to
 * @property {number} seconds there and back
 * @property {boolean} once
 *
 * @typedef {{share: number, way: 1 | -1}} Place where it is, and whether it goes up or down
 */

/** In so many steps a range is walked where nothing is to move by itself. */
const STEPS = 10;

/**
 * How a parameter's sweep runs on its slider.
 * @param {import("../../state/sweep.js").Sweep} sweep
 * @param {import("../../state/scales.js").Scale} scale of the slider
 * @returns {Course}
 */
export function courseOf({ from, to, seconds, once }, scale) {
  return { from: scale.toShare(from), to: scale.toShare(to), seconds, once };
}

/** @param {Course} course */
export const spanOf = ({ from, to }) => Math.abs(to - from);

/** Where it begins: towards `to`. @param {number} share @param {Course} course @returns {Place} */
export function placeAt(share, { from, to }) {
  return { share, way: from < to ? 1 : -1 };
}

/**
 * Goes on by a distance, turning at both ends; from outside it comes in first.
 * @param {Place} place
 * @param {number} distance in shares
 * @param {Course} course
 * @returns {Place}
 */
export function advance(place, distance, course) {
  let { share, way } = place;
  let left = distance;
  while (left > 0) {
    const ahead = endAhead({ share, way }, course);
    way = ahead.way;
    if (left < ahead.room) {
      return { share: share + way * left, way };
    }
    share = ahead.end;
    left -= ahead.room;
  }
  return { share, way };
}

/**
 * A tenth of the range on, at most to its end, where the next one turns back.
 * @param {Place} place
 * @param {Course} course
 * @returns {Place}
 */
export function stepOn(place, course) {
  const { way, end, room } = endAhead(place, course);
  const step = spanOf(course) / STEPS;
  // What rounding leaves before an end is no step.
  return { share: room < 1.01 * step ? end : place.share + way * step, way };
}

/**
 * The end that comes next, and how far it is: an end that is reached is turned at.
 * @param {Place} place
 * @param {Course} course
 * @returns {{way: 1 | -1, end: number, room: number}}
 */
function endAhead({ share, way }, { from, to }) {
  const [low, high] = [Math.min(from, to), Math.max(from, to)];
  const isUp = share <= low || (way > 0 && share < high);
  const end = isUp ? high : low;
  return { way: isUp ? 1 : -1, end, room: Math.abs(end - share) };
}

/**
 * A slider that goes there and back, by frames that somebody else counts.
 * @param {object} options
 * @param {() => Course} options.course as it is now: it may be changed on the way
 * @param {(share: number) => void} options.onShare
 * @param {() => void} options.onEnd of one that goes once
 * @param {(task: (now: number) => void) => unknown} options.nextFrame
 */
export function createRun({ course, onShare, onEnd, nextFrame }) {
  /** @type {symbol | null} of the run under way */
  let run = null;

  return {
    isRunning: () => run !== null,

    /** @param {number} share where it is */
    start(share) {
      const mine = Symbol("run");
      let place = placeAt(share, course());
      let gone = 0;
      /** @type {number | null} */
      let before = null;
      const { from, to } = course();
      const outside = Math.max(0, Math.min(from, to) - share, share - Math.max(from, to));
      run = mine;
      nextFrame(function step(now) {
        if (run !== mine) {
          return;
        }
        const present = course();
        const whole = 2 * spanOf(present);
        const due = (whole * (now - (before ?? now))) / (1000 * present.seconds);
        const distance = present.once ? Math.min(due, outside + whole - gone) : due;
        before = now;
        gone += due;
        place = advance(place, distance, present);
        if (distance > 0) {
          onShare(place.share);
        }
        if (present.once && gone >= outside + whole) {
          run = null;
          onEnd();
        } else if (run === mine) {
          nextFrame(step);
        }
      });
    },

    stop() {
      run = null;
    },
  };
}
