// @ts-check

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
 * @type {{id: Verdict, mark: string, word: string}[]}
 */
export const VERDICTS = [
  { id: "holds", mark: "✓", word: "holds" },
  { id: "corrected", mark: "≈", word: "holds with a correction" },
  { id: "fails", mark: "✗", word: "does not hold" },
];

/** @type {{id: Kind, title: string, short: string}[]} */
const KINDS = [
  { id: "equation", title: "Equations", short: "Eq." },
  { id: "figure", title: "Figures", short: "Fig." },
  { id: "number", title: "Numbers", short: "Number" },
  { id: "claim", title: "Claims", short: "Claim" },
];

/** What the list may be cut down to; the first is everything. */
export const VERDICT_CHOICES = [
  { id: "all", title: "all" },
  { id: "holds", title: "✓ hold" },
  { id: "corrected", title: "≈ corrected" },
  { id: "fails", title: "✗ do not hold" },
];
export const KIND_CHOICES = [
  { id: "all", title: "all" },
  ...KINDS.map(({ id, title }) => ({ id, title: title.toLowerCase() })),
];

/** The paper's sections, in our words. */
const SECTIONS = [
  { id: "1", title: "Introduction: the normal force" },
  { id: "2", title: "Tangential force and restitution" },
  { id: "3", title: "Pure Coulomb sliding" },
  { id: "4.1", title: "An example: steel spheres" },
  { id: "4.2", title: "Scaling" },
  { id: "4.3", title: "Switching between sliding and sticking" },
  { id: "4.4", title: "Stiff tangential springs" },
  { id: "5", title: "Conclusions" },
];

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
    ...section,
    kinds: KINDS.map((each) => ({
      ...each,
      statements: chosen.filter((one) => one.section === section.id && one.kind === each.id),
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
  return `${holds} hold, ${definitions.length} of them as definitions; ${corrected} hold with a correction, ${corrections.length} different ones in all; ${fails} do not.`;
}

/**
 * A short name: `Eq. 27`, `Fig. 4`; numbers and claims, which the paper does not count, by ours.
 * @param {Statement} statement
 * @param {Statement[]} all
 */
export function labelOf({ id, kind }, all) {
  const { short } = /** @type {typeof KINDS[number]} */ (KINDS.find((each) => each.id === kind));
  const own = /^(?:equation|figure)-(\d+)$/.exec(id)?.[1];
  const place = all.filter((one) => one.kind === kind).findIndex((one) => one.id === id);
  return `${short} ${own ?? place + 1}`;
}
