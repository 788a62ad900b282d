// @ts-check

import { say } from "../format/words.js";
import { copyText } from "../widgets/copy.js";
import { byTestId, find } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/**
 * Shows something in front of the page until it is closed; the focus then goes back to where it was.
 * @param {string} title
 * @param {HTMLElement[]} content
 */
export function openSheet(title, content) {
  const sheet = /** @type {HTMLDialogElement} */ (byTestId("sheet"));
  typeset(find("h2", sheet), title);
  find(".sheet-body", sheet).replaceChildren(...content);
  sheet.showModal();
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

/** @param {import("../figures/tables.js").Table} table */
export function tableElement({ caption, headings, rows, here }) {
  const frame = document.createElement("div");
  const table = document.createElement("table");
  frame.className = "table-frame";
  frame.tabIndex = 0;
  frame.setAttribute("role", "region");
  frame.setAttribute("aria-label", say("sheet.table"));
  const captionText = document.createElement("span");
  typeset(captionText, caption);
  table.createCaption().append(captionText);
  const head = table.createTHead().insertRow();
  head.append(...headings.map((text) => headingCell(text, "col")));
  const body = table.createTBody();
  for (const [i, [first, ...others]] of rows.entries()) {
    const row = body.insertRow();
    row.toggleAttribute("data-here", i === here);
    row.append(headingCell(first, "row"));
    for (const text of others) {
      row.insertCell().textContent = text;
    }
  }
  frame.append(table);
  return frame;
}

/**
 * @param {string} text
 * @param {string} scope
 */
function headingCell(text, scope) {
  const cell = document.createElement("th");
  cell.scope = scope;
  typeset(cell, text);
  return cell;
}
