// @ts-check

import { THEME_PROPERTIES } from "../figures/theme.js";

const root = document.documentElement;
const darkScheme = matchMedia("(prefers-color-scheme: dark)");

/**
 * Plotly keeps how wide a text is, by its style and for good. So the page's own fonts are part of the
 * style only once they are there.
 */
let hasFonts = false;

/** @type {import("../figures/theme.js").Theme | null} */
let known = null;
/** @type {Set<() => void>} */
const listeners = new Set();
/** @type {Set<() => void>} */
const printers = new Set();

// Very large windows have larger type, and so has what is presented.
addEventListener("resize", () => {
  known = null;
});
darkScheme.addEventListener("change", tell);
// What is drawn for the screen must be drawn anew for paper, at once: the browser does not wait.
addEventListener("beforeprint", () => layOut(true));
addEventListener("afterprint", () => layOut(false));
new MutationObserver(tell).observe(root, { attributeFilter: ["data-theme", "data-presenting"] });
awaitFonts();

async function awaitFonts() {
  const [own] = families();
  try {
    await Promise.all([
      document.fonts.load(`16px ${own}`),
      document.fonts.load(`italic 16px ${own}`),
    ]);
  } catch {
    // The others stay.
    return;
  }
  hasFonts = true;
  tell();
}

/** Those of the page's text, its own first. */
function families() {
  const list = getComputedStyle(root).getPropertyValue(THEME_PROPERTIES.sans);
  return list.split(",").map((family) => family.trim());
}

function tell() {
  known = null;
  for (const listener of listeners) {
    listener();
  }
}

/** The colours in force, read from the style sheet once for each scheme. */
export function currentTheme() {
  if (!known) {
    const style = getComputedStyle(root);
    const isChosen = root.dataset.theme !== undefined;
    const wanted = isChosen ? root.dataset.theme === "dark" : darkScheme.matches;
    // Paper is white, whatever the page is.
    const dark = wanted && !root.hasAttribute("data-printing");
    const values = Object.entries(THEME_PROPERTIES).map(([name, property]) => [
      name,
      inScheme(style.getPropertyValue(property).trim(), dark),
    ]);
    const unit = Number.parseFloat(style.fontSize) / 16;
    const sans = families()
      .slice(hasFonts ? 0 : 1)
      .join(", ");
    const words = Number(style.getPropertyValue("--words-in-pictures")) || 1;
    known = { dark, unit, words, ...Object.fromEntries(values), sans };
  }
  return /** @type {import("../figures/theme.js").Theme} */ (known);
}

/**
 * A custom property holds both colours still: which of them counts is decided where it is used.
 * @param {string} value
 * @param {boolean} dark
 */
function inScheme(value, dark) {
  const both = /^light-dark\(([^,]+),([^,]+)\)$/.exec(value);
  return both ? both[dark ? 2 : 1].trim() : value;
}

/** @param {boolean} onPaper */
function layOut(onPaper) {
  root.toggleAttribute("data-printing", onPaper);
  tell();
  for (const listener of printers) {
    listener();
  }
}

/**
 * Tells when the page is laid out for paper, and when for the screen again.
 * @param {() => void} listener
 * @returns {() => void} ends it
 */
export function onPrinting(listener) {
  printers.add(listener);
  return () => printers.delete(listener);
}

/**
 * @param {() => void} listener
 * @returns {() => void} ends it
 */
export function onThemeChange(listener) {
  listeners.add(listener);
  return () => listeners.delete(listener);
}
