// @ts-check

import { errorColors } from "../../figures/color-scales.js";
import { powerOfTen } from "../../format/number.js";
import { say } from "../../format/words.js";
import { METHODS, titleOf } from "../../state/accuracy.js";
import { horizontalAxis } from "../../state/map-view.js";
import { MAP_AXES, mountCrosshair } from "../../widgets/plots/crosshair.js";
import { byTestId, find } from "../../widgets/find.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { showReason } from "../../widgets/show-reason.js";
import { currentTheme, onThemeChange } from "../../widgets/theme.js";
import { ERROR_DECADES, errorMapFigure } from "./error-map-figure.js";

/** The ends of the scale stand for what lies beyond them, too. */
const SIGNS = new Map([
  [ERROR_DECADES.low, "≤\u00a0"],
  [ERROR_DECADES.high, "≥\u00a0"],
]);

/**
 * Where on the map the chosen method is off.
 * @param {HTMLElement} element
 * @param {(place: Record<string, number>, change: import("../../state/store.js").Change) => void} onPlace
 */
export function mountErrorMap(element, onPlace) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, errorMapFigure);
  const stage = find(".plot-stage", element);
  const crosshair = mountCrosshair(find(".crosshair", element), MAP_AXES, onPlace);
  drawLegend();
  onThemeChange(drawLegend);

  function drawLegend() {
    const { low, high } = ERROR_DECADES;
    const bar = document.createElement("div");
    const colors = errorColors(currentTheme().dark).join(", ");
    bar.className = "legend-scale";
    bar.style.setProperty("background", `linear-gradient(90deg, ${colors})`);
    for (let power = low; power <= high; power += 2) {
      const tick = document.createElement("span");
      tick.className = "legend-tick";
      tick.textContent = `${SIGNS.get(power) ?? ""}${powerOfTen(power)}`;
      tick.style.setProperty("--share", String((power - low) / (high - low)));
      bar.append(tick);
    }
    byTestId("error-legend", element).replaceChildren(bar);
  }

  return {
    point: crosshair.point,

    /** Whose error it is. @param {import("../../state/accuracy.js").Accuracy} accuracy */
    name({ method, steps }) {
      const error =
        method === "timestep"
          ? say("errorMap.ofSteps", { steps })
          : say("errorMap.ofMethod", { method: titleOf(METHODS, method) });
      byTestId("error-map-method", element).textContent = error;
      plotElement.setAttribute("aria-label", say("errorMap.described", { error }));
    },

    /**
     * @param {Float64Array[]} errors
     * @param {import("../../state/map-view.js").MapView} view
     * @param {Pick<import("../../state/address/options.js").PageState, "map_x" | "alpha">} options
     */
    show(errors, view, { map_x, alpha }) {
      showReason(stage, "");
      plot.show({ errors, view, horizontal: horizontalAxis(view, map_x, alpha) });
      crosshair.lieOn(view);
    },

    /** @param {string} reason */
    showReason: (reason) => showReason(stage, reason),
  };
}
