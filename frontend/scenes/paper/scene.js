// @ts-check

import { brief, percentage, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { KIND_CHOICES, VERDICT_CHOICES } from "../../state/paper.js";
import { readAddress } from "../../state/address/reading.js";
import { choices, choose, onChoice } from "../../widgets/choices.js";
import { byTestId, find } from "../../widgets/find.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { typeset } from "../../widgets/typeset.js";
import { collapseFigure, COLLAPSE_COLORS, spreadOf } from "./collapse-figure.js";
import { createLaws } from "./laws.js";
import { mountPaperList } from "./paper-list.js";
import { stiffLawFigure, stiffReach } from "./stiff-law-figure.js";
import { switchLawFigure, switchLawOf } from "./switch-law-figure.js";
import { collapseTable, stiffLawTable, switchLawTable } from "./tables.js";

/**
 * @typedef {import("../../state/paper.js").Paper} Paper
 * @typedef {import("./collapse-figure.js").FrictionCurve} FrictionCurve
 * @typedef {import("./stiff-law-figure.js").StiffCut} StiffCut
 * @typedef {import("./switch-law-figure.js").SwitchLaw} SwitchLaw
 */

/** Names of the choices beside the list, each a key of the state. */
const FILTERS = /** @type {const} */ ({
  paper_verdict: () =>
    VERDICT_CHOICES.map((id) => ({ id, title: say(`paper.verdictChoices.${id}`) })),
  paper_kind: () => KIND_CHOICES.map((id) => ({ id, title: say(`paper.kindChoices.${id}`) })),
});

/**
 * The scene "The paper": every statement with its verdict, and three results beyond it with live data.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountPaper({ client, present, set, explain }) {
  const laws = createLaws(client.columns);
  const list = mountPaperList(byTestId("paper-list"), open);
  const plots = {
    collapse: createPlot(byTestId("collapse"), collapseFigure),
    stiffLaw: createPlot(byTestId("stiff-law"), stiffLawFigure),
    switchLaw: createPlot(byTestId("switch-law"), switchLawFigure),
  };
  /** @type {{paper: Paper | null, collapse: FrictionCurve[] | null, stiffLaw: StiffCut[] | null, switchLaw: SwitchLaw | null}} */
  const shown = { paper: null, collapse: null, stiffLaw: null, switchLaw: null };
  const asked = new Set();
  let listed = "";

  const filters = find(".paper-filters");
  for (const [name, items] of Object.entries(FILTERS)) {
    choices(byTestId(name.replace("_", "-")), name, items());
  }
  onChoice(filters, set);

  /** The state that a statement is about, in the colours and language of the reader. @param {string} link */
  function open(link) {
    const { theme, lang } = present();
    set({ ...readAddress(link).state, theme, lang });
    scrollTo(0, 0);
  }

  /**
   * Asks once; what failed is asked again when the server is back.
   * @template Answer
   * @param {string} what
   * @param {() => Promise<Answer>} ask
   * @param {(answer: Answer) => void} use
   */
  async function once(what, ask, use) {
    if (asked.has(what)) {
      return;
    }
    asked.add(what);
    try {
      use(await ask());
    } catch (error) {
      asked.delete(what);
      explain(error);
    }
  }

  function drawList() {
    if (!shown.paper) {
      return;
    }
    const { paper_verdict, paper_kind } = present();
    const wanted = `${paper_verdict} ${paper_kind}`;
    if (listed !== wanted) {
      listed = wanted;
      list.show(shown.paper, { paper_verdict, paper_kind });
    }
  }

  return {
    show({ scene, paper_verdict, paper_kind }) {
      if (scene !== "paper") {
        return;
      }
      choose(filters, { paper_verdict, paper_kind });
      drawList();
    },

    follow(state) {
      if (state.scene !== "paper") {
        return;
      }
      once("paper", client.paper, (paper) => {
        shown.paper = paper;
        drawList();
      });
      once("collapse", laws.load.collapse, (curves) => {
        shown.collapse = curves;
        plots.collapse.show(curves);
        drawKey(curves);
        typeset(
          byTestId("collapse-said"),
          say("paper.collapse.said", { spread: significant(spreadOf(curves), 1) }),
        );
      });
      once("stiffLaw", laws.load.stiffLaw, (cuts) => {
        const { reach, constant } = stiffReach(cuts);
        shown.stiffLaw = cuts;
        plots.stiffLaw.show(cuts);
        typeset(
          byTestId("stiff-law-said"),
          say("paper.stiffLaw.said", {
            constant: significant(constant, 5),
            collisions: `${cuts.length} × ${cuts[0].kappa.length}`,
            reach: percentage(reach),
          }),
        );
      });
      once("switchLaw", laws.load.switchLaw, (map) => {
        const law = switchLawOf(map);
        shown.switchLaw = law;
        plots.switchLaw.show(law);
        typeset(
          byTestId("switch-law-said"),
          say("paper.switchLaw.said", { collisions: map.switches.length }),
        );
      });
    },

    forget() {
      asked.clear();
    },

    pictures: {
      paper: {
        title: say("page.scenes.paper"),
        request: () => ({ call: "paper", query: {} }),
        parameters: () => ({}),
      },
      collapse: {
        title: say("paper.collapse.picture"),
        request: () => ({ call: "cut", query: laws.queries.collapse()[0] }),
        parameters: () => ({}),
        table: () => shown.collapse && collapseTable(shown.collapse),
      },
      stiff_law: {
        title: say("paper.stiffLaw.picture"),
        request: () => ({ call: "cut", query: laws.queries.stiffLaw()[0] }),
        parameters: () => ({}),
        table: () => shown.stiffLaw && stiffLawTable(shown.stiffLaw),
      },
      switch_law: {
        title: say("paper.switchLaw.picture"),
        request: () => ({ call: "map", query: laws.queries.switchLaw() }),
        parameters: () => ({}),
        table: () => shown.switchLaw && switchLawTable(shown.switchLaw),
      },
    },
  };
}

/** @param {FrictionCurve[]} curves */
function drawKey(curves) {
  byTestId("collapse-key").replaceChildren(
    ...curves.map(({ muOverAlpha }, i) => {
      const item = document.createElement("li");
      const swatch = document.createElement("span");
      const text = document.createElement("span");
      swatch.className = `swatch line ${COLLAPSE_COLORS[i]}`;
      typeset(text, `μ/α = ${brief(muOverAlpha)}`);
      item.append(swatch, text);
      return item;
    }),
  );
}
