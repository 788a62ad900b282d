// @ts-check

/** @type {(() => void)[]} */
const waiting = [];
const channel = new MessageChannel();
channel.port1.onmessage = () => waiting.shift()?.();

/**
 * Runs a task once the frame that shows what has just changed is on its way.
 * @param {() => void} task
 */
export function afterNextFrame(task) {
  requestAnimationFrame(() => {
    waiting.push(task);
    channel.port2.postMessage(null);
  });
}

/**
 * Tells those who measure that a view now shows the answer to an input.
 * @param {string} view
 * @param {number} inputTimeStamp
 */
export function announcePainted(view, inputTimeStamp) {
  const detail = { view, inputTimeStamp, paintedAt: performance.now() };
  window.dispatchEvent(new CustomEvent("restitution:painted", { detail }));
}
