// @ts-check

/**
 * Whether the server answers. Once it is reported lost it is asked again and again, more and more
 * seldom, until it answers.
 *
 * @param {object} options
 * @param {() => Promise<boolean>} options.isAnswering
 * @param {(reason: string) => void} options.onLost
 * @param {() => void} options.onRecovered
 * @param {number} [options.interval] in ms, the first; it grows to eight times that
 */
export function createConnection({ isAnswering, onLost, onRecovered, interval = 500 }) {
  let lost = false;

  /** @param {number} wait */
  function askAfter(wait) {
    setTimeout(async () => {
      if (await isAnswering()) {
        lost = false;
        onRecovered();
      } else {
        askAfter(Math.min(1.5 * wait, 8 * interval));
      }
    }, wait);
  }

  return {
    isLost: () => lost,

    /** @param {string} reason */
    reportLost(reason) {
      if (!lost) {
        lost = true;
        onLost(reason);
        askAfter(interval);
      }
    },
  };
}
