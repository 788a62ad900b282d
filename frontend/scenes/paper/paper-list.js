// @ts-check

import { say } from "../../format/words.js";
import { countOf, grouped, labelOf, VERDICTS } from "../../state/paper.js";
import { make, toldIn } from "../../widgets/elements.js";
import { byTestId } from "../../widgets/find.js";

/**
 * @typedef {import("../../state/paper.js").Statement} Statement
 * @typedef {import("../../state/paper.js").Paper} Paper
 * @typedef {{paper_verdict: string, paper_kind: string}} Wanted
 */

/**
 * The statements of the paper: what is printed beside what comes out, with the verdict, how it was
 * decided, and a link that shows it.
 * @param {HTMLElement} element
 * @param {(link: string) => void} onOpen
 */
export function mountPaperList(element, onOpen) {
  /** @param {Event} event */
  function follow(event) {
    const clicked = /** @type {PointerEvent} */ (event);
    const link = /** @type {HTMLElement} */ (clicked.target).closest("a");
    // What opens a tab or a window of its own is the browser's.
    if (link && !clicked.ctrlKey && !clicked.metaKey && !clicked.shiftKey) {
      event.preventDefault();
      onOpen(link.search);
    }
  }
  /** On paper nothing can be opened. */
  function unfold() {
    element.querySelectorAll("details").forEach((details) => (details.open = true));
  }
  element.addEventListener("click", follow);
  addEventListener("beforeprint", unfold);

  return {
    /**
     * @param {Paper} paper
     * @param {Wanted} wanted
     */
    show(paper, wanted) {
      byTestId("paper-count").textContent = countOf(paper);
      const sections = grouped(paper.items, wanted);
      element.replaceChildren(
        ...sections.map(({ id, title, kinds }) => {
          const section = make("section", "paper-section");
          const heading = make("h3", "", `${id}  ${title}`);
          heading.id = `paper-section-${id.replace(".", "-")}`;
          section.setAttribute("aria-labelledby", heading.id);
          section.append(
            heading,
            ...kinds.flatMap((kind) => [
              make("h4", "", kind.title),
              ...kind.statements.map((one) => article(one, paper)),
            ]),
          );
          return section;
        }),
      );
      if (sections.length === 0) {
        element.append(make("p", "panel-note", say("paper.none")));
      }
    },
  };
}

/**
 * @param {Statement} statement
 * @param {Paper} paper
 */
function article(statement, { items, corrections, definitions }) {
  const { id, printed, computed, verdict, evidence, link } = statement;
  const label = labelOf(statement, items);
  const correction = corrections.find(({ statements }) => statements.includes(id));
  const item = make("article", "statement");
  const name = make("h5", "", label);
  const texts = document.createElement("dl");
  const details = document.createElement("details");
  const anchor = document.createElement("a");
  item.dataset.statement = id;
  item.dataset.verdict = verdict;
  name.id = `statement-${id}`;
  item.setAttribute("aria-labelledby", name.id);
  texts.append(...pair(say("paper.printed"), printed), ...pair(say("paper.computed"), computed));
  details.append(make("summary", "", say("paper.decided")), quoted("p", evidence));
  if (correction) {
    const { text, statements } = correction;
    const heading = make("p", "", say("paper.correction", { count: statements.length }));
    details.append(heading, quoted("p", text));
  }
  anchor.href = link;
  anchor.textContent = say("paper.show");
  anchor.setAttribute("aria-label", say("paper.showNamed", { name: label }));
  item.append(name, badge(verdict, definitions.includes(id)), texts, details, anchor);
  return item;
}

/**
 * @param {Statement["verdict"]} verdict
 * @param {boolean} defines
 */
function badge(verdict, defines) {
  const { mark } = /** @type {typeof VERDICTS[number]} */ (
    VERDICTS.find(({ id }) => id === verdict)
  );
  const word = say(`paper.verdicts.${verdict}`);
  const element = make("p", "verdict");
  const sign = make("span", "verdict-mark", mark);
  sign.setAttribute("aria-hidden", "true");
  element.append(sign, defines ? say("paper.verdicts.definition", { verdict: word }) : word);
  return element;
}

/**
 * @param {string} term
 * @param {string} text
 */
function pair(term, text) {
  return [make("dt", "", term), quoted("dd", text)];
}

/**
 * What is of the paper and about it stays in its language.
 * @param {"p" | "dd"} name
 * @param {string} text with symbols
 */
const quoted = (name, text) => toldIn("en", name, text);
