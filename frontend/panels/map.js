// @ts-check

import { mapFigure, mostSwitches } from "../figures/map-figure.js";
import { MAP_MARGIN } from "../figures/plot-area.js";
import { typable } from "../format/number.js";
import { collisionAt, placeOnMap } from "../state/map-view.js";
import { find } from "./find.js";
import { createMapLegend } from "./map-legend.js";
import { createPlot } from "./plot.js";
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
  const { l, r, t, b } = MAP_MARGIN;
  for (const [name, value] of Object.entries({ left: l, right: r, top: t, bottom: b })) {
    crosshair.style.setProperty(name, `${value / 16}rem`);
  }
  /** @type {Parameters<typeof mapFigure>[0] | null} */
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
    if (shown && box) {
      const x = (event.clientX - box.left) / box.width;
      const y = (box.bottom - event.clientY) / box.height;
      onPlace(collisionAt(shown.view, x, y), { dragging, inputTimeStamp: event.timeStamp });
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
    const { name, value } = /** @type {HTMLInputElement} */ (event.target);
    onOption({ [name]: value });
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
    /** @param {NonNullable<typeof shown>} map */
    show(map) {
      shown = map;
      plot.show(map);
      drawLegend();
      moveCrosshair();
      describeCrosshair();
      plotElement.setAttribute(
        "aria-label",
        `${map.quantity === "switches" ? "Number of switches" : "Coefficient of tangential restitution ε_t"} over κ from ${typable(map.view.kappa.min)} to ${typable(map.view.kappa.max)} and g_t/g_n from ${typable(map.view.gtOverGn.min)} to ${typable(map.view.gtOverGn.max)}; the crosshair marks the present collision.`,
      );
    },

    /** @param {import("../state/parameters.js").Collision} collision */
    point(collision) {
      present = collision;
      moveCrosshair();
    },

    /** @param {{map: string, scale: string}} options */
    options({ map, scale }) {
      if (`${map} ${scale}` === chosen) {
        return;
      }
      chosen = `${map} ${scale}`;
      for (const [name, value] of Object.entries({ map, scale })) {
        const choice = find(`[name="${name}"][value="${value}"]`, element);
        /** @type {HTMLInputElement} */ (choice).checked = true;
      }
    },

    legend,

    unmount() {
      endThemeChanges();
      plot.destroy();
    },
  };
}
