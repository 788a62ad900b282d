// @ts-check

import { spreadIndices } from "../../figures/sample.js";
import { significant } from "../../format/number.js";
import { say } from "../../format/words.js";

/** @typedef {import("../../figures/tables.js").Table} Table */

const ROWS = 30;

/** @param {import("./collapse-figure.js").FrictionCurve[]} curves @returns {Table} */
export function collapseTable(curves) {
  const [{ psi }] = curves;
  return {
    caption: say("paper.collapse.table"),
    headings: ["ψ", ...curves.map(({ muOverAlpha }) => `μ/α = ${significant(muOverAlpha, 2)}`)],
    rows: spreadIndices(psi.length, ROWS, []).map((i) => [
      significant(psi[i]),
      ...curves.map(({ epsilonT }) => significant(epsilonT[i], 8)),
    ]),
  };
}

/** @param {import("./stiff-law-figure.js").StiffCut[]} cuts @returns {Table} */
export function stiffLawTable(cuts) {
  const [{ kappa }] = cuts;
  return {
    caption: say("paper.stiffLaw.table"),
    headings: ["κ", ...cuts.map(({ psi }) => `ψ = ${significant(psi, 2)}`)],
    rows: spreadIndices(kappa.length, ROWS, []).map((i) => [
      significant(kappa[i]),
      ...cuts.map(({ epsilonT, asymptote }) => significant(Math.abs(epsilonT[i]) / asymptote[i])),
    ]),
  };
}

/** @param {import("./switch-law-figure.js").SwitchLaw} law @returns {Table} */
export function switchLawTable({ kappa, most, law }) {
  return {
    caption: say("paper.switchLaw.table"),
    headings: ["κ", say("paper.switchLaw.most"), say("paper.switchLaw.law")],
    rows: spreadIndices(kappa.length, ROWS, []).map((i) => [
      significant(kappa[i]),
      String(most[i]),
      significant(law[i]),
    ]),
  };
}
