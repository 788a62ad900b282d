// @ts-check

import { say } from "../../../format/words.js";
import { significant } from "../../../format/number.js";

/**
 * How the ball moves and turns between its collisions, over g_n of the first one: away from the other
 * body, along g_t, and Rω, positive as it rolls along g_t.
 * @typedef {{normal: number, centre: number, spin: number}} Motion
 */

/**
 * A collision of the ball by what of it the ball feels.
 * @typedef {{gtOverGn: number, epsilonT: number, epsilonN: number}} Collided with the sign of g_t
 */

/**
 * What collisions make of a ball: by the factors of the server, which the bodies have alone, what leaves
 * is linear in ε_t.
 * @param {Pick<import("../../../api/answers.js").Bounces, "mass_share" | "centre_change" | "spin_change">} factors
 * @param {number} spinShare of g_t before the first
 * @param {Collided[]} collided one after another
 * @returns {Motion[]} before, and after each
 */
export function motionsOf({ mass_share, centre_change, spin_change }, spinShare, collided) {
  const own = mass_share * collided[0].gtOverGn;
  const motions = [
    { normal: -mass_share, centre: (1 - spinShare) * own, spin: 0 - spinShare * own },
  ];
  let approach = 1;
  for (const { gtOverGn, epsilonT, epsilonN } of collided) {
    const { centre, spin } = motions[motions.length - 1];
    const lost = (1 - epsilonT) * approach;
    approach *= epsilonN;
    motions.push({
      normal: mass_share * approach,
      centre: centre + centre_change * lost * gtOverGn,
      spin: spin + spin_change * lost * gtOverGn,
    });
  }
  return motions;
}

/** The angle of the path to the normal in degrees, negative where it leads back. @param {Motion} motion */
export function angleOf({ normal, centre }) {
  return (180 / Math.PI) * Math.atan2(centre, Math.abs(normal));
}

/** @param {Motion} motion */
export function speedOf({ normal, centre }) {
  return Math.hypot(normal, centre);
}

/** A spin below is none to speak of, over g_n. */
const NO_SPIN = 1e-3;

/**
 * What a bounce does, in words.
 * @param {Motion[]} motions before, after, and after the second collision
 */
export function bounceInWords([before, after, again]) {
  const goesBack = after.centre * (before.centre - before.spin) < 0;
  const first = say(goesBack ? "bounce.sentenceBack" : "bounce.sentence", {
    in: degreesOf(before),
    spinIn: spinOf(before),
    out: degreesOf(after),
    spinOut: spinOf(after),
  });
  return again
    ? `${first} ${say("bounce.sentenceAgain", { out: degreesOf(again), spinOut: spinOf(again) })}`
    : first;
}

/** @param {Motion} motion */
function degreesOf(motion) {
  const degrees = Math.abs(angleOf(motion));
  return degrees < 10 ? significant(degrees, 2) : degrees.toFixed(0);
}

/** @param {Motion} motion */
function spinOf({ spin }) {
  if (Math.abs(spin) < NO_SPIN) {
    return say("bounce.noSpin");
  }
  return say(spin > 0 ? "bounce.turningForward" : "bounce.turningBackward");
}
