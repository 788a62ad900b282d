// @ts-check

/**
 * So many indices spread evenly over a list, with its ends, and others that must not be missed.
 * @param {number} length
 * @param {number} count at least 2
 * @param {number[]} [others]
 * @returns {number[]} ascending, each once
 */
export function spreadIndices(length, count, others = []) {
  const last = Math.max(0, length - 1);
  const even = Array.from({ length: Math.min(count, length) }, (_, i) =>
    Math.round((i * last) / Math.max(1, Math.min(count, length) - 1)),
  );
  return [...new Set([...even, ...others])].sort((a, b) => a - b);
}

/**
 * The index nearest to each of some values.
 * @param {ArrayLike<number>} list ascending
 * @param {number[]} values
 */
export function placesAmong(list, values) {
  return values.map((value) => {
    let best = 0;
    for (let i = 1; i < list.length; i += 1) {
      if (Math.abs(list[i] - value) < Math.abs(list[best] - value)) {
        best = i;
      }
    }
    return best;
  });
}

/**
 * The value of a sampled curve at a share of its axis, on the straight line between two samples.
 * @param {ArrayLike<number>} samples
 * @param {number} share 0 … 1
 */
export function valueAt(samples, share) {
  const place = share * (samples.length - 1);
  const i = Math.min(samples.length - 2, Math.floor(place));
  return samples[i] + (place - i) * (samples[i + 1] - samples[i]);
}
