// @ts-check

import { surfaceFigure } from "../figures/surface-figure.js";
import { dragWhenHeld } from "./drag.js";
import { createPlot } from "./plot.js";

/** Turned by dragging; the wheel keeps scrolling the page. */
const TURNABLE = { staticPlot: false, scrollZoom: false };

/** @typedef {Parameters<typeof surfaceFigure>[0]} Subject */

/**
 * A map as a surface in depth: its element, and the browser's drawing context with it, exist only
 * while it is shown.
 * @param {HTMLElement} stage
 */
export function createSurface(stage) {
  /** @type {{element: HTMLElement, plot: ReturnType<typeof createPlot>} | null} */
  let open = null;
  /** @type {Omit<Subject, "place"> | null} */
  let shown = null;
  /** @type {Subject["place"]} */
  let place = null;

  function draw() {
    if (open && shown) {
      open.plot.show({ ...shown, place });
    }
  }

  return {
    /** @param {Omit<Subject, "place">} map */
    show(map) {
      shown = map;
      if (!open) {
        const element = document.createElement("div");
        element.className = "plot surface";
        element.dataset.testid = "surface";
        element.setAttribute("role", "img");
        element.setAttribute("aria-label", "The map as a surface");
        dragWhenHeld(element);
        stage.append(element);
        open = { element, plot: createPlot(element, surfaceFigure, { config: TURNABLE }) };
      }
      draw();
    },

    /** What is present, at its height. @param {Subject["place"]} next */
    point(next) {
      place = next;
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
