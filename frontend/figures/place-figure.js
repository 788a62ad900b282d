// @ts-check

import { mapFigure } from "./map-figure.js";

/**
 * The universal map with the place of one collision.
 * @param {import("./map-figure.js").ShownMap & {place: {x: number, y: number} | null}} subject
 * @param {import("./theme.js").Theme} theme
 * @param {import("./plot-area.js").Size} size
 * @returns {import("./plot-area.js").Figure}
 */
export function placeFigure({ place, ...map }, theme, size) {
  const { data, layout } = mapFigure(map, theme, size);
  const ring = {
    name: "present impact",
    type: "scatter",
    mode: "markers",
    x: place ? [place.x] : [],
    y: place ? [place.y] : [],
    marker: {
      size: 13 * theme.unit,
      color: theme.paper,
      line: { width: 2.5 * theme.unit, color: theme.ink },
    },
    cliponaxis: false,
  };
  return { data: [...data, ring], layout };
}
