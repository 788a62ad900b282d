// @ts-check

import { ABSENT, alphaInWords, inUnits, significant } from "../../format/number.js";
import { collisionOfImpact } from "../../state/parameters.js";
import { byTestId } from "../../widgets/find.js";
import { typeset } from "../../widgets/typeset.js";
import { write } from "../../widgets/write.js";

/**
 * What an impact is in SI units and in scaled terms, and where the model is left.
 * @param {HTMLElement} element
 */
export function createImpactResult(element) {
  const list = byTestId("impact-result", element);
  const warnings = byTestId("impact-warnings", element);
  const refusal = byTestId("impact-refusal", element);
  /** The values, by their names. @type {Map<string, HTMLElement>} */
  const shown = new Map();

  /** @param {string} name */
  function place(name) {
    const term = document.createElement("dt");
    const description = document.createElement("dd");
    typeset(term, name);
    list.append(term, description);
    shown.set(name, description);
    return description;
  }

  return {
    /** @param {import("../../api/answers.js").Scaling} scaling */
    show(scaling) {
      typeset(refusal, "");
      list.hidden = false;
      for (const [name, value] of rowsOf(scaling)) {
        write(shown.get(name) ?? place(name), value);
      }
      const texts = scaling.warnings.map(({ text }) => text);
      for (const item of [...warnings.children].slice(texts.length)) {
        item.remove();
      }
      for (const [i, text] of texts.entries()) {
        const item = warnings.children[i] ?? warnings.appendChild(document.createElement("li"));
        typeset(/** @type {HTMLElement} */ (item), text);
      }
    },

    /** Why there is none. @param {string} reason */
    refuse(reason) {
      list.hidden = true;
      warnings.replaceChildren();
      typeset(refusal, `Not this one: ${reason}`);
    },
  };
}

/**
 * @param {import("../../api/answers.js").Scaling} scaling
 * @returns {[string, string][]}
 */
function rowsOf(scaling) {
  return [
    ["contact lasts", inUnits(scaling.contact_duration_s, "s")],
    ["largest compression", inUnits(scaling.maximum_compression_m, "m")],
    ["largest normal force", inUnits(scaling.maximum_normal_force_n, "N")],
    ["effective mass", inUnits(1000 * scaling.effective_mass_kg, "g")],
    ["k_t", inUnits(scaling.tangential_stiffness_n_per_m, "N/m")],
    ["α", alphaInWords(collisionOfImpact(scaling).alpha)],
    ["κ", significant(scaling.kappa)],
    ["μ/α", significant(scaling.mu_over_alpha)],
    ["g_t/g_n", significant(scaling.gt_over_gn)],
    ["ψ", significant(scaling.psi ?? Infinity)],
    ["η", significant(scaling.damping)],
    ["ε_n", significant(scaling.epsilon_n)],
    ["ε_t of the spring", significant(scaling.epsilon_t)],
    ["switches", String(scaling.switches ?? ABSENT)],
  ];
}
