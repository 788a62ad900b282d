// @ts-check

import { textsOfMaterial } from "../../format/materials.js";
import { say } from "../../format/words.js";
import { IMPACT_PARAMETERS, impactOf, secondOf, usualOf, valuesOf } from "../../state/impact.js";
import { offered } from "../../state/scenes.js";
import { markLanguage, toldIn } from "../../widgets/elements.js";
import { byTestId, find } from "../../widgets/find.js";
import { mountParameterControl } from "../../widgets/parameter-control.js";
import { typeset } from "../../widgets/typeset.js";

/**
 * @typedef {import("../../state/impact.js").Impact} Impact
 * @typedef {import("../../state/impact.js").ImpactKey} ImpactKey
 * @typedef {import("../../state/impact.js").Material} Material
 */

/** Each told by the other: one of them is set. @type {Partial<Record<ImpactKey, ImpactKey>>} */
const INSTEAD_OF = {
  normal_restitution: "dissipative_constant_s",
  dissipative_constant_s: "normal_restitution",
};

/** What a wall does not have. */
const OF_SPHERE = ["radius_2_m", "density_2_kg_m3"];

/**
 * The material by name, and what of the impact is set by hand; in the frame of an author, of that what is
 * offered there alone.
 * @param {HTMLElement} element
 * @param {import("../../state/address/options.js").PageState} start
 * @param {object} handlers
 * @param {(material: string) => void} handlers.onMaterial
 * @param {(patch: Partial<Impact>, change?: {dragging: boolean, inputTimeStamp: number}) => void} handlers.onChange
 */
export function mountImpactControls(element, start, { onMaterial, onChange }) {
  const choice = /** @type {HTMLSelectElement} */ (byTestId("material", element));
  const inertia = byTestId("inertia", element);
  const source = find(".preset-source", element);
  const parent = find(".impact-parameters", element);
  const more = /** @type {HTMLDetailsElement} */ (byTestId("more-bodies", element));
  const second = byTestId("second", element);
  /** An ε_n that is set is that of the present velocity. */
  const note = document.createElement("p");
  note.className = "parameter-note";
  /** What the material says. @type {Record<ImpactKey, number | null> | null} */
  let usual = null;
  let usualInertia = "";
  let usualSecond = "";
  /** What is drawn again when the rest is unfolded. */
  let drawAgain = () => {};
  const names = offered(start);
  const controls = (
    names
      ? names.flatMap((name) => IMPACT_PARAMETERS.filter(({ key }) => key === name))
      : IMPACT_PARAMETERS.filter(({ folded }) => !folded)
  ).map((parameter) => control(parent, parameter));

  /** Where its numbers are from, as the work has it, and what is not from there. @param {Material} material */
  function cite(material) {
    if (source.dataset.material !== material.id) {
      const { notes, language } = textsOfMaterial(material);
      source.dataset.material = material.id;
      source.replaceChildren(
        toldIn("en", "span", material.source),
        " · ",
        toldIn(language, "span", notes),
      );
    }
  }

  /**
   * @param {HTMLElement} place
   * @param {import("../../state/impact.js").ImpactParameter} parameter
   */
  function control(place, parameter) {
    const { key } = parameter;
    const mounted = mountParameterControl(place, parameter, (value, change) => {
      const other = INSTEAD_OF[key];
      // What the material says anyway is not set by hand.
      const set = value === usual?.[key] ? null : value;
      onChange({ [key]: set, ...(other ? { [other]: null } : {}) }, change);
    });
    const root = /** @type {HTMLElement} */ (place.lastElementChild);
    if (key === "normal_restitution") {
      root.append(note);
    }
    return { key, root, ...mounted };
  }

  function unfold() {
    const place = find(".impact-parameters", more);
    if (more.open && !names && place.children.length === 0) {
      const folded = IMPACT_PARAMETERS.filter((parameter) => parameter.folded);
      controls.push(...folded.map((parameter) => control(place, parameter)));
      drawAgain();
    }
  }

  more.addEventListener("toggle", unfold);
  second.addEventListener("change", (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    onChange({ second: value === usualSecond ? null : value });
  });
  choice.addEventListener("change", () => onMaterial(choice.value));
  inertia.addEventListener("change", (event) => {
    const { value } = /** @type {HTMLInputElement} */ (event.target);
    onChange({ inertia: value === usualInertia ? null : value });
  });

  return {
    /** @param {Material[]} materials */
    offer(materials) {
      choice.replaceChildren(...materials.map(option));
    },

    /**
     * @param {Material} material
     * @param {Impact} impact
     * @param {Partial<Record<ImpactKey, number>>} workedOut what the service has worked out
     */
    show(material, impact, workedOut) {
      drawAgain = () => this.show(material, impact, workedOut);
      choice.value = material.id;
      usual = usualOf(material, impact);
      usualInertia = material.body_1.inertia;
      usualSecond = secondOf(material, impactOf(material.id));
      // What is set is not hidden.
      more.open ||=
        impact.second !== null ||
        IMPACT_PARAMETERS.some(({ key, folded }) => folded && impact[key] !== null);
      unfold();
      const values = valuesOf(material, impact);
      // What is reset in a frame goes back to what that begins with.
      const home = names ? valuesOf(material, start.impact) : usual;
      const isWall = secondOf(material, impact) === "wall";
      typeset(note, say("spheres.restitutionHolds"));
      note.hidden = impact.normal_restitution === null;
      for (const { key, root, show } of controls) {
        root.hidden = isWall && OF_SPHERE.includes(key);
        if (!root.hidden) {
          const value = values[key] ?? rounded(workedOut[key] ?? NaN);
          show(value, home[key], values[key] === null);
        }
      }
      const kind = find(`[value="${isWall ? "wall" : "sphere"}"]`, second);
      /** @type {HTMLInputElement} */ (kind).checked = true;
      const spread = find(`[value="${impact.inertia ?? usualInertia}"]`, inertia);
      /** @type {HTMLInputElement} */ (spread).checked = true;
      cite(material);
    },
  };
}

/** @param {Material} material */
function option(material) {
  const { name, language } = textsOfMaterial(material);
  const made = new Option(name, material.id);
  markLanguage(made, language);
  return made;
}

/** What is worked out, to four digits. @param {number} value */
function rounded(value) {
  return Number(value.toPrecision(4));
}
