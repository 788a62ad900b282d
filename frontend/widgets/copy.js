// @ts-check

import { say } from "../format/words.js";

/**
 * Copies a text. The clipboard is there on a secure page only, and not in every frame; the older way
 * works with a selection.
 * @param {string} text
 * @returns {Promise<boolean>} whether it is copied
 */
export async function copyText(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    const field = document.createElement("textarea");
    field.className = "unseen";
    field.value = text;
    const before = /** @type {HTMLElement | null} */ (document.activeElement);
    // Inside an open dialog nothing else can be selected.
    (before?.closest("dialog") ?? document.body).append(field);
    field.select();
    const done = document.execCommand("copy");
    field.remove();
    before?.focus();
    return done;
  }
}

/**
 * A text to be copied.
 * @param {string} name
 * @param {string} text
 */
export function codeBlock(name, text) {
  const figure = document.createElement("figure");
  const caption = document.createElement("figcaption");
  const copy = document.createElement("button");
  const code = document.createElement("pre");
  figure.className = "code";
  caption.textContent = name;
  copy.className = "quiet";
  copy.type = "button";
  copy.textContent = say("sheet.copy");
  copy.setAttribute("aria-label", say("sheet.copyNamed", { name }));
  copy.addEventListener("click", async () => {
    const done = await copyText(text);
    copy.textContent = say(done ? "page.copied" : "sheet.copyYourself");
    copy.setAttribute(
      "aria-label",
      done ? say("sheet.copied", { name }) : say("sheet.copyYourself"),
    );
  });
  code.textContent = text;
  code.tabIndex = 0;
  code.setAttribute("role", "region");
  code.setAttribute("aria-label", name);
  caption.append(copy);
  figure.append(caption, code);
  return figure;
}
