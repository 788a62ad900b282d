// @ts-check

import { TEXT_SYMBOLS } from "../format/symbols.js";
import { LANGUAGES } from "./language.js";

/**
 * What is said at a key, with values in place of what stands in double braces.
 * @typedef {(key: string, values?: Record<string, string | number>) => string} Say
 */

/** Scripts that are written from right to left. */
const LEFTWARDS = ["Adlm", "Arab", "Hebr", "Nkoo", "Rohg", "Syrc", "Thaa"];

/**
 * Texts in several languages. What one of them lacks, or leaves empty, the first language says; what
 * that lacks, too, is said by its key. Nothing in them is markup: they are to be written as text.
 */
export function createTranslation() {
  /** @type {Map<string, Record<string, any>>} */
  const known = new Map();

  return {
    /** @param {string} language */
    has: (language) => known.has(language),

    /**
     * @param {string} language
     * @param {Record<string, any>} texts
     */
    add(language, texts) {
      known.set(language, texts);
    },

    /** @param {string} language @returns {Say} */
    in(language) {
      const asked = [language, LANGUAGES[0].id];
      return (key, values = {}) => {
        const found = asked.map((each) => textAt(known.get(each), key, each, values.count));
        return filled(found.find((text) => text) ?? key, values);
      };
    },

    /** Which way it is written. @param {string} language */
    direction(language) {
      const { script } = new Intl.Locale(language).maximize();
      return LEFTWARDS.includes(script ?? "") ? "rtl" : "ltr";
    },
  };
}

/**
 * The text at a dotted key, in the form that a count asks for.
 * @param {Record<string, any> | undefined} texts
 * @param {string} key
 * @param {string} language
 * @param {string | number | undefined} count
 */
function textAt(texts, key, language, count) {
  const form = typeof count === "number" ? new Intl.PluralRules(language).select(count) : "";
  const keys = form ? [`${key}_${form}`, `${key}_other`, key] : [key];
  return keys.map((each) => leaf(texts, each.split("."))).find((text) => text);
}

/**
 * @param {any} texts
 * @param {string[]} path
 * @returns {string | undefined}
 */
function leaf(texts, path) {
  let found = texts;
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
