// @ts-check

/**
 * A stretch of the one clock over flight and contact; `index` counts those of its kind.
 * @typedef {{kind: "flight" | "contact", index: number, from: number, to: number}} Stretch
 */

/** The contact, in which time is stretched, takes the larger half. */
const FLIGHT_SHARES = { 1: [0.2, 0.2], 2: [0.13, 0.22, 0.13] };

/** So long takes the whole of it at full speed, in ms. */
const DURATIONS = { 1: 6000, 2: 10000 };

/**
 * Flight, contact, flight, and so on.
 * @param {1 | 2} times how often it bounces
 * @returns {{stretches: Stretch[], duration: number}}
 */
export function clockOf(times) {
  const flights = FLIGHT_SHARES[times];
  const contact = (1 - flights.reduce((sum, share) => sum + share, 0)) / times;
  /** @type {Stretch[]} */
  const stretches = [];
  let from = 0;
  for (const [index, share] of flights.entries()) {
    stretches.push({ kind: "flight", index, from, to: from + share });
    from += share;
    if (index < times) {
      stretches.push({ kind: "contact", index, from, to: from + contact });
      from += contact;
    }
  }
  return { stretches, duration: DURATIONS[times] };
}

/**
 * Where the clock stands, and how far that stretch has gone, 0 … 1.
 * @param {Stretch[]} stretches
 * @param {number} share of the clock, 0 … 1
 */
export function phaseAt(stretches, share) {
  const found = stretches.find(({ to }) => share < to) ?? stretches[stretches.length - 1];
  const progress = (share - found.from) / (found.to - found.from);
  return { ...found, progress: Math.min(1, Math.max(0, progress)) };
}

/**
 * The share of the clock at which a contact has gone so far.
 * @param {Stretch[]} stretches
 * @param {number} index of the contact
 * @param {number} progress 0 … 1
 */
export function shareAt(stretches, index, progress) {
  const { from, to } = /** @type {Stretch} */ (
    stretches.find((stretch) => stretch.kind === "contact" && stretch.index === index)
  );
  return from + progress * (to - from);
}

/**
 * @typedef {import("./course.js").Course} Course
 * @typedef {{x: number, y: number, radius: number}} Close the ball as the contact has it: where it touches, and how large
 */

/** In the last and the first of a flight the camera goes into the contact, and out of it. */
const APPROACH = 0.45;
/** From here on the contact shows through. */
const FADE = 0.9;

/**
 * How far the camera has gone in, and to which touch.
 * @param {ReturnType<typeof phaseAt>} phase
 * @param {number} times how often it bounces
 */
export function closenessAt({ kind, index, progress }, times) {
  if (kind === "contact") {
    return { closeness: 1, touch: index, isEnd: progress > 0.5 };
  }
  const near = (/** @type {number} */ way) => smooth(Math.max(0, 1 - way / APPROACH));
  const goingIn = index < times ? near(1 - progress) : 0;
  const comingOut = index > 0 ? near(progress) : 0;
  return goingIn >= comingOut
    ? { closeness: goingIn, touch: Math.min(index, times - 1), isEnd: false }
    : { closeness: comingOut, touch: index - 1, isEnd: true };
}

/**
 * Time is stretched as the ball touches: it slows down towards the contact and gathers speed after it.
 * @param {number} progress of a flight on the clock
 * @param {number} index of that flight
 * @param {number} times how often it bounces
 */
export function timeOf(progress, index, times) {
  if (index === 0) {
    return 1 - (1 - progress) ** 2;
  }
  return index === times ? progress ** 2 : smooth(progress);
}

/**
 * The way from the flight's picture into the contact's, so that the ball lies on itself at its end.
 * @param {Course} course
 * @param {number} touch
 * @param {Close} close
 * @param {number} closeness 0 … 1
 */
export function cameraAt({ radius, ground, touches }, touch, close, closeness) {
  const most = close.radius / radius;
  const scale = most ** closeness;
  const way = most === 1 ? closeness : (scale - 1) / (most - 1);
  const x = touches[touch] + way * (close.x - touches[touch]);
  const y = ground + way * (close.y - ground);
  const faded = Math.max(0, (closeness - FADE) / (1 - FADE));
  return {
    transform: `translate(${x.toFixed(2)},${y.toFixed(2)})scale(${scale.toFixed(4)})translate(${(-touches[touch]).toFixed(2)},${(-ground).toFixed(2)})`,
    contact: faded,
    // What is around the ball goes first.
    around: Math.max(0, 1 - 2 * closeness),
  };
}

/** @param {number} share 0 … 1 */
function smooth(share) {
  return share * share * (3 - 2 * share);
}
