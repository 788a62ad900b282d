// @ts-check

import { find } from "../../widgets/find.js";

/**
 * The switch that adds the energy to the velocity.
 * @param {HTMLElement} element the panel of the velocity
 * @param {(energy: "hidden" | "shown") => void} onChange
 */
export function mountEnergyToggle(element, onChange) {
  const input = /** @type {HTMLInputElement} */ (find(`[name="energy"]`, element));
  const key = find(".energy-key", element);
  input.addEventListener("change", () => onChange(input.checked ? "shown" : "hidden"));

  return {
    /** @param {"hidden" | "shown"} energy */
    show(energy) {
      const isShown = energy === "shown";
      // This runs at every step of a drag, which changes nothing here.
      if (input.checked !== isShown || key.hidden === isShown) {
        input.checked = isShown;
        key.hidden = !isShown;
      }
    },
  };
}
