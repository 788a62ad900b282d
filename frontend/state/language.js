// @ts-check

/**
 * The languages that texts are translated into, each with its own name for itself; the first stands in
 * for what is missing in the others. Each has a file in `locales/`.
 */
export const LANGUAGES = [
  { id: "en", name: "English" },
  { id: "de", name: "Deutsch" },
];

/**
 * The language to speak.
 * @param {string} wanted one of them, or `system`
 * @param {readonly string[]} preferred by the browser, as `de-CH`, best first
 */
export function chosenLanguage(wanted, preferred) {
  const known = (/** @type {string} */ id) => LANGUAGES.some((language) => language.id === id);
  const spoken = preferred.map((tag) => tag.split("-")[0].toLowerCase());
  return [wanted, ...spoken].find(known) ?? LANGUAGES[0].id;
}
