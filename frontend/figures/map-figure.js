// @ts-check

import { PLOT_SYMBOLS } from "../format/symbols.js";
import { restitutionStops, switchClasses, switchStops } from "./color-scales.js";
import { axisTitle, baseLayout, innerSize, MAP_MARGIN } from "./plot-area.js";
import { regionLabels } from "./region-labels.js";
import { horizontalName, shareAxis } from "./share-axis.js";
import { legible } from "./spread.js";

/**
 * A map and how it is to be seen.
 * @typedef {object} ShownMap
 * @property {import("../api/answers.js").MapGrid} grid
 * @property {import("../state/map-view.js").MapView} view
 * @property {import("../state/map-view.js").HorizontalAxis} horizontal
 * @property {"epsilon_t" | "switches"} quantity
 * @property {number} [most] switches, up to which there are colours
 * @property {number} [muOverAlpha] of the collisions on it
 * @property {import("../state/presets.js").Letter[]} [letters] of Fig. 5, to be shown with the switches
 */

const NUMBER_PIXELS = 18;
const LETTER_PIXELS = 15;

/**
 * The map of Figs. 3 and 4: ε_t or the number of switches over κ and g_t/g_n or ψ. Its axes are shares of
 * the view, 0 … 1, logarithmic or not, and only their ticks tell the values.
 * @param {ShownMap} map
 * @param {import("./theme.js").Theme} theme
 * @param {import("./plot-area.js").Size} size
 * @returns {import("./plot-area.js").Figure}
 */
export function mapFigure(map, theme, size) {
  const { grid, view, horizontal, quantity, most = 0 } = map;
  return {
    data: [
      {
        name: quantity,
        // an image of its own: one for both would stay in squares, or smooth
        uid: quantity,
        type: "heatmap",
        z: quantity === "switches" ? grid.switches.map(orMany) : grid.epsilon_t,
        x0: 0,
        dx: 1 / (grid.kappa.length - 1),
        y0: 0,
        dy: 1 / (grid.gt_over_gn.length - 1),
        ...mapColoring(quantity, most, theme.dark),
        showscale: false,
        // Counts have no values between them.
        zsmooth: quantity === "epsilon_t" ? "fast" : false,
      },
      ...(quantity === "switches" ? countsAndLetters(map, theme, size) : []),
    ],
    layout: {
      ...baseLayout(theme, size, MAP_MARGIN),
      xaxis: {
        ...shareAxis(theme, horizontal.scale, view.scale),
        title: axisTitle(horizontalName(horizontal), 6, theme),
      },
      yaxis: {
        ...shareAxis(theme, view.gtOverGn, view.scale),
        title: axisTitle(PLOT_SYMBOLS[view.vertical], 2, theme),
      },
    },
  };
}

/**
 * As in Fig. 4: the number of switches in each area that has room for it, and the letters of Fig. 5 where
 * their collisions lie, those that do not cover one above.
 * @param {ShownMap} map
 * @param {import("./theme.js").Theme} theme
 * @param {import("./plot-area.js").Size} size
 */
function countsAndLetters({ grid, view, muOverAlpha = 1, letters = [] }, theme, size) {
  const inner = innerSize(size, MAP_MARGIN, theme);
  // They are undamped collisions.
  const known = view.damping > 0 ? [] : letters;
  // Beside their place, where the crosshair is when it is at one of them.
  const aside = (LETTER_PIXELS * theme.unit) / inner.width;
  const placed = known.map(({ letter, kappa, psi }) => ({
    letter,
    x: view.kappa.toShare(kappa) + aside,
    y: view.gtOverGn.toShare(psi * muOverAlpha),
  }));
  const seen = legible(
    placed.filter(({ x, y }) => x > 0 && x < 1 && y > 0 && y < 1),
    ({ y }) => y,
    (LETTER_PIXELS * theme.unit) / inner.height,
  );
  const counts = regionLabels(grid.switches, inner, (NUMBER_PIXELS + 6) * theme.unit, seen);
  const words = {
    type: "scatter",
    mode: "markers+text",
    hoverinfo: "skip",
    cliponaxis: false,
  };
  return [
    {
      ...words,
      name: "numbers of switches",
      x: counts.map(({ x }) => x),
      y: counts.map(({ y }) => y),
      text: counts.map(({ value }) => String(value)),
      textfont: { size: 11 * theme.unit, color: theme.ink },
      marker: {
        size: NUMBER_PIXELS * theme.unit,
        color: theme.paper,
        line: { width: 1.25 * theme.unit, color: theme.ink },
      },
    },
    {
      ...words,
      name: "letters of Fig. 5",
      x: seen.map(({ x }) => x),
      y: seen.map(({ y }) => y),
      text: seen.map(({ letter }) => letter),
      textfont: { size: 11 * theme.unit, color: theme.ink },
      marker: { size: LETTER_PIXELS * theme.unit, color: theme.paper, symbol: "square" },
    },
  ];
}

/**
 * What was not counted has more switches than could be: it takes the last colour.
 * @param {Int32Array | Float64Array} switches
 */
function orMany(switches) {
  return switches.includes(NaN)
    ? switches.map((count) => (Number.isNaN(count) ? MANY : count))
    : switches;
}

/** More than there is a colour of its own for. */
const MANY = 1000;

/**
 * The most switches anywhere on a map, or as many as there were before it: counts keep their colours
 * while a hand drags, though a coarse map misses some, and its counts change from step to step.
 * @param {Pick<import("../api/answers.js").MapGrid, "switches">} grid
 * @param {number} [before]
 */
export function mostSwitches({ switches }, before = 0) {
  let most = 0;
  for (const row of switches) {
    for (const count of row) {
      // and not by Math.max: what was not counted is NaN
      most = count > most ? count : most;
    }
  }
  // with damping all are odd, without it even
  return Math.max(most, before - Math.abs((before - most) % 2));
}

/**
 * The colours of a quantity and the range they span.
 * @param {"epsilon_t" | "switches"} quantity
 * @param {number} most switches
 * @param {boolean} dark
 */
export function mapColoring(quantity, most, dark) {
  if (quantity === "epsilon_t") {
    return { zmin: -1, zmax: 1, colorscale: restitutionStops(dark) };
  }
  const classes = switchClasses(most, dark);
  const zmin = classes[0].switches - 1;
  return { zmin, zmax: zmin + 2 * classes.length, colorscale: switchStops(classes) };
}
