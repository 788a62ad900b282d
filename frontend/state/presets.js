// @ts-check

/** Which panel of Fig. 5 a preset is, or null. @param {import("../api/answers.js").Preset} preset */
export function letterOf({ title }) {
  return /^Fig\.\s*5\s*([a-o])$/.exec(title)?.[1] ?? null;
}
