// @ts-check

import { restitutionColors, restitutionPlace, switchClasses } from "../../figures/color-scales.js";
import { brief } from "../../format/number.js";
import { placeWithin } from "../../state/scales.js";
import { currentTheme } from "../theme.js";

const TICKS = [-1, -0.5, -0.1, 0, 0.1, 0.5, 1];

/**
 * The legend of the map: a scale with the present value marked, or one box for each count.
 * @param {HTMLElement} element
 */
export function createMapLegend(element) {
  let drawn = "";
  let epsilon = 0;
  let switches = /** @type {number | null} */ (null);

  function mark() {
    const { x, beyond } = placeWithin(restitutionPlace(epsilon), 0);
    element.style.setProperty("--place", String(x));
    element.dataset.beyond = String(beyond.x);
    for (const box of element.querySelectorAll("[data-switches]")) {
      const own = Number(/** @type {HTMLElement} */ (box).dataset.switches);
      const isLast = box === box.parentElement?.lastElementChild;
      const here = switches !== null && (own === switches || (isLast && switches > own));
      box.toggleAttribute("data-here", here);
    }
  }

  return {
    /**
     * @param {"epsilon_t" | "switches"} quantity
     * @param {number} most
     */
    draw(quantity, most) {
      const { dark } = currentTheme();
      const wanted = `${quantity} ${dark} ${quantity === "switches" ? most : ""}`;
      if (wanted === drawn) {
        return;
      }
      drawn = wanted;
      element.dataset.quantity = quantity;
      element.replaceChildren(
        ...(quantity === "switches" ? countBoxes(most, dark) : [restitutionScale(dark)]),
      );
      mark();
    },

    /** @param {{epsilon_t: number, switches: number | null}} result */
    point(result) {
      epsilon = result.epsilon_t;
      switches = result.switches;
      mark();
    },
  };
}

/** @param {boolean} dark */
function restitutionScale(dark) {
  const scale = document.createElement("div");
  scale.className = "legend-scale";
  scale.style.setProperty(
    "background",
    `linear-gradient(90deg, ${restitutionColors(dark).join(", ")})`,
  );
  const mark = document.createElement("span");
  mark.className = "legend-mark";
  scale.append(
    mark,
    ...TICKS.map((tick) => {
      const label = document.createElement("span");
      label.className = "legend-tick";
      label.textContent = brief(tick);
      label.style.setProperty("--share", String(restitutionPlace(tick)));
      return label;
    }),
  );
  return scale;
}

/**
 * @param {number} most
 * @param {boolean} dark
 */
function countBoxes(most, dark) {
  return switchClasses(most, dark).map(({ switches, label, color }) => {
    const box = document.createElement("span");
    box.className = "legend-count";
    box.dataset.switches = String(switches);
    const swatch = document.createElement("span");
    swatch.style.setProperty("background", color);
    box.append(swatch, label);
    return box;
  });
}
