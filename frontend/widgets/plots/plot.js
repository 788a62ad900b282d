// @ts-check

import { announceCanvasReading } from "./canvas-reading.js";
import { noteRest } from "./overlay.js";
import { afterNextFrame } from "../painted.js";
import { currentTheme, onPrinting, onThemeChange } from "../theme.js";

/** A plot that is looked at; what is laid over it takes the pointer. */
const STILL = { staticPlot: true };

const CONFIG = {
  displayModeBar: false,
  showSendToCloud: false,
  responsive: false,
};

// Before Plotly makes its first canvas.
announceCanvasReading();

/** Resolves once the page's deferred scripts, Plotly among them, have run. */
const plotlyIsHere = new Promise((resolve) => {
  if (document.readyState === "complete") {
    resolve(undefined);
  } else {
    addEventListener("DOMContentLoaded", resolve, { once: true });
    addEventListener("load", resolve, { once: true });
  }
});

/** How marks are moved, which nothing is before there is a picture. @type {typeof import("./quick-draw.js").quickDraw | null} */
let quickDraw = null;

/** Where it does not arrive, Plotly draws each step. */
async function bringQuickDraw() {
  const module = await import("./quick-draw.js").catch(() => null);
  quickDraw = module?.quickDraw ?? null;
}

/**
 * A Plotly element that follows its size and the colour scheme.
 * @template Subject
 * @param {HTMLElement} element
 * @param {(subject: Subject, theme: import("../../figures/theme.js").Theme, size: import("../../figures/plot-area.js").Size) => import("../../figures/plot-area.js").Figure} makeFigure
 * @param {object} [options]
 * @param {Record<string, any>} [options.config] of Plotly
 * @param {(customdata: any) => void} [options.onPoint] told what a point stands for that was clicked
 */
export function createPlot(element, makeFigure, { config = STILL, onPoint } = {}) {
  /** @type {{subject: Subject} | null} */
  let shown = null;
  /** @type {import("../../figures/plot-area.js").Size | null} */
  let size = null;

  /** What Plotly has drawn, and what is to be seen since. @type {Record<"drawn" | "moved", import("../../figures/plot-area.js").Figure> | null} */
  let there = null;

  /** Returns whether it was done the quick way. */
  function draw(quickly = false) {
    if (!shown || !size || size.width === 0 || size.height === 0 || !("Plotly" in globalThis)) {
      return false;
    }
    const figure = makeFigure(shown.subject, currentTheme(), size);
    const isQuick =
      quickly && there && quickDraw ? quickDraw(element, there.drawn, there.moved, figure) : false;
    if (isQuick) {
      // As after Plotly's own drawing, the element holds what it shows.
      Object.assign(element, { data: figure.data, layout: figure.layout });
    } else {
      Plotly.react(element, figure.data, figure.layout, { ...CONFIG, ...config });
      if (!there) {
        afterNextFrame(bringQuickDraw);
      }
      if (onPoint && !there) {
        const plot = /** @type {any} */ (element);
        plot.on("plotly_click", (/** @type {any} */ event) => onPoint(event.points[0]?.customdata));
      }
    }
    there = { drawn: isQuick && there ? there.drawn : figure, moved: figure };
    return isQuick;
  }

  /** @param {{width: number, height: number}} place */
  function resize(place) {
    size = noteRest(element, place);
    draw();
  }

  const observer = new ResizeObserver(([{ contentRect }]) => resize(contentRect));
  observer.observe(element);
  const endPrinting = onPrinting(() => resize(element.getBoundingClientRect()));
  const endThemeChanges = onThemeChange(() => draw());
  plotlyIsHere.then(() => draw());
  // one file lets it come later
  addEventListener("restitution:plotly", () => draw(), { once: true });

  return {
    /**
     * @param {Subject} subject
     * @param {boolean} [quickly] as one of many pictures in a row
     * @returns {boolean} whether it took next to no time
     */
    show(subject, quickly = false) {
      shown = { subject };
      return draw(quickly);
    },

    destroy() {
      shown = null;
      observer.disconnect();
      endThemeChanges();
      endPrinting();
      if ("Plotly" in globalThis) {
        Plotly.purge(element);
      }
    },
  };
}
