// @ts-check

import { collapseFigure, COLLAPSE_COLORS, spreadOf } from "../figures/collapse-figure.js";
import { stiffLawFigure, stiffReach } from "../figures/stiff-law-figure.js";
import { switchLawFigure, switchLawOf } from "../figures/switch-law-figure.js";
import { brief, percentage, significant } from "../format/number.js";
import { KIND_CHOICES, VERDICT_CHOICES } from "../state/paper.js";
import { choices } from "./choices.js";
import { byTestId, find } from "./find.js";
import { mountPaperList } from "./paper-list.js";
import { createPlot } from "./plot.js";
import { typeset } from "./typeset.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/paper.js").Statement} Statement
 * @typedef {import("../figures/collapse-figure.js").FrictionCurve} FrictionCurve
 * @typedef {import("../figures/stiff-law-figure.js").StiffCut} StiffCut
 * @typedef {import("../figures/switch-law-figure.js").SwitchLaw} SwitchLaw
 */

/** Names of the choices beside the list, each a key of the state. */
const FILTERS = /** @type {const} */ ({
  paper_verdict: VERDICT_CHOICES,
  paper_kind: KIND_CHOICES,
});

/**
 * The scene "The paper": every statement with its verdict, and three results beyond it with live data.
 * @param {object} handlers
 * @param {object} handlers.load each from the server
 * @param {() => Promise<Statement[]>} handlers.load.paper
 * @param {() => Promise<FrictionCurve[]>} handlers.load.collapse
 * @param {() => Promise<StiffCut[]>} handlers.load.stiffLaw
 * @param {() => Promise<Parameters<typeof switchLawOf>[0]>} handlers.load.switchLaw
 * @param {(error: unknown) => void} handlers.onError
 * @param {(patch: Partial<PageState>) => void} handlers.onOption
 * @param {(link: string) => void} handlers.onOpen
 */
export function mountPaperScene({ load, onError, onOption, onOpen }) {
  const list = mountPaperList(byTestId("paper-list"), onOpen);
  const plots = {
    collapse: createPlot(byTestId("collapse"), collapseFigure),
    stiffLaw: createPlot(byTestId("stiff-law"), stiffLawFigure),
    switchLaw: createPlot(byTestId("switch-law"), switchLawFigure),
  };
  /** @type {{statements: Statement[] | null, collapse: FrictionCurve[] | null, stiffLaw: StiffCut[] | null, switchLaw: SwitchLaw | null}} */
  const shown = { statements: null, collapse: null, stiffLaw: null, switchLaw: null };
  const asked = new Set();
  /** @type {PageState | null} */
  let present = null;
  let listed = "";

  const filters = find(".paper-filters");
  for (const [name, items] of Object.entries(FILTERS)) {
    choices(byTestId(name.replace("_", "-")), name, items);
  }
  filters.addEventListener("change", (event) => {
    const { name, value } = /** @type {HTMLInputElement} */ (event.target);
    onOption({ [name]: value });
  });

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
      onError(error);
    }
  }

  function drawList() {
    if (!shown.statements || !present) {
      return;
    }
    const { paper_verdict, paper_kind } = present;
    const wanted = `${paper_verdict} ${paper_kind}`;
    if (listed !== wanted) {
      listed = wanted;
      list.show(shown.statements, { paper_verdict, paper_kind });
    }
  }

  return {
    /** What each panel shows, for its menu. */
    shown: () => ({
      collapse: shown.collapse,
      stiffLaw: shown.stiffLaw,
      switchLaw: shown.switchLaw,
    }),

    /** @param {PageState} state */
    follow(state) {
      present = state;
      if (state.scene !== "paper") {
        return;
      }
      for (const name of /** @type {(keyof typeof FILTERS)[]} */ (Object.keys(FILTERS))) {
        const choice = find(`[name="${name}"][value="${state[name]}"]`, filters);
        /** @type {HTMLInputElement} */ (choice).checked = true;
      }
      drawList();
      once("paper", load.paper, (statements) => {
        shown.statements = statements;
        drawList();
      });
      once("collapse", load.collapse, (curves) => {
        shown.collapse = curves;
        plots.collapse.show(curves);
        drawKey(curves);
        typeset(
          byTestId("collapse-said"),
          `Above, each friction has its own curve. Below, over ψ, they are one: apart by at most ${significant(spreadOf(curves), 1)}. Two parameters, κ and ψ, are enough.`,
        );
      });
      once("stiffLaw", load.stiffLaw, (cuts) => {
        const { reach, constant } = stiffReach(cuts);
        shown.stiffLaw = cuts;
        plots.stiffLaw.show(cuts);
        typeset(
          byTestId("stiff-law-said"),
          `Stiff springs end below |ε_t| = ${significant(constant, 5)} κ^{−5/4}/ψ (full line), which these ${cuts.length} × ${cuts[0].kappa.length} collisions reach to ${percentage(reach)}; Eq. 27 (dashed) says κ^{−1/2}.`,
        );
      });
      once("switchLaw", load.switchLaw, (map) => {
        const law = switchLawOf(map);
        shown.switchLaw = law;
        plots.switchLaw.show(law);
        typeset(
          byTestId("switch-law-said"),
          `The most switches of ${map.switches.length} collisions at each κ (points) and √κ t_c/π (line).`,
        );
      });
    },

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      asked.clear();
    },

    unmount() {
      list.unmount();
      Object.values(plots).forEach((plot) => plot.destroy());
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
