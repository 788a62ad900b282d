// @ts-check

import { surfaceFigure } from "../figures/surface-figure.js";
import { placeOnMap } from "../state/map-view.js";
import { createPlot } from "./plot.js";

/** Turned by dragging; the wheel keeps scrolling the page. */
const TURNABLE = { staticPlot: false, scrollZoom: false };

/**
 * The map as a surface in depth: its element, and the browser's drawing context with it, exist only
 * while it is shown.
 * @param {HTMLElement} stage
 */
export function createSurface(stage) {
  /** @type {{element: HTMLElement, plot: ReturnType<typeof createPlot>} | null} */
  let open = null;
  /** @type {import("../figures/map-figure.js").ShownMap | null} */
  let shown = null;
  /** @type {Pick<import("../api/client.js").CollisionAnswer, "parameters" | "epsilon_t" | "switches"> | null} */
  let present = null;

  function draw() {
    if (open && shown) {
      const place = present && { ...present, ...placeOnMap(shown.view, present.parameters) };
      open.plot.show({ ...shown, place });
    }
  }

  return {
    /** @param {NonNullable<typeof shown>} map */
    show(map) {
      shown = map;
      if (!open) {
        const element = document.createElement("div");
        element.className = "plot surface";
        element.dataset.testid = "surface";
        element.setAttribute("role", "img");
        element.setAttribute("aria-label", "The map as a surface");
        stage.append(element);
        open = { element, plot: createPlot(element, surfaceFigure, { config: TURNABLE }) };
      }
      draw();
    },

    /** The present collision, as the server has worked it out. @param {NonNullable<typeof present>} result */
    point(result) {
      present = result;
      draw();
    },

    close() {
      open?.plot.destroy();
      open?.element.remove();
      open = null;
      shown = null;
    },
  };
}
