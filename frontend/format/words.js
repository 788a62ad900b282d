// @ts-check

import { TEXT_SYMBOLS } from "./symbols.js";

/**
 * What is said at a key, with values in place of what stands in double braces; `count` chooses the plural.
 * @typedef {(key: string, values?: Record<string, string | number>) => string} Say
 */

/**
 * @typedef {object} Words of the page, as its server has put them into it
 * @property {string} language
 * @property {{id: string, name: string}[]} languages each with its own name for itself
 * @property {Record<string, any>} texts by nested keys; nothing in them is markup
 */

/** @type {Words} */
let words = { language: "en", languages: [], texts: {} };
let mark = ".";
let plurals = new Intl.PluralRules(words.language);

/**
 * Takes the words of the page, before anything is said. They stay as long as the page: another language is
 * another page.
 * @param {Words} all
 */
export function learn(all) {
  words = all;
  plurals = new Intl.PluralRules(all.language);
  const parts = new Intl.NumberFormat(all.language).formatToParts(0.5);
  mark = parts.find(({ type }) => type === "decimal")?.value ?? ".";
}

/** Takes words that come later. @param {Words["texts"]} more */
export function learnMore(more) {
  words = { ...words, texts: { ...words.texts, ...more } };
}

/** The language of the page. */
export const spokenLanguage = () => words.language;

/** The languages that there are. */
export const knownLanguages = () => words.languages;

/** What parts the integer digits from the others on the page. */
export const decimalMark = () => mark;

/** @type {Say} */
export function say(key, values = {}) {
  return filled(textAt(key, values.count) ?? key, values);
}

/** Whether there are words at a key: what the server names may be new. @param {string} key */
export const isSaid = (key) => textAt(key, undefined) !== undefined;

/**
 * The text at a dotted key, in the form that a count asks for.
 * @param {string} key
 * @param {string | number | undefined} count
 */
function textAt(key, count) {
  const isCounted = typeof count === "number";
  const form = isCounted ? plurals.select(count) : "";
  const keys = isCounted ? [`${key}_${form}`, `${key}_other`, key] : [key];
  return keys.map((each) => leaf(each.split("."))).find((text) => text);
}

/**
 * @param {string[]} path
 * @returns {string | undefined}
 */
function leaf(path) {
  let found = words.texts;
  for (const name of path) {
    found =
      found !== null && typeof found === "object" && Object.hasOwn(found, name) && found[name];
  }
  return typeof found === "string" ? found : undefined;
}

/**
 * @param {string} text
 * @param {Record<string, string | number>} values
 */
function filled(text, values) {
  /** @type {Record<string, string | number>} */
  const all = { ...TEXT_SYMBOLS, ...values };
  return text.replaceAll(/\{\{(\w+)\}\}/g, (braces, name) =>
    Object.hasOwn(all, name) ? String(all[name]) : braces,
  );
}

/** So many characters of a text are quoted. */
const LONGEST_QUOTE = 24;

/** A text as it is quoted. @param {string} text */
export function shortened(text) {
  return text.length > LONGEST_QUOTE ? `${text.slice(0, LONGEST_QUOTE - 1)}…` : text;
}
