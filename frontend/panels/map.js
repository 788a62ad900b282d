// @ts-check

import { mapFigure, mostSwitches } from "../figures/map-figure.js";
import { MAP_MARGIN } from "../figures/plot-area.js";
import { typable } from "../format/number.js";
import { collisionAt, placeOnMap } from "../state/map-view.js";
import { find } from "./find.js";
import { createMapLegend } from "./map-legend.js";
import { layOver } from "./overlay.js";
import { createPlot } from "./plot.js";
import { createSurface } from "./surface.js";
import { onThemeChange } from "./theme.js";

/** One press of an arrow key, as a share of the map. */
const KEY_STEP = 0.005;

/** @type {Record<string, {right: number, up: number} | undefined>} */
const DIRECTIONS = {
  ArrowRight: { right: 1, up: 0 },
  ArrowLeft: { right: -1, up: 0 },
  ArrowUp: { right: 0, up: 1 },
  ArrowDown: { right: 0, up: -1 },
};

/**
 * The map with its crosshair, which is laid over the plot so that moving it draws nothing anew.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(place: {kappa?: number, gt_over_gn?: number}, change: {dragging: boolean, inputTimeStamp: number}) => void} handlers.onPlace
 * @param {(patch: Record<string, string>) => void} handlers.onOption
 */
export function mountMap(element, { onPlace, onOption }) {
  const plotElement = find(".plot", element);
  const plot = createPlot(plotElement, mapFigure);
  const legend = createMapLegend(find(".map-legend", element));
  const crosshair = find(".crosshair", element);
  const beyond = find(".beyond", crosshair);
  layOver(crosshair, MAP_MARGIN);
  const surface = createSurface(find(".plot-stage", element));
  /** @type {import("../figures/map-figure.js").ShownMap | null} */
  let shown = null;
  /** @type {import("../state/parameters.js").Collision | null} */
  let present = null;
  /** @type {DOMRect | null} */
  let box = null;
  let chosen = "";
  let isMoving = false;

  /**
   * @param {PointerEvent} event
   * @param {boolean} dragging
   */
  function place(event, dragging) {
    if (shown && box && present) {
      const x = (event.clientX - box.left) / box.width;
      const y = (box.bottom - event.clientY) / box.height;
      const there = collisionAt(shown.view, x, y, present.mu_over_alpha);
      onPlace(there, { dragging, inputTimeStamp: event.timeStamp });
    }
  }

  crosshair.addEventListener("pointerdown", (event) => {
    if (event.button === 0) {
      crosshair.setPointerCapture(event.pointerId);
      // Measured once a drag: it does not move under the hand, and measuring costs a layout.
      box = crosshair.getBoundingClientRect();
      place(event, true);
    }
  });
  crosshair.addEventListener("pointermove", (event) => {
    if (crosshair.hasPointerCapture(event.pointerId)) {
      place(event, true);
    }
  });
  crosshair.addEventListener("lostpointercapture", (event) => {
    onPlace({}, { dragging: false, inputTimeStamp: event.timeStamp });
  });
  crosshair.addEventListener("keydown", (event) => {
    const direction = DIRECTIONS[event.key];
    if (direction && shown && present) {
      event.preventDefault();
      const at = placeOnMap(shown.view, present);
      const step = event.shiftKey ? 10 * KEY_STEP : KEY_STEP;
      const next = collisionAt(
        shown.view,
        at.x + step * direction.right,
        at.y + step * direction.up,
        present.mu_over_alpha,
      );
      // The other of the two stays to the last digit.
      const moved = direction.right ? { kappa: next.kappa } : { gt_over_gn: next.gt_over_gn };
      onPlace(moved, { dragging: true, inputTimeStamp: event.timeStamp });
      isMoving = true;
    }
  });
  for (const kind of ["keyup", "blur"]) {
    crosshair.addEventListener(kind, (event) => {
      if (isMoving) {
        isMoving = false;
        onPlace({}, { dragging: false, inputTimeStamp: event.timeStamp });
        describeCrosshair();
      }
    });
  }
  crosshair.addEventListener("focus", describeCrosshair);
  element.addEventListener("change", (event) => {
    const input = /** @type {HTMLInputElement} */ (event.target);
    const isOn = input.type !== "checkbox" || input.checked;
    onOption({ [input.name]: isOn ? input.value : "flat" });
  });

  /** In words, but not at every step of a drag. */
  function describeCrosshair() {
    if (present) {
      const { kappa, gt_over_gn: ratio } = present;
      crosshair.setAttribute(
        "aria-label",
        `κ ${typable(kappa)}, g_t/g_n ${typable(ratio)}. Arrow keys move it, with Shift in large steps.`,
      );
    }
  }

  function drawLegend() {
    if (shown) {
      legend.draw(shown.quantity, mostSwitches(shown.grid));
    }
  }
  const endThemeChanges = onThemeChange(drawLegend);

  function moveCrosshair() {
    if (shown && present) {
      const { x, y, outside } = placeOnMap(shown.view, present);
      crosshair.style.setProperty("--x", String(x));
      crosshair.style.setProperty("--y", String(1 - y));
      crosshair.toggleAttribute("data-placed", true);
      beyond.hidden = !outside;
    }
  }

  return {
    legend,

    /**
     * @param {NonNullable<typeof shown>} map
     * @param {"flat" | "surface"} shape
     */
    show(map, shape) {
      shown = map;
      element.dataset.shape = shape;
      if (shape === "surface") {
        surface.show(map);
      } else {
        surface.close();
        plot.show(map);
      }
      drawLegend();
      moveCrosshair();
      describeCrosshair();
      plotElement.setAttribute(
        "aria-label",
        `${map.quantity === "switches" ? "Number of switches" : "Coefficient of tangential restitution ε_t"} over κ from ${typable(map.view.kappa.min)} to ${typable(map.view.kappa.max)} and ${map.view.vertical === "psi" ? "ψ" : "g_t/g_n"} from ${typable(map.view.gtOverGn.min)} to ${typable(map.view.gtOverGn.max)}; the crosshair marks the present collision.`,
      );
    },

    /** @param {import("../state/parameters.js").Collision} collision */
    point(collision) {
      present = collision;
      moveCrosshair();
    },

    /** @param {import("../state/url.js").PageState} state */
    options({ map, scale, map_x, map_y, shape }) {
      const options = { map, scale, map_x, map_y };
      const wanted = JSON.stringify([options, shape]);
      if (wanted === chosen) {
        return;
      }
      chosen = wanted;
      for (const [name, value] of Object.entries(options)) {
        const choice = find(`[name="${name}"][value="${value}"]`, element);
        /** @type {HTMLInputElement} */ (choice).checked = true;
      }
      const inDepth = /** @type {HTMLInputElement} */ (find(`[name="shape"]`, element));
      inDepth.checked = shape === "surface";
    },

    /**
     * What the server says of the present collision.
     * @param {import("../api/client.js").CollisionAnswer} result
     * @param {boolean} dragging
     */
    settle(result, dragging) {
      legend.point(result);
      if (!dragging) {
        surface.point(result);
      }
    },

    unmount() {
      endThemeChanges();
      surface.close();
      plot.destroy();
    },
  };
}
