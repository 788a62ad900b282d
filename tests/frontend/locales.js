import { readdirSync, readFileSync } from "node:fs";

const FOLDER = new URL("../../frontend/locales/", import.meta.url);

/** The texts of every language, as they stand in its file. */
export const LOCALES = Object.fromEntries(
  readdirSync(FOLDER).map((file) => [
    file.replace(".json", ""),
    JSON.parse(readFileSync(new URL(file, FOLDER), "utf8")),
  ]),
);

/** What a page in a language is given to say. */
export function wordsOf(language, texts = LOCALES[language]) {
  const languages = Object.entries(LOCALES).map(([id, { name }]) => ({ id, name }));
  return { language, languages, texts };
}

/** Texts by their dotted keys. @returns {Record<string, string>} */
export function flat(texts, above = "") {
  return Object.assign(
    {},
    ...Object.entries(texts).map(([key, value]) =>
      typeof value === "string" ? { [above + key]: value } : flat(value, `${above}${key}.`),
    ),
  );
}
