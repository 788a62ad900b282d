// @ts-check

/**
 * A loader with one request under way, after which the newest wish comes next and all between are
 * forgotten. What is under way is let finish, for an answer a moment old is still a picture to see
 * while dragging; only when it takes longer than `patience` is it given up for a newer wish.
 *
 * @template Wish, Answer
 * @param {object} options
 * @param {(wish: Wish, signal: AbortSignal) => Promise<Answer>} options.load
 * @param {(answer: Answer, wish: Wish) => void} options.onAnswer
 * @param {(error: unknown, wish: Wish) => void} options.onError
 * @param {number} [options.patience] in ms
 * @param {(took: number, wish: Wish) => number} [options.pause] from the start of what is over to that of the next
 *   at least, by what it took, in ms
 * @param {(wish: Wish) => boolean} [options.isUrgent] whether what is under way is given up for it, unless that is urgent, too
 */
export function createLatest({
  load,
  onAnswer,
  onError,
  patience = 2000,
  pause = () => 0,
  isUrgent = () => false,
}) {
  /** @type {{controller: AbortController, startedAt: number, isUrgent: boolean} | null} */
  let underWay = null;
  /** @type {{wish: Wish} | null} */
  let next = null;
  let earliest = 0;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  /** @param {Wish} wish */
  async function start(wish) {
    const mine = {
      controller: new AbortController(),
      startedAt: performance.now(),
      isUrgent: isUrgent(wish),
    };
    underWay = mine;
    try {
      const answer = await load(wish, mine.controller.signal);
      if (underWay === mine) {
        onAnswer(answer, wish);
      }
    } catch (error) {
      if (underWay === mine) {
        onError(error, wish);
      }
    } finally {
      if (underWay === mine) {
        underWay = null;
        earliest = mine.startedAt + pause(performance.now() - mine.startedAt, wish);
        startNext();
      }
    }
  }

  function startNext() {
    clearTimeout(timer);
    if (!next || underWay) {
      return;
    }
    const wait = earliest - performance.now();
    if (wait > 0) {
      timer = setTimeout(startNext, wait);
    } else {
      const { wish } = next;
      next = null;
      start(wish);
    }
  }

  return {
    /** @param {Wish} wish */
    request(wish) {
      next = { wish };
      const isOvertaken = underWay && !underWay.isUrgent && isUrgent(wish);
      if (underWay && (isOvertaken || performance.now() - underWay.startedAt > patience)) {
        underWay.controller.abort();
        underWay = null;
      }
      startNext();
    },
  };
}
