// @ts-check

import { MAP_MARGIN } from "../figures/plot-area.js";
import { typable } from "../format/number.js";
import { collisionAt, placeOnMap } from "../state/map-view.js";
import { find } from "./find.js";
import { layOver } from "./overlay.js";

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
 * The crosshair of a map, laid over the plot so that moving it draws nothing anew: by pointer, or by
 * the arrow keys.
 * @param {HTMLElement} element
 * @param {(place: {kappa?: number, gt_over_gn?: number}, change: {dragging: boolean, inputTimeStamp: number}) => void} onPlace
 */
export function mountCrosshair(element, onPlace) {
  const beyond = find(".beyond", element);
  layOver(element, MAP_MARGIN);
  /** @type {import("../state/map-view.js").MapView | null} */
  let view = null;
  /** @type {import("../state/parameters.js").Collision | null} */
  let present = null;
  /** @type {DOMRect | null} */
  let box = null;
  let isMoving = false;

  /** @param {PointerEvent} event */
  function place(event) {
    if (view && box && present) {
      const x = (event.clientX - box.left) / box.width;
      const y = (box.bottom - event.clientY) / box.height;
      const there = collisionAt(view, x, y, present.mu_over_alpha);
      onPlace(there, { dragging: true, inputTimeStamp: event.timeStamp });
    }
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button === 0) {
      element.setPointerCapture(event.pointerId);
      // Measured once a drag: it does not move under the hand, and measuring costs a layout.
      box = element.getBoundingClientRect();
      place(event);
    }
  });
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) {
      place(event);
    }
  });
  element.addEventListener("lostpointercapture", (event) => {
    onPlace({}, { dragging: false, inputTimeStamp: event.timeStamp });
  });
  element.addEventListener("keydown", (event) => {
    const direction = DIRECTIONS[event.key];
    if (direction && view && present) {
      event.preventDefault();
      const at = placeOnMap(view, present);
      const step = event.shiftKey ? 10 * KEY_STEP : KEY_STEP;
      const next = collisionAt(
        view,
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
    element.addEventListener(kind, (event) => {
      if (isMoving) {
        isMoving = false;
        onPlace({}, { dragging: false, inputTimeStamp: event.timeStamp });
        describe();
      }
    });
  }
  element.addEventListener("focus", describe);

  /** In words, but not at every step of a drag. */
  function describe() {
    if (present) {
      const { kappa, gt_over_gn: ratio } = present;
      element.setAttribute(
        "aria-label",
        `κ ${typable(kappa)}, g_t/g_n ${typable(ratio)}. Arrow keys move it, with Shift in large steps.`,
      );
    }
  }

  function move() {
    if (view && present) {
      const { x, y, outside } = placeOnMap(view, present);
      element.style.setProperty("--x", String(x));
      element.style.setProperty("--y", String(1 - y));
      element.toggleAttribute("data-placed", true);
      beyond.hidden = !outside;
    }
  }

  return {
    /** The axes of the map below it. @param {NonNullable<typeof view>} next */
    lieOn(next) {
      view = next;
      move();
      describe();
    },

    /** @param {import("../state/parameters.js").Collision} collision */
    point(collision) {
      present = collision;
      move();
    },
  };
}
