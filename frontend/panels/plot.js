// @ts-check

import { currentTheme, onThemeChange } from "./theme.js";

const CONFIG = {
  staticPlot: true,
  displayModeBar: false,
  showSendToCloud: false,
  responsive: false,
};

/** Resolves once the page's deferred scripts, Plotly among them, have run. */
const plotlyIsHere = new Promise((resolve) => {
  if (document.readyState === "complete") {
    resolve(undefined);
  } else {
    addEventListener("DOMContentLoaded", resolve, { once: true });
    addEventListener("load", resolve, { once: true });
  }
});

/**
 * A Plotly element that follows its size and the colour scheme.
 * @template Subject
 * @param {HTMLElement} element
 * @param {(subject: Subject, theme: import("../figures/theme.js").Theme, size: import("../figures/plot-area.js").Size) => import("../figures/plot-area.js").Figure} makeFigure
 */
export function createPlot(element, makeFigure) {
  /** @type {{subject: Subject} | null} */
  let shown = null;
  /** @type {import("../figures/plot-area.js").Size | null} */
  let size = null;

  function draw() {
    if (shown && size && size.width > 0 && size.height > 0 && "Plotly" in globalThis) {
      const { data, layout } = makeFigure(shown.subject, currentTheme(), size);
      Plotly.react(element, data, layout, CONFIG);
    }
  }

  const observer = new ResizeObserver(([{ contentRect }]) => {
    size = { width: Math.floor(contentRect.width), height: Math.floor(contentRect.height) };
    draw();
  });
  observer.observe(element);
  const endThemeChanges = onThemeChange(draw);
  plotlyIsHere.then(draw);

  return {
    /** @param {Subject} subject */
    show(subject) {
      shown = { subject };
      draw();
    },

    destroy() {
      shown = null;
      observer.disconnect();
      endThemeChanges();
      if ("Plotly" in globalThis) {
        Plotly.purge(element);
      }
    },
  };
}
