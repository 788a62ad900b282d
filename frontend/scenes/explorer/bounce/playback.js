// @ts-check

/**
 * A share of the whole that runs from 0 to 1, or is put where one wants it.
 * @param {object} options
 * @param {(share: number) => void} options.onShare
 * @param {(isPlaying: boolean) => void} options.onPlaying
 * @param {(task: (now: number) => void) => unknown} options.nextFrame
 * @param {() => number} options.duration of the whole at full speed, in ms
 * @param {number} options.initial where it rests before it has been played
 */
export function createPlayback({ onShare, onPlaying, nextFrame, duration, initial }) {
  let share = initial;
  let speed = 1;
  /** @type {symbol | null} of the run under way */
  let run = null;

  /** @param {number} next */
  function put(next) {
    share = Math.min(1, Math.max(0, next));
    onShare(share);
  }

  function pause() {
    if (run) {
      run = null;
      onPlaying(false);
    }
  }

  return {
    share: () => share,
    isPlaying: () => run !== null,
    pause,

    /** From where it is, or from the beginning when it is at the end. */
    play() {
      const mine = Symbol("run");
      /** @type {number | null} */
      let before = null;
      run = mine;
      onPlaying(true);
      put(share >= 1 ? 0 : share);
      nextFrame(function step(now) {
        if (run !== mine) {
          return;
        }
        put(share + (speed * (now - (before ?? now))) / duration());
        before = now;
        if (share < 1) {
          nextFrame(step);
        } else {
          pause();
        }
      });
    },

    /** @param {number} next */
    seek(next) {
      pause();
      put(next);
    },

    /** @param {number} next shares of the full speed */
    setSpeed(next) {
      speed = next;
    },
  };
}
