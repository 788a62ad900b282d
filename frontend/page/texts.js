// @ts-check

import { learn, say } from "../format/words.js";
import { find } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/** Takes the words that the server has put into the page, and puts them where its markup names them. */
export function takeTexts() {
  learn(JSON.parse(find("#words").textContent ?? ""));
  for (const element of document.querySelectorAll("[data-say]")) {
    typeset(/** @type {HTMLElement} */ (element), say(element.getAttribute("data-say") ?? ""));
  }
  for (const [name, attribute] of [
    ["data-say-label", "aria-label"],
    ["data-say-title", "title"],
  ]) {
    for (const element of document.querySelectorAll(`[${name}]`)) {
      element.setAttribute(attribute, say(element.getAttribute(name) ?? ""));
    }
  }
  document.title = say("page.title");
}
