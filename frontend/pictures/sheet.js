// @ts-check

import { say } from "../format/words.js";
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
