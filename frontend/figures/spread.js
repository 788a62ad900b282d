// @ts-check

/**
 * Ascending positions moved apart as little as keeps them at a distance and within bounds, or null
 * where there is no room for that.
 * @param {ArrayLike<number>} positions
 * @param {number} gap
 * @param {number} low
 * @param {number} high
 * @returns {number[] | null}
 */
export function spreadApart(positions, gap, low, high) {
  if ((positions.length - 1) * gap > high - low) {
    return null;
  }
  // With i·gap taken off, "at a distance" becomes "in order": neighbours out of order share their mean.
  /** @type {{mean: number, count: number}[]} */
  const groups = [];
  for (let i = 0; i < positions.length; i += 1) {
    let group = { mean: positions[i] - i * gap, count: 1 };
    for (let last = groups.at(-1); last && last.mean > group.mean; last = groups.at(-1)) {
      groups.pop();
      const count = last.count + group.count;
      group = { mean: (last.mean * last.count + group.mean * group.count) / count, count };
    }
    groups.push(group);
  }
  const highest = high - (positions.length - 1) * gap;
  return groups
    .flatMap(({ mean, count }) => Array.from({ length: count }, () => mean))
    .map((place, i) => Math.min(highest, Math.max(low, place)) + i * gap);
}

/**
 * Marks without those that would cover one farther along an axis: none is moved from its place.
 * @template Mark
 * @param {Mark[]} marks
 * @param {(mark: Mark) => number} placeOf along the axis
 * @param {number} gap
 * @returns {Mark[]} from the far end on
 */
export function legible(marks, placeOf, gap) {
  /** @type {Mark[]} */
  const kept = [];
  for (const one of [...marks].sort((a, b) => placeOf(b) - placeOf(a))) {
    const last = kept.at(-1);
    if (last === undefined || placeOf(last) - placeOf(one) >= gap) {
      kept.push(one);
    }
  }
  return kept;
}
