// @ts-check

import { isSaid, say } from "./words.js";

/**
 * What a material is called, and what is to be said of it: of one that the page does not know, as the server
 * has it, which is in English.
 * @param {{id: string, title: string, notes: string}} material
 */
export function textsOfMaterial({ id, title, notes }) {
  const key = id.replaceAll("-", "_");
  return isSaid(`materials.${key}.name`)
    ? {
        name: say(`materials.${key}.name`),
        notes: say(`materials.${key}.notes`),
        language: "",
      }
    : { name: title, notes, language: "en" };
}
