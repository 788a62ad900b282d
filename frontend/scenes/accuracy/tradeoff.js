// @ts-check

import { say } from "../../format/words.js";
import { accuracyQuery, METHODS } from "../../state/accuracy.js";
import { REGIONS, STATISTICS } from "../../state/tradeoff-options.js";
import { choices, choose, onChoice } from "../../widgets/choices.js";
import { byTestId, find } from "../../widgets/find.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { currentTheme, onThemeChange } from "../../widgets/theme.js";
import { seriesOf, tradeoffFigure } from "./tradeoff-figure.js";

/**
 * @typedef {import("./tradeoff-figure.js").Row} Row
 * @typedef {import("../../api/answers.js").Tradeoff} Tradeoff
 * @typedef {import("../../state/address/options.js").PageState} PageState
 */

/** Points that are clicked and read, unlike those of the other plots. */
const TOUCHABLE = { staticPlot: false, scrollZoom: false, doubleClick: false };

/** The marks of the plot as letters. */
const MARKS = /** @type {Record<string, string>} */ ({
  star: "★",
  square: "■",
  diamond: "◆",
  x: "✗",
  circle: "●",
  "circle-open": "○",
  "triangle-up": "▲",
  "triangle-up-open": "△",
  "triangle-down-open": "▽",
  hexagon: "⬢",
});

/**
 * Error against time of every method, as it was measured.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(patch: Partial<PageState>) => void} handlers.onOption
 * @param {(patch: Partial<import("../../state/accuracy.js").Accuracy>) => void} handlers.onAccuracy
 */
export function mountTradeoff(element, { onOption, onAccuracy }) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, tradeoffFigure, {
    config: TOUCHABLE,
    onPoint: chooseMethod,
  });
  /** @type {{tradeoff: Tradeoff, state: PageState} | null} */
  let shown = null;

  choices(byTestId("region", element), "region", REGIONS);
  choices(byTestId("statistic", element), "statistic", STATISTICS);
  onChoice(element, onOption);

  function drawLegend() {
    if (shown) {
      const theme = currentTheme();
      byTestId("tradeoff-legend", element).replaceChildren(
        ...seriesOf(shown.tradeoff.rows).map(({ name, color, symbol }) =>
          legendItem(name, MARKS[symbol], String(theme[color])),
        ),
      );
    }
  }
  onThemeChange(drawLegend);

  /** @param {Row | undefined} row */
  function chooseMethod(row) {
    if (row && METHODS.some(({ id }) => id === row.method) && !("spring" in row.options)) {
      onAccuracy({ method: row.method, ...row.options });
    }
  }

  return {
    /** Which choices are made. @param {PageState} state */
    options({ region, statistic }) {
      choose(element, { region, statistic });
    },

    /**
     * @param {Tradeoff} tradeoff
     * @param {PageState} state
     */
    show(tradeoff, state) {
      const { rows, measured_at: measuredAt, machine } = tradeoff;
      const isNew = tradeoff !== shown?.tradeoff;
      shown = { tradeoff, state };
      plot.show({
        rows,
        statistic: /** @type {any} */ (`error_${state.statistic}`),
        chosen: isChosen(state.accuracy),
      });
      if (isNew) {
        drawLegend();
        byTestId("tradeoff-source", element).textContent = say("tradeoff.source", {
          date: measuredAt.slice(0, 10),
          machine,
        });
        plotElement.setAttribute(
          "aria-label",
          say("tradeoff.described", { ways: seriesOf(rows).length }),
        );
      }
    },
  };
}

/**
 * @param {import("../../state/accuracy.js").Accuracy} accuracy
 * @returns {(row: Row) => boolean}
 */
function isChosen(accuracy) {
  const query = accuracyQuery(accuracy);
  return ({ method, options }) =>
    method === query.method &&
    Object.entries(options).every(([knob, value]) => query[knob] === String(value));
}

/**
 * @param {string} name
 * @param {string} mark
 * @param {string} color
 */
function legendItem(name, mark, color) {
  const item = document.createElement("li");
  const swatch = document.createElement("span");
  swatch.className = "swatch mark";
  swatch.style.setProperty("color", color);
  swatch.textContent = mark;
  item.append(swatch, name);
  return item;
}
