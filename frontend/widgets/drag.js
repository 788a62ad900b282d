// @ts-check

/** @typedef {import("../state/store.js").Change} Change */

/** So long, in ms, a finger rests on a picture before it takes hold of it: until then it scrolls, or taps. */
const HOLD = 300;
/** Within so many pixels a finger rests. */
const STILL = 10;
/** So many pixels from the mark a finger is on it. */
const REACH = 24;

/**
 * Follows a pointer that is pressed on an element until it is let go. A finger scrolls the page, unless
 * it lies on the mark or has rested; where it taps, the mark comes.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {() => {x?: number, y?: number}} handlers.mark where it is along the axes that it has one on, as shares of the element
 * @param {(x: number, y: number, change: Change) => void} handlers.onMove told the place as shares of the element, from the left and from the bottom
 * @param {(change: Change) => void} handlers.onEnd
 */
export function followDrag(element, { mark, onMove, onEnd }) {
  /** @type {DOMRect | null} while it is held */
  let box = null;
  /** @type {{event: PointerEvent, timer: ReturnType<typeof setTimeout>} | null} a finger that may scroll */
  let resting = null;

  /** @param {PointerEvent} event */
  function move({ clientX, clientY, timeStamp: inputTimeStamp }) {
    if (box) {
      const x = (clientX - box.left) / box.width;
      const y = (box.bottom - clientY) / box.height;
      onMove(x, y, { dragging: true, inputTimeStamp });
    }
  }

  /** @param {PointerEvent} event */
  function take(event) {
    letRest();
    element.setPointerCapture(event.pointerId);
    element.toggleAttribute("data-held", true);
    // Measured once a drag: it does not move under the hand, and measuring costs a layout.
    box = element.getBoundingClientRect();
    move(event);
  }

  function letRest() {
    clearTimeout(resting?.timer);
    resting = null;
  }

  /** @param {number} inputTimeStamp */
  function end(inputTimeStamp) {
    letRest();
    if (box) {
      box = null;
      element.removeAttribute("data-held");
      onEnd({ dragging: false, inputTimeStamp });
    }
  }

  /** @param {PointerEvent} event */
  function isOnMark({ clientX, clientY }) {
    const { left, bottom, width, height } = element.getBoundingClientRect();
    const { x, y } = mark();
    return (
      (x === undefined || Math.abs(left + x * width - clientX) < REACH) &&
      (y === undefined || Math.abs(bottom - y * height - clientY) < REACH)
    );
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || !event.isPrimary) {
      return;
    }
    if (event.pointerType !== "touch" || isOnMark(event)) {
      take(event);
    } else {
      resting = { event, timer: setTimeout(() => take(event), HOLD) };
    }
  });
  element.addEventListener("pointermove", (event) => {
    if (box) {
      move(event);
    } else if (resting && distance(resting.event, event) > STILL) {
      letRest();
    }
  });
  element.addEventListener("pointerup", (event) => {
    if (resting) {
      take(event);
    }
    end(event.timeStamp);
  });
  for (const kind of ["pointercancel", "lostpointercapture"]) {
    element.addEventListener(kind, ({ timeStamp }) => end(timeStamp));
  }
  // Held, it neither scrolls nor opens what a long press opens.
  for (const kind of ["touchmove", "contextmenu"]) {
    element.addEventListener(
      kind,
      (event) => {
        if (box) {
          event.preventDefault();
        }
      },
      { passive: false },
    );
  }
}

/**
 * Lets a picture that takes every touch for a drag, as Plotly's surfaces do, have those of a finger
 * that has rested alone: another one scrolls.
 * @param {HTMLElement} element around the picture
 */
export function dragWhenHeld(element) {
  /** @type {Touch | null} */
  let resting = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  function end() {
    clearTimeout(timer);
    resting = null;
    element.removeAttribute("data-held");
  }

  element.addEventListener(
    "touchstart",
    ({ touches }) => {
      end();
      resting = touches[0];
      timer = setTimeout(() => element.toggleAttribute("data-held", true), HOLD);
    },
    { capture: true, passive: true },
  );
  element.addEventListener(
    "touchmove",
    (event) => {
      if (element.hasAttribute("data-held")) {
        return;
      }
      event.stopPropagation();
      if (resting && distance(resting, event.touches[0]) > STILL) {
        clearTimeout(timer);
      }
    },
    { capture: true, passive: true },
  );
  for (const kind of ["touchend", "touchcancel"]) {
    element.addEventListener(kind, end, { capture: true });
  }
}

/** @typedef {{clientX: number, clientY: number}} Place in the window */

/**
 * @param {Place} a
 * @param {Place} b
 */
function distance(a, b) {
  return Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
}
