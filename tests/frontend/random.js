/** A seeded source of numbers in [0, 1), so that a failure can be had again (mulberry32). */
export function seeded(seed) {
  let state = seed;
  return () => {
    state = (state + 0x6d2b79f5) | 0;
    let t = Math.imul(state ^ (state >>> 15), 1 | state);
    t = (t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t;
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
  };
}

/** Count numbers spread evenly over the logarithm between two. */
export function spreadNumbers(seed, count, min, max) {
  const next = seeded(seed);
  const [low, high] = [Math.log(min), Math.log(max)];
  return Array.from({ length: count }, () => Math.exp(low + (high - low) * next()));
}
