// @ts-check

import { arcPath, around, arrowPath, bentArrowPath } from "./arrow.js";
import { angleOf } from "./motions.js";

/** The arcs of the angles begin so far outside of the ball, and that of what leaves outside of the other. */
const ARC = { gap: 8, apart: 10 };
/** An angle's number stands beside its arrow, so far outside of its arc and so many degrees on. */
const LABEL = { gap: 6, beside: 15 };
/** How far an arrow bends for a rim as fast as the normal approach, in degrees, and at least and at most. */
const BEND = { one: 100, least: 40, most: 300 };
/** A rim that is slower does not turn to see, over the normal approach. */
const NO_SPIN = 1e-3;

/**
 * What is drawn of velocities, spins and angles: lines for each motion, and where its angle is told.
 * @param {import("./course.js").Course} course
 */
export function marksOf({ marked, touches, radius, ground, approach }) {
  const angles = marked.map(({ motion, comes }) => (comes ? -1 : 1) * angleOf(motion));
  return marked.map(({ motion, touch, comes, place, reach }, i) => {
    const middle = { x: touches[touch], y: ground - radius };
    const angle = angles[i];
    const arc = radius + ARC.gap + (comes ? 0 : ARC.apart);
    const other = marked.findIndex((each, k) => k !== i && each.touch === touch);
    const aside = angle + LABEL.beside * sideOf(angle, angles[other] ?? -angle);
    const lines = {
      normal: `M${middle.x.toFixed(1)},${middle.y.toFixed(1)}v${(-arc - 8).toFixed(1)}`,
      arc: Math.abs(angle) < 1 ? "" : arcPath(middle, arc, 0, angle),
      velocity: comes
        ? arrowPath({ x: middle.x - reach.x, y: middle.y + reach.y }, { x: reach.x, y: -reach.y })
            .path
        : arrowPath(middle, reach).path,
      ...spinPaths(motion.spin / approach, place, radius + 5),
    };
    return {
      lines: Object.entries(lines).map(([name, path]) => ({ name, path })),
      label: { ...around(middle, arc + LABEL.gap, aside), isLeft: aside < angle },
    };
  });
}

/**
 * To which side of its arrow an angle is told: away from the other arrow at that touch.
 * @param {number} angle
 * @param {number} other
 */
function sideOf(angle, other) {
  return angle < other || (angle === other && angle < 0) ? -1 : 1;
}

/**
 * @param {number} spin of the rim over the normal approach
 * @param {import("./arrow.js").Point} middle
 * @param {number} radius
 */
function spinPaths(spin, middle, radius) {
  if (Math.abs(spin) < NO_SPIN) {
    return { spin: "", "spin-head": "" };
  }
  const bend = Math.min(BEND.most, Math.max(BEND.least, BEND.one * Math.abs(spin)));
  const half = (Math.sign(spin) * bend) / 2;
  const { shaft, head } = bentArrowPath(middle, radius, -half, half);
  return { spin: shaft, "spin-head": head };
}
