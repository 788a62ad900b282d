// @ts-check

import { say } from "../../format/words.js";
import { dragWhenHeld } from "../drag.js";
import { createPlot } from "./plot.js";

/** Turned by dragging; the wheel keeps scrolling the page. */
const TURNABLE = { staticPlot: false, scrollZoom: false };

/** @typedef {Parameters<typeof import("../../figures/surface-figure.js").surfaceFigure>[0]} Subject */

/**
 * A map as a surface in depth: its element, and the browser's drawing context with it, exist only
 * while it is shown.
 * @param {HTMLElement} stage
 */
export function createSurface(stage) {
  /** @type {{element: HTMLElement, plot: ReturnType<typeof createPlot> | null} | null} its figure comes when it is first shown */
  let open = null;
  /** @type {Omit<Subject, "place"> | null} */
  let shown = null;
  /** @type {Subject["place"]} */
  let place = null;

  function draw() {
    if (open?.plot && shown) {
      open.plot.show({ ...shown, place });
    }
  }

  /** @param {{element: HTMLElement, plot: ReturnType<typeof createPlot> | null}} mine */
  async function fill(mine) {
    const module = await import("../../figures/surface-figure.js").catch(() => null);
    if (open === mine && module) {
      mine.plot = createPlot(mine.element, module.surfaceFigure, { config: TURNABLE });
      draw();
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
        element.setAttribute("aria-label", say("map.surface"));
        dragWhenHeld(element);
        stage.append(element);
        open = { element, plot: null };
        fill(open);
      }
      draw();
    },

    /** What is present, at its height. @param {Subject["place"]} next */
    point(next) {
      place = next;
      draw();
    },

    close() {
      open?.plot?.destroy();
      open?.element.remove();
      open = null;
      shown = null;
    },
  };
}
