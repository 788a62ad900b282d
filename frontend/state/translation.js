// @ts-check

import { TEXT_SYMBOLS } from "../format/symbols.js";
import i18next from "../vendor/i18next.js";
import { LANGUAGES } from "./language.js";

/**
 * What is said at a key, with values in place of what stands in double braces.
 * @typedef {(key: string, values?: Record<string, string | number>) => string} Say
 */

/** The one namespace of i18next that is used. */
const TEXTS = "texts";

/**
 * Texts in several languages. What one of them lacks, or leaves empty, the first language says.
 * Nothing in them is markup: they are to be written as text.
 */
export function createTranslation() {
  const i18n = i18next.createInstance();
  i18n.init({
    lng: LANGUAGES[0].id,
    fallbackLng: LANGUAGES[0].id,
    resources: {},
    defaultNS: TEXTS,
    initAsync: false,
    returnEmptyString: false,
    interpolation: { escapeValue: false, defaultVariables: TEXT_SYMBOLS },
  });

  return {
    /** @param {string} language */
    has: (language) => i18n.hasResourceBundle(language, TEXTS),

    /**
     * @param {string} language
     * @param {Record<string, any>} texts
     */
    add(language, texts) {
      i18n.addResourceBundle(language, TEXTS, texts);
    },

    /** @param {string} language @returns {Say} */
    in(language) {
      const say = i18n.getFixedT(language);
      return (key, values = {}) => String(say(key, values));
    },

    /** Which way it is written. @param {string} language */
    direction: (language) => i18n.dir(language),
  };
}
