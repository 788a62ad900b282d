// @ts-check

import { createLatest } from "./latest.js";
import { axesMuOverAlpha, heldView, mapView, sameView } from "./map-view.js";

/**
 * @typedef {import("./map-view.js").MapView} MapView
 * @typedef {{muOverAlpha: number, view: MapView, counts: Counts}} MapWish
 * @typedef {{kappa: number, gtOverGn: number}} Counts cells along each axis
 */

/** @type {Counts} */
export const FULL_MAP = { kappa: 240, gtOverGn: 180 };

/** While μ/α is dragged: the trace goes first. @type {Counts} */
export const QUICK_MAP = { kappa: 80, gtOverGn: 60 };

/** At most so often, in ms. */
const PAUSE = 80;

/**
 * The map that belongs to a state. It depends on μ/α, but not over ψ, and its axes alone; these follow a collision
 * beyond them when a drag is over.
 * @template Grid
 * @param {object} options
 * @param {(wish: MapWish, signal: AbortSignal) => Promise<Grid>} options.load
 * @param {(map: {grid: Grid, view: MapView, muOverAlpha: number}) => void} options.onMap
 * @param {(error: unknown) => void} options.onError
 */
export function createMapLoader({ load, onMap, onError }) {
  /** @type {MapWish | null} */
  let asked = null;
  const latest = createLatest({
    load,
    onAnswer: (grid, { view, muOverAlpha }) => onMap({ grid, view, muOverAlpha }),
    onError,
    pause: PAUSE,
  });

  return {
    /**
     * @param {import("./url.js").PageState} state
     * @param {boolean} dragging
     */
    follow(state, dragging) {
      const view =
        dragging && asked ? heldView(asked.view, state.collision) : mapView(state.collision, state);
      const muOverAlpha = axesMuOverAlpha(view, state.collision);
      const isAsked =
        asked?.muOverAlpha === muOverAlpha &&
        sameView(asked.view, view) &&
        (dragging || asked.counts === FULL_MAP);
      if (!isAsked) {
        asked = { muOverAlpha, view, counts: dragging ? QUICK_MAP : FULL_MAP };
        latest.request(asked);
      }
    },

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      asked = null;
    },
  };
}
