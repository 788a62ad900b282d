// @ts-check

/** @typedef {import("../../state/address/options.js").PageState} PageState */

/**
 * What is chosen of a frame.
 * @typedef {object} Choices
 * @property {string[]} panels one at least
 * @property {string[]} sliders
 * @property {string} lang
 * @property {PageState["theme"]} theme
 */

/** How the page is shown, which is the frame's own matter. */
const PLAIN = /** @type {const} */ ({
  step: "1",
  face: "usual",
  notes: "hidden",
  handout: "hidden",
  presenting: "off",
});

/** The scene whose panels a frame has: the lesson borrows its own. @param {PageState} state */
export function framedScene({ scene }) {
  return scene === "lesson" ? "explorer" : scene;
}

/**
 * The page in a frame that begins with a state.
 * @param {PageState} state
 * @param {Choices} choices
 * @returns {PageState}
 */
export function framed(state, { panels, sliders, lang, theme }) {
  return {
    ...state,
    ...PLAIN,
    scene: framedScene(state),
    embed: panels.join(","),
    sliders: sliders.join(",") || "none",
    lang,
    theme,
  };
}

/**
 * The frame as the text of another page has it. There it takes no more than the room it finds.
 * @param {object} frame
 * @param {string} frame.address
 * @param {string} frame.title
 * @param {number} frame.width in pixels
 * @param {number} frame.height
 */
export function frameText({ address, title, width, height }) {
  const size = `width="${width}" height="${height}" style="border: 0; max-width: 100%"`;
  return `<iframe src="${escaped(address)}" title="${escaped(title)}" ${size} loading="lazy"></iframe>`;
}

/** @param {string} text */
function escaped(text) {
  return text
    .replaceAll("&", "&amp;")
    .replaceAll('"', "&quot;")
    .replaceAll("<", "&lt;")
    .replaceAll(">", "&gt;");
}
