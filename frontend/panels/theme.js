// @ts-check

import { THEME_PROPERTIES } from "../figures/theme.js";

const darkScheme = matchMedia("(prefers-color-scheme: dark)");

/** @type {import("../figures/theme.js").Theme | null} */
let known = null;

// Very large windows have larger type.
addEventListener("resize", () => {
  known = null;
});

/** The colours in force, read from the style sheet once for each scheme. */
export function currentTheme() {
  if (!known) {
    const style = getComputedStyle(document.documentElement);
    const values = Object.entries(THEME_PROPERTIES).map(([name, property]) => [
      name,
      style.getPropertyValue(property).trim(),
    ]);
    const unit = Number.parseFloat(style.fontSize) / 16;
    known = { dark: darkScheme.matches, unit, ...Object.fromEntries(values) };
  }
  return /** @type {import("../figures/theme.js").Theme} */ (known);
}

/**
 * @param {() => void} listener
 * @returns {() => void} ends it
 */
export function onThemeChange(listener) {
  const changed = () => {
    known = null;
    listener();
  };
  darkScheme.addEventListener("change", changed);
  return () => darkScheme.removeEventListener("change", changed);
}
