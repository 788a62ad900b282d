// @ts-check

import { MAP_MARGIN } from "../../figures/plot-area.js";
import { say } from "../../format/words.js";
import { axesInWords, collisionAt, placeOnMap } from "../../state/map-view.js";
import { followDrag } from "../drag.js";
import { find } from "../find.js";
import { createMark } from "./mark.js";
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
 * What the axes of a map mean.
 * @template View, Subject
 * @typedef {object} Axes
 * @property {(view: View, subject: Subject) => import("../../state/scales.js").Place} place of what is present
 * @property {(view: View, x: number, y: number, subject: Subject) => Record<string, number>} at what a place stands for
 * @property {string} horizontal what of that belongs to the horizontal axis
 * @property {string} vertical
 * @property {(view: View, subject: Subject) => {x: string, y: string}} words for what is present along each axis
 */

/** @type {Axes<import("../../state/map-view.js").MapView, import("../../state/parameters.js").Collision>} */
export const MAP_AXES = {
  place: placeOnMap,
  at: (view, x, y, { mu_over_alpha: mu }) => collisionAt(view, x, y, mu),
  horizontal: "kappa",
  vertical: "gt_over_gn",
  words: axesInWords,
};

/**
 * The crosshair of a map, laid over the plot so that moving it draws nothing anew: by pointer, or by
 * the arrow keys.
 * @template View, Subject
 * @param {HTMLElement} element
 * @param {Axes<View, Subject>} axes
 * @param {(place: Record<string, number>, change: import("../../state/store.js").Change) => void} onPlace
 */
export function mountCrosshair(element, axes, onPlace) {
  const template = /** @type {HTMLTemplateElement} */ (find("#crosshair"));
  element.append(template.content.cloneNode(true));
  element.tabIndex = 0;
  element.setAttribute("role", "application");
  element.setAttribute("aria-roledescription", say("crosshair.role"));
  const mark = createMark(element);
  layOver(element, MAP_MARGIN);
  /** @type {View | null} */
  let view = null;
  /** @type {Subject | null} */
  let present = null;
  let isMoving = false;

  followDrag(element, {
    mark: () => (view && present ? axes.place(view, present) : {}),
    onMove(x, y, change) {
      if (view && present) {
        onPlace(axes.at(view, x, y, present), change);
      }
    },
    onEnd: (change) => onPlace({}, change),
  });
  element.addEventListener("keydown", (event) => {
    const direction = DIRECTIONS[event.key];
    if (direction && view && present) {
      event.preventDefault();
      const at = axes.place(view, present);
      const step = event.shiftKey ? 10 * KEY_STEP : KEY_STEP;
      const { right, up } = direction;
      const next = axes.at(view, at.x + step * right, at.y + step * up, present);
      // The other of the two stays to the last digit.
      const moving = right ? axes.horizontal : axes.vertical;
      const moved = { [moving]: next[moving] };
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
    if (view && present) {
      const { x, y } = axes.words(view, present);
      element.setAttribute("aria-label", say("crosshair.keys", { x, y }));
    }
  }

  function move() {
    if (view && present) {
      mark.show(axes.place(view, present), axes.words(view, present));
    }
  }

  return {
    /** The axes of the map below it. @param {View} next */
    lieOn(next) {
      view = next;
      move();
      describe();
    },

    /** What is present. @param {Subject} subject */
    point(subject) {
      present = subject;
      move();
    },
  };
}
