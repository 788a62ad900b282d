// @ts-check

/** @typedef {import("../state/store.js").Change} Change */

/**
 * Follows a pointer that is pressed on an element until it is let go.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(x: number, y: number, change: Change) => void} handlers.onMove told the place as shares of the element, from the left and from the bottom
 * @param {(change: Change) => void} handlers.onEnd
 */
export function followDrag(element, { onMove, onEnd }) {
  /** @type {DOMRect | null} */
  let box = null;

  /** @param {PointerEvent} event */
  function move({ clientX, clientY, timeStamp: inputTimeStamp }) {
    if (box) {
      const x = (clientX - box.left) / box.width;
      const y = (box.bottom - clientY) / box.height;
      onMove(x, y, { dragging: true, inputTimeStamp });
    }
  }

  element.addEventListener("pointerdown", (event) => {
    if (event.button === 0) {
      element.setPointerCapture(event.pointerId);
      // Measured once a drag: it does not move under the hand, and measuring costs a layout.
      box = element.getBoundingClientRect();
      move(event);
    }
  });
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) {
      move(event);
    }
  });
  element.addEventListener("lostpointercapture", ({ timeStamp: inputTimeStamp }) => {
    onEnd({ dragging: false, inputTimeStamp });
  });
}
