// @ts-check

import { say } from "../format/words.js";

/**
 * A statement of the paper, checked, as `/paper` has it.
 * @typedef {"equation" | "figure" | "number" | "claim"} Kind
 * @typedef {"holds" | "corrected" | "fails"} Verdict
 * @typedef {{id: string, kind: Kind, section: string, printed: string, computed: string, verdict: Verdict, evidence: string, link: string}} Statement
 * @typedef {{id: string, text: string, statements: string[]}} Correction one point, and what it mends
 * @typedef {{items: Statement[], corrections: Correction[], definitions: string[]}} Paper
 */

/**
 * What can be said of a statement, each with a mark that needs no colour.
 * @type {{id: Verdict, mark: string}[]}
 */
export const VERDICTS = [
  { id: "holds", mark: "✓" },
  { id: "corrected", mark: "≈" },
  { id: "fails", mark: "✗" },
];

/** @type {Kind[]} */
const KINDS = ["equation", "figure", "number", "claim"];

/** What the list may be cut down to; the first is everything. */
export const VERDICT_CHOICES = ["all", ...VERDICTS.map(({ id }) => id)];
export const KIND_CHOICES = ["all", ...KINDS];

/** The paper's sections. */
const SECTIONS = ["1", "2", "3", "4.1", "4.2", "4.3", "4.4", "5"];

/**
 * The statements of one verdict and kind, by section and kind in the paper's order; what is empty is
 * left out.
 * @param {Statement[]} statements
 * @param {{paper_verdict: string, paper_kind: string}} wanted `all` or one of each
 */
export function grouped(statements, { paper_verdict: verdict, paper_kind: kind }) {
  const chosen = statements.filter(
    (one) => ["all", one.verdict].includes(verdict) && ["all", one.kind].includes(kind),
  );
  return SECTIONS.map((section) => ({
    id: section,
    title: say(`paper.sections.${section.replace(".", "_")}`),
    kinds: KINDS.map((each) => ({
      title: say(`paper.kinds.${each}`),
      statements: chosen.filter((one) => one.section === section && one.kind === each),
    })).filter((each) => each.statements.length > 0),
  })).filter(({ kinds }) => kinds.length > 0);
}

/**
 * How many there are of each verdict, as a sentence.
 * @param {Paper} paper
 */
export function countOf({ items, corrections, definitions }) {
  const [holds, corrected, fails] = VERDICTS.map(
    ({ id }) => items.filter(({ verdict }) => verdict === id).length,
  );
  return say("paper.count", {
    holds,
    corrected,
    fails,
    definitions: definitions.length,
    corrections: corrections.length,
  });
}

/**
 * A short name: `Eq. 27`, `Fig. 4`; numbers and claims, which the paper does not count, by ours.
 * @param {Statement} statement
 * @param {Statement[]} all
 */
export function labelOf({ id, kind }, all) {
  const own = /^(?:equation|figure)-(\d+)$/.exec(id)?.[1];
  const place = all.filter((one) => one.kind === kind).findIndex((one) => one.id === id);
  return say(`paper.labels.${kind}`, { number: own ?? place + 1 });
}
