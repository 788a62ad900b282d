// @ts-check

/** @typedef {import("../../api/file-client.js").Contents} Contents */

/** What the page has with it where it is one file, as `restitution page` writes it; else null. @returns {Contents | null} */
export function contentsOfFile() {
  const text = document.querySelector("#file")?.textContent;
  return text ? JSON.parse(text) : null;
}

/** Scenes that are nothing without a server. */
export const SERVED = ["spheres", "accuracy", "paper"];

/**
 * The words of the first view in the language of an address, else the first that the reader has, else the usual one.
 * @param {Contents} contents
 * @param {string} search
 * @returns {import("../../format/words.js").Words}
 */
export function wordsOfFile({ language: usual, languages, texts }, search) {
  const preferred = navigator.languages.map((name) => name.split("-")[0]);
  const wanted = [new URLSearchParams(search).get("lang") ?? "", ...preferred];
  const language = wanted.find((name) => Object.hasOwn(texts, name)) ?? usual;
  document.documentElement.lang = language;
  return { language, languages, texts: texts[language].first };
}
