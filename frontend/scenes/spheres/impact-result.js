// @ts-check

import { ABSENT, alphaInWords, inUnits, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { collisionOfImpact } from "../../state/parameters.js";
import { markLanguage } from "../../widgets/elements.js";
import { byTestId } from "../../widgets/find.js";
import { typeset } from "../../widgets/typeset.js";
import { write } from "../../widgets/write.js";
import { warningInWords } from "./warnings.js";

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
      refusal.replaceChildren();
      list.hidden = false;
      for (const [name, value] of rowsOf(scaling)) {
        write(shown.get(name) ?? place(name), value);
      }
      const told = scaling.warnings.map(warningInWords);
      for (const item of [...warnings.children].slice(told.length)) {
        item.remove();
      }
      for (const [i, { text, language }] of told.entries()) {
        const item = /** @type {HTMLElement} */ (
          warnings.children[i] ?? warnings.appendChild(document.createElement("li"))
        );
        markLanguage(item, language);
        typeset(item, text);
      }
    },

    /**
     * Why there is none.
     * @param {string} reason
     * @param {string} [language] of the reason, where it is not that of the page
     */
    refuse(reason, language = "en") {
      list.hidden = true;
      warnings.replaceChildren();
      const why = document.createElement("span");
      markLanguage(why, language);
      typeset(why, reason);
      refusal.replaceChildren(say("spheres.result.refused"), " ", why);
    },
  };
}

/**
 * @param {import("../../api/answers.js").Scaling} scaling
 * @returns {[string, string][]}
 */
function rowsOf(scaling) {
  return [
    [say("codes.duration"), inUnits(scaling.contact_duration_s, "s")],
    [say("spheres.result.compression"), inUnits(scaling.maximum_compression_m, "m")],
    [say("spheres.result.force"), inUnits(scaling.maximum_normal_force_n, "N")],
    [say("spheres.result.mass"), inUnits(1000 * scaling.effective_mass_kg, "g")],
    ["k_t", inUnits(scaling.tangential_stiffness_n_per_m, "N/m")],
    ["α", alphaInWords(collisionOfImpact(scaling).alpha)],
    ["κ", significant(scaling.kappa)],
    ["μ/α", significant(scaling.mu_over_alpha)],
    ["g_t/g_n", significant(scaling.gt_over_gn)],
    ["ψ", significant(scaling.psi ?? Infinity)],
    ["η", significant(scaling.damping)],
    ["ε_n", significant(scaling.epsilon_n)],
    [say("spheres.result.ofSpring"), significant(scaling.epsilon_t)],
    [say("symbols.switchesName"), String(scaling.switches ?? ABSENT)],
  ];
}
