// @ts-check

import { IMPACT_PARAMETERS, valuesOf } from "../state/impact.js";
import { byTestId, find } from "./find.js";
import { mountParameterControl } from "./parameter-control.js";
import { typeset } from "./typeset.js";

/**
 * @typedef {import("../state/impact.js").Impact} Impact
 * @typedef {import("../state/impact.js").Material} Material
 */

/**
 * The material by name, and what of the impact is set by hand.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(material: string) => void} handlers.onMaterial
 * @param {(patch: Partial<Impact>, change: {dragging: boolean, inputTimeStamp: number}) => void} handlers.onChange
 */
export function mountImpactControls(element, { onMaterial, onChange }) {
  const choice = /** @type {HTMLSelectElement} */ (byTestId("material", element));
  const source = find(".preset-source", element);
  const parent = find(".impact-parameters", element);
  const controls = IMPACT_PARAMETERS.map((parameter) => ({
    key: parameter.key,
    ...mountParameterControl(parent, parameter, (value, change) =>
      onChange({ [parameter.key]: value }, change),
    ),
  }));
  choice.addEventListener("change", () => onMaterial(choice.value));

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
      const values = valuesOf(material, impact);
      const usual = valuesOf(material, { ...impact, ...NOTHING });
      for (const { key, show } of controls) {
        show(values[key] ?? rounded(stiffness), usual[key] ?? rounded(stiffness));
      }
      typeset(source, `${material.source} · ${material.notes}`);
    },
  };
}

const NOTHING = Object.fromEntries(IMPACT_PARAMETERS.map(({ key }) => [key, null]));

/** Mindlin's stiffness, which is worked out, to four digits. @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(4));
}
