// @ts-check

/** @typedef {{x: number, y: number}} Point in pixels of the design */

/**
 * A shaft with a head; nothing where it would be shorter than its head.
 * @param {Point} from
 * @param {Point} by
 */
export function arrowPath(from, by) {
  const length = Math.hypot(by.x, by.y);
  if (length < 2) {
    return { path: "", tip: from };
  }
  const reach = Math.min(7, 0.6 * length);
  const along = { x: by.x / length, y: by.y / length };
  const tip = { x: from.x + by.x, y: from.y + by.y };
  const back = { x: tip.x - reach * along.x, y: tip.y - reach * along.y };
  return { path: `M${at(from)}L${at(back)}${headPath(tip, along, reach)}`, tip };
}

/**
 * An arrow bent round a point, its shaft and its head; angles in degrees from the top, clockwise.
 * @param {Point} middle
 * @param {number} radius
 * @param {number} from
 * @param {number} to
 */
export function bentArrowPath(middle, radius, from, to) {
  const sense = Math.sign(to - from);
  const reach = Math.min(8, 0.5 * radius);
  const bend = (180 / Math.PI) * (reach / radius);
  const tip = around(middle, radius, to);
  const back = around(middle, radius, to - sense * bend);
  const length = Math.hypot(tip.x - back.x, tip.y - back.y);
  const along = { x: (tip.x - back.x) / length, y: (tip.y - back.y) / length };
  return {
    shaft: arcPath(middle, radius, from, to - sense * bend),
    head: headPath(tip, along, reach),
  };
}

/**
 * Part of a circle.
 * @param {Point} middle
 * @param {number} radius
 * @param {number} from in degrees from the top, clockwise
 * @param {number} to
 */
export function arcPath(middle, radius, from, to) {
  const isLarge = Math.abs(to - from) > 180 ? 1 : 0;
  const r = round(radius);
  return `M${at(around(middle, radius, from))}A${r},${r} 0 ${isLarge} ${to > from ? 1 : 0} ${at(around(middle, radius, to))}`;
}

/**
 * @param {Point} middle
 * @param {number} radius
 * @param {number} degrees from the top, clockwise
 * @returns {Point}
 */
export function around(middle, radius, degrees) {
  const angle = (Math.PI / 180) * degrees;
  return { x: middle.x + radius * Math.sin(angle), y: middle.y - radius * Math.cos(angle) };
}

/**
 * @param {Point} tip
 * @param {Point} along of length 1
 * @param {number} reach
 */
function headPath(tip, along, reach) {
  const wing = (/** @type {number} */ side) =>
    at({
      x: tip.x - reach * along.x - side * 0.55 * reach * along.y,
      y: tip.y - reach * along.y + side * 0.55 * reach * along.x,
    });
  return `M${wing(1)}L${at(tip)}L${wing(-1)}Z`;
}

/** @param {Point} point */
function at({ x, y }) {
  return `${round(x)},${round(y)}`;
}

/** @param {number} pixels */
export function round(pixels) {
  return Math.round(100 * pixels) / 100;
}
