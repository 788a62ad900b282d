// @ts-check

import { isSaid, learn, learnMore, say, spokenLanguage } from "../format/words.js";
import { find } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/** What `restitution page` has put into a page that is one file; else null. @returns {import("../api/file-client.js").Contents | null} */
export function contentsOfFile() {
  const text = document.querySelector("#file")?.textContent;
  return text ? JSON.parse(text) : null;
}

/**
 * Takes the words of the page.
 * @param {import("../format/words.js").Words} [words] where it is one file; else its server has put them into it
 */
export function takeTexts(words) {
  learn(words ?? JSON.parse(find("#words").textContent ?? ""));
  putTexts();
  document.title = say("page.title");
}

/** @type {Promise<void> | null} */
let coming = null;

/**
 * Takes the words of what is not in the first view, once.
 * @param {ReturnType<typeof import("../api/client.js").createClient>["words"]} load
 */
export function takeLaterTexts(load) {
  coming ??= load(spokenLanguage())
    .then((texts) => {
      learnMore(texts);
      putTexts();
    })
    .catch((error) => {
      coming = null;
      throw error;
    });
  return coming;
}

/** Puts texts where the markup names them, those that are known by now. */
function putTexts() {
  for (const [name, put] of PLACES) {
    for (const element of document.querySelectorAll(`[${name}]`)) {
      const key = element.getAttribute(name) ?? "";
      if (isSaid(key)) {
        put(/** @type {HTMLElement} */ (element), say(key));
        element.removeAttribute(name);
      }
    }
  }
}

/** @type {[string, (element: HTMLElement, text: string) => void][]} */
const PLACES = [
  ["data-say", typeset],
  ["data-say-label", (element, text) => element.setAttribute("aria-label", text)],
  ["data-say-title", (element, text) => element.setAttribute("title", text)],
];
