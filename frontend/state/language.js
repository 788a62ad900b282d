// @ts-check

/**
 * The languages that texts are translated into, each with its own name for itself; the first stands in
 * for what is missing in the others. Each has a file in `locales/`.
 */
export const LANGUAGES = [
  { id: "en", name: "English" },
  { id: "de", name: "Deutsch" },
];

/** Decimal marks, by language. @type {Map<string, string>} */
const MARKS = new Map();

/**
 * The decimal mark that stands in the fields: that of the language that a scene speaks, which only the
 * lesson translates.
 * @param {{scene: string, lang: string}} state
 * @param {readonly string[]} preferred by the browser
 */
export function decimalMark({ scene, lang }, preferred) {
  const language = scene === "lesson" ? chosenLanguage(lang, preferred) : LANGUAGES[0].id;
  if (!MARKS.has(language)) {
    const parts = new Intl.NumberFormat(language).formatToParts(0.5);
    MARKS.set(language, parts.find(({ type }) => type === "decimal")?.value ?? ".");
  }
  return /** @type {string} */ (MARKS.get(language));
}

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
