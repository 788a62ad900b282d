// @ts-check

import { brief } from "../format/number.js";
import { isSaid, say } from "../format/words.js";

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
export function letterOf({ id }) {
  return /^figure-5-([a-o])$/.exec(id)?.[1] ?? null;
}

/**
 * What is said of a preset: by its id in the language of the page, or as the server says it.
 * @param {import("../api/answers.js").Preset} preset
 * @returns {{title: string, caption: string, source: string, language: string}} language of these, where it
 *   is not that of the page
 */
export function textsOf(preset) {
  const letter = letterOf(preset);
  const id = letter ? "figure_5" : preset.id.replaceAll("-", "_");
  if (!isSaid(`presets.all.${id}.title`)) {
    return { ...preset, caption: preset.caption ?? "", language: "en" };
  }
  const values = {
    letter: letter ?? "",
    ratio: brief(preset.gt_over_gn / preset.mu_over_alpha),
    work: workOf(preset.source),
  };
  const caption = `presets.all.${id}.caption`;
  return {
    title: say(`presets.all.${id}.title`, values),
    caption: isSaid(caption) ? say(caption, values) : "",
    source: say(`presets.all.${id}.source`, values),
    language: "",
  };
}

/** The work that a source names, up to its year or its DOI. @param {string} source */
function workOf(source) {
  return /(?:^|; )([A-Z][^;:]* \(\d{4}\)(?:, doi:[^\s:;]+)?)/.exec(source)?.[1] ?? "";
}
