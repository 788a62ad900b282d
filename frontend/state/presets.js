// @ts-check

/**
 * A panel of Fig. 5, by what its collision is.
 * @typedef {{letter: string, kappa: number, psi: number}} Letter
 */

/**
 * The panels of Fig. 5 among presets.
 * @param {import("../api/answers.js").Preset[]} presets
 * @returns {Letter[]}
 */
export function lettersOf(presets) {
  return presets.flatMap((preset) => {
    const letter = letterOf(preset);
    const { kappa, gt_over_gn, mu_over_alpha } = preset;
    return letter ? [{ letter, kappa, psi: gt_over_gn / mu_over_alpha }] : [];
  });
}

/** Which panel of Fig. 5 a preset is, or null. @param {import("../api/answers.js").Preset} preset */
export function letterOf({ title }) {
  return /^Fig\.\s*5\s*([a-o])$/.exec(title)?.[1] ?? null;
}
