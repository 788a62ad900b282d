// @ts-check

import { createLatest } from "./latest.js";

/**
 * Asks for what a picture needs, unless that was asked for before. While one request is under way, the newest wish waits.
 *
 * @template Wish, Answer
 * @param {Parameters<typeof createLatest<Wish, Answer>>[0] & {isEnough: (asked: Wish, wish: Wish) => boolean, onNothing?: () => void}} options
 *   how to ask; whether what was asked for last does for a wish; and what to do where there is nothing to wish for
 */
export function createFollower({ isEnough, onNothing, ...loading }) {
  /** @type {Wish | null} */
  let asked = null;
  const latest = createLatest(loading);

  return {
    /** @param {Wish | null} wish */
    follow(wish) {
      if (wish === null) {
        asked = null;
        onNothing?.();
      } else if (asked === null || !isEnough(asked, wish)) {
        asked = wish;
        latest.request(wish);
      }
    },

    /** What was asked for last. */
    asked: () => asked,

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      asked = null;
    },
  };
}

/**
 * Whether two wishes are the same; both are plain data.
 * @param {unknown} asked
 * @param {unknown} wish
 */
export function isSame(asked, wish) {
  return JSON.stringify(asked) === JSON.stringify(wish);
}
