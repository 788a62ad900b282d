// @ts-check

import { say } from "../../format/words.js";
import { byTestId, find } from "../../widgets/find.js";

/** @typedef {import("../../api/answers.js").Run} Run */

/** Between two looks at how far it is, in ms. */
const PAUSE = 400;

/**
 * Has the region shown measured anew, where the server allows it: with its progress, and a way to stop.
 * @param {HTMLElement} element
 * @param {object} handlers
 * @param {(region: string) => Promise<Run>} handlers.start
 * @param {(id: string) => Promise<Run>} handlers.look
 * @param {(id: string) => Promise<Run>} handlers.cancel
 * @param {(result: NonNullable<Run["result"]>) => void} handlers.onResult
 * @param {(error: unknown) => void} handlers.onError
 */
export function mountRemeasure(element, { start, look, cancel, onResult, onError }) {
  const button = /** @type {HTMLButtonElement} */ (byTestId("remeasure", element));
  const progress = /** @type {HTMLProgressElement} */ (find("progress", element));
  let region = "";
  /** @type {Run | null} */
  let run = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  button.addEventListener("click", async () => {
    try {
      show(run ? await cancel(run.id) : await start(region));
    } catch (error) {
      show(null);
      onError(error);
    }
  });

  /** @param {Run | null} next */
  function show(next) {
    clearTimeout(timer);
    run = next?.state === "running" ? next : null;
    button.textContent = say(run ? "tradeoff.stop" : "tradeoff.remeasure");
    progress.hidden = !run;
    progress.value = run?.progress ?? 0;
    if (run) {
      timer = setTimeout(lookAgain, PAUSE);
    } else if (next?.result) {
      onResult(next.result);
    }
  }

  async function lookAgain() {
    try {
      show(run && (await look(run.id)));
    } catch (error) {
      show(null);
      onError(error);
    }
  }

  return {
    /**
     * @param {string} shown the region
     * @param {boolean} isAllowed
     */
    offer(shown, isAllowed) {
      region = shown;
      element.hidden = !isAllowed;
    },
  };
}
