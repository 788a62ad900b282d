// @ts-check

import { IMPACT_PARAMETERS, impactOf, valuesOf } from "../../state/impact.js";
import { byTestId, find } from "../../widgets/find.js";
import { mountParameterControl } from "../../widgets/parameter-control.js";
import { typeset } from "../../widgets/typeset.js";

/**
 * @typedef {import("../../state/impact.js").Impact} Impact
 * @typedef {import("../../state/impact.js").ImpactKey} ImpactKey
 * @typedef {import("../../state/impact.js").Material} Material
 */

/**
 * The material by name, and what of the impact is set by hand.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(material: string) => void} handlers.onMaterial
 * @param {(patch: Partial<Impact>, change?: {dragging: boolean, inputTimeStamp: number}) => void} handlers.onChange
 */
export function mountImpactControls(element, { onMaterial, onChange }) {
  const choice = /** @type {HTMLSelectElement} */ (byTestId("material", element));
  const inertia = byTestId("inertia", element);
  const source = find(".preset-source", element);
  const parent = find(".impact-parameters", element);
  /** What the material says. @type {Record<ImpactKey, number | null> | null} */
  let usual = null;
  let usualInertia = "";
  const controls = IMPACT_PARAMETERS.map((parameter) => ({
    key: parameter.key,
    ...mountParameterControl(parent, parameter, (value, change) => {
      // What the material says anyway is not set by hand.
      onChange({ [parameter.key]: value === usual?.[parameter.key] ? null : value }, change);
    }),
  }));
  choice.addEventListener("change", () => onMaterial(choice.value));
  inertia.addEventListener("change", (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    onChange({ inertia: value === usualInertia ? null : value });
  });

  return {
    /** @param {Material[]} materials */
    offer(materials) {
      choice.replaceChildren(...materials.map(({ id, title }) => new Option(title, id)));
    },

    /**
     * @param {Material} material
     * @param {Impact} impact
     * @param {number} stiffness where it is Mindlin's, what that is
     */
    show(material, impact, stiffness) {
      choice.value = material.id;
      usual = valuesOf(material, impactOf(material.id));
      usualInertia = material.body_1.inertia;
      const values = valuesOf(material, impact);
      for (const { key, show } of controls) {
        show(values[key] ?? rounded(stiffness), usual[key], { isWorkedOut: values[key] === null });
      }
      const spread = find(`[value="${impact.inertia ?? usualInertia}"]`, inertia);
      /** @type {HTMLInputElement} */ (spread).checked = true;
      typeset(source, `${material.source} · ${material.notes}`);
    },
  };
}

/** Mindlin's stiffness, which is worked out, to four digits. @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(4));
}
