// @ts-check

import { errorBound, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { INTEGRATORS } from "../../state/accuracy.js";
import { byTestId, find } from "../../widgets/find.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { typeset } from "../../widgets/typeset.js";
import { overlayFigure } from "./overlay-figure.js";

/**
 * The force in time steps over the exact force.
 * @param {HTMLElement} element
 * @param {(patch: {integrator: string}) => void} onAccuracy
 */
export function mountStepOverlay(element, onAccuracy) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, overlayFigure);
  const stage = find(".plot-stage", element);
  const name = byTestId("overlay-name", element);
  /** @type {import("../../api/answers.js").Stepped | null} */
  let shown = null;
  const integrators = /** @type {HTMLSelectElement} */ (byTestId("integrator", element));
  integrators.append(...INTEGRATORS.map(({ id, title }) => new Option(title, id)));
  integrators.addEventListener("change", () => onAccuracy({ integrator: integrators.value }));

  return {
    shown: () => shown,

    /** @param {import("../../state/accuracy.js").Accuracy} accuracy */
    options({ steps, integrator }) {
      integrators.value = integrator;
      typeset(byTestId("overlay-steps", element), say("overlay.inSteps", { steps }));
    },

    /**
     * @param {import("../../api/answers.js").Trace} trace
     * @param {import("../../api/answers.js").Stepped} stepped of the same collision
     */
    show(trace, stepped) {
      shown = stepped;
      showReason(stage, "");
      plot.show({ trace, stepped });
      const result = say("overlay.offBy", {
        value: significant(stepped.epsilon_t, 3),
        error: errorBound(stepped.error_bound).replace("±", ""),
      });
      const exact = significant(trace.epsilon_t, 3);
      const steps = stepped.method_time.length;
      typeset(name, result);
      plotElement.setAttribute("aria-label", say("overlay.described", { steps, result, exact }));
    },

    /** @param {string} reason */
    showReason(reason) {
      shown = null;
      showReason(stage, reason);
      typeset(name, say("overlay.name"));
    },
  };
}
