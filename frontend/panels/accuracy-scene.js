// @ts-check

import { accuracyQuery, failingOf, inSteps } from "../state/accuracy.js";
import { createErrorMapLoader } from "../state/error-map-loader.js";
import { createLatest } from "../state/latest.js";
import { sameCollision } from "../state/parameters.js";
import { mountCalculator } from "./calculator.js";
import { mountErrorMap } from "./error-map.js";
import { find } from "./find.js";
import { mountRemeasure } from "./remeasure.js";
import { mountStepOverlay } from "./step-overlay.js";
import { mountTradeoff } from "./tradeoff.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../api/answers.js").Trace} Trace
 * @typedef {import("../api/answers.js").Tradeoff} Tradeoff
 * @typedef {import("../api/answers.js").StepsAnswer} StepsAnswer
 * @typedef {import("../api/answers.js").Stepped} Stepped
 * @typedef {import("../api/answers.js").Run} Run
 * @typedef {import("../state/error-map-loader.js").ErrorMapWish} ErrorMapWish
 */

/** After so many ms without a further change the calculator is asked. */
const CALCULATOR_PAUSE = 250;

/**
 * The scene "Speed and accuracy": error against time of every method, where on the map the chosen one
 * fails, its steps over the exact force, and how many steps an error takes.
 * @param {object} handlers
 * @param {object} handlers.load each from the server
 * @param {(region: string, signal: AbortSignal) => Promise<Tradeoff>} handlers.load.tradeoff
 * @param {(wish: ErrorMapWish, signal: AbortSignal) => Promise<Float64Array[]>} handlers.load.errorMap
 * @param {(collision: import("../state/parameters.js").Collision, accuracy: Record<string, string>, signal: AbortSignal) => Promise<Stepped>} handlers.load.stepped
 * @param {(where: import("../state/parameters.js").Collision | string, error: string, signal: AbortSignal) => Promise<StepsAnswer>} handlers.load.steps of a collision or a region
 * @param {(region: string) => Promise<Run>} handlers.load.startRun
 * @param {(id: string) => Promise<Run>} handlers.load.run
 * @param {(id: string) => Promise<Run>} handlers.load.cancelRun
 * @param {(error: unknown) => void} handlers.onError
 * @param {(patch: Partial<PageState>) => void} handlers.onOption
 * @param {(patch: Partial<import("../state/accuracy.js").Accuracy>) => void} handlers.onAccuracy
 * @param {Parameters<typeof mountErrorMap>[1]} handlers.onPlace
 */
export function mountAccuracyScene({ load, onError, onOption, onAccuracy, onPlace }) {
  const tradeoffPanel = mountTradeoff(find(".tradeoff"), { onOption, onAccuracy });
  const errorMap = mountErrorMap(find(".error-map"), onPlace);
  const overlay = mountStepOverlay(find(".overlay"), onAccuracy);
  const calculator = mountCalculator(find(".calculator"), onOption);
  const remeasure = mountRemeasure(find(".remeasure"), {
    start: load.startRun,
    look: load.run,
    cancel: load.cancelRun,
    onResult(result) {
      if (result.scene === present?.region) {
        tradeoff = { ...result, can_be_measured_anew: true };
        drawTradeoff();
      }
    },
    onError,
  });
  /** @type {PageState | null} */
  let present = null;
  /** @type {Trace | null} */
  let trace = null;
  /** @type {Tradeoff | null} */
  let tradeoff = null;
  /** @type {{errors: Float64Array[], wish: ErrorMapWish} | null} */
  let errors = null;
  /** @type {{answer: Stepped, collision: import("../state/parameters.js").Collision} | null} */
  let stepped = null;
  const asked = { region: "", steps: "", overlay: "" };
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;

  const tradeoffs = createLatest({
    load: load.tradeoff,
    onAnswer(answer) {
      tradeoff = answer;
      drawTradeoff();
    },
    onError,
  });
  const errorMaps = createErrorMapLoader({
    load: load.errorMap,
    onErrors(answer, wish) {
      errors = { errors: answer, wish };
      drawErrorMap();
    },
    onNothing() {
      errors = null;
      errorMap.withhold("This method does not answer everywhere on these axes");
    },
    onError,
  });
  const overlays = createLatest({
    load: (/** @type {PageState} */ { collision, accuracy }, signal) =>
      load.stepped(collision, accuracyQuery(inSteps(accuracy)), signal),
    onAnswer(answer, { collision }) {
      stepped = { answer, collision };
      drawOverlay();
    },
    onError,
  });
  const calculations = createLatest({
    async load(/** @type {PageState} */ { collision, region, wanted_error: error }, signal) {
      const [here, there] = await Promise.all([
        load.steps(collision, error, signal),
        load.steps(region, error, signal),
      ]);
      return { here, there };
    },
    onAnswer: (answers, { region }) => calculator.show({ ...answers, region }),
    onError,
  });

  function drawTradeoff() {
    if (tradeoff && present) {
      tradeoffPanel.show(tradeoff, present);
      remeasure.offer(tradeoff.scene, tradeoff.can_be_measured_anew);
    }
  }

  function drawErrorMap() {
    if (errors && present) {
      errorMap.show(errors.errors, errors.wish.view, present);
    }
  }

  /** Once the exact force and the steps of one collision are here, whichever comes last. */
  function drawOverlay() {
    if (trace && stepped && sameCollision(trace.parameters, stepped.collision)) {
      overlay.show(trace, stepped.answer);
    }
  }

  /** @param {PageState} state */
  function followOverlay(state) {
    if (!trace) {
      overlay.withhold("No picture of this one");
      return;
    }
    const wish = JSON.stringify([state.collision, accuracyQuery(inSteps(state.accuracy))]);
    if (asked.overlay !== wish) {
      asked.overlay = wish;
      overlays.request(state);
    }
  }

  /** @param {PageState} state */
  function followCalculator(state) {
    const wish = JSON.stringify([state.collision, state.region, state.wanted_error]);
    if (asked.steps !== wish) {
      asked.steps = wish;
      clearTimeout(pause);
      pause = setTimeout(() => calculations.request(state), CALCULATOR_PAUSE);
    }
  }

  return {
    /** What each panel shows, for its menu. */
    shown: () => ({ tradeoff, errors, stepped: overlay.shown() }),

    /**
     * What the present state wants to see; what takes longer only when nothing is dragged.
     * @param {PageState} state
     * @param {boolean} dragging
     */
    follow(state, dragging) {
      const before = present;
      present = state;
      if (state.scene !== "accuracy") {
        return;
      }
      tradeoffPanel.options(state);
      calculator.options(state);
      errorMap.name(failingOf(state.accuracy));
      overlay.options(state.accuracy);
      errorMap.point(state.collision);
      if (asked.region !== state.region) {
        asked.region = state.region;
        tradeoffs.request(state.region);
      } else if (before?.statistic !== state.statistic || before.accuracy !== state.accuracy) {
        drawTradeoff();
      }
      if (before?.map_x !== state.map_x || before.alpha !== state.alpha) {
        drawErrorMap();
      }
      errorMaps.follow(state, dragging);
      followOverlay(state);
      if (!dragging) {
        followCalculator(state);
      }
    },

    /** The exact collision, to lie under the steps. @param {Trace | null} next */
    settle(next) {
      trace = next;
      if (present?.scene === "accuracy") {
        followOverlay(present);
        drawOverlay();
      }
    },

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      Object.assign(asked, { region: "", steps: "", overlay: "" });
      errorMaps.forget();
    },

    unmount() {
      clearTimeout(pause);
      remeasure.unmount();
      tradeoffPanel.unmount();
      errorMap.unmount();
      overlay.unmount();
    },
  };
}
