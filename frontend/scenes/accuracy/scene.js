// @ts-check

import { errorMapQuery, steppedQuery, stepsQuery } from "../../api/queries.js";
import { say } from "../../format/words.js";
import { accuracyQuery, failingOf, inSteps, METHODS, titleOf } from "../../state/accuracy.js";
import { createFollower, isSame } from "../../state/loading/follower.js";
import { showsSteps } from "../../state/lesson.js";
import { axesFor, rowsOf } from "../../state/map-view.js";
import { sameCollision } from "../../state/parameters.js";
import { REGIONS } from "../../state/tradeoff-options.js";
import { find } from "../../widgets/find.js";
import { afterNextFrame } from "../../widgets/painted.js";
import { mountCalculator } from "./calculator.js";
import { mountCodesPanel } from "./codes-panel.js";
import { errorMapWish, FULL_ERROR_MAP, isEnoughErrorMap } from "./error-map-wish.js";
import { mountErrorMap } from "./error-map.js";
import { mountRemeasure } from "./remeasure.js";
import { mountStepOverlay } from "./step-overlay.js";
import { codesTable, errorTable, steppedTable, tradeoffTable } from "./tables.js";
import { mountTradeoff } from "./tradeoff.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/parameters.js").Collision} Collision
 * @typedef {import("../../api/answers.js").Trace} Trace
 * @typedef {import("../../api/answers.js").Tradeoff} Tradeoff
 * @typedef {import("../../api/answers.js").Stepped} Stepped
 * @typedef {{collision: Collision, accuracy: Record<string, string>}} SteppedWish
 * @typedef {{collision: Collision, region: string, error: string}} StepsWish
 */

/** At most so often a map is asked for, in ms. */
const MAP_PAUSE = 80;

/** After so many ms without a further change the calculator is asked. */
const CALCULATOR_PAUSE = 250;

/** What changes the look of a picture, but not what is asked for. */
const LOOKS = {
  tradeoff: /** @type {(keyof PageState)[]} */ (["scene", "statistic", "accuracy"]),
  errorMap: /** @type {(keyof PageState)[]} */ (["scene", "map_x", "alpha"]),
};

/**
 * The scene "Speed and accuracy": error against time of every method, where on the map the chosen one
 * fails, its steps over the exact force, and how many steps an error takes.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountAccuracy(page) {
  const { client, present, set, setCollision, setAccuracy, explain } = page;
  const tradeoffPanel = mountTradeoff(find(".tradeoff"), {
    onOption: set,
    onAccuracy: setAccuracy,
  });
  const errorMap = mountErrorMap(find(".error-map"), setCollision);
  const overlay = mountStepOverlay(find(".overlay"), setAccuracy);
  const calculator = mountCalculator(find(".calculator"), set);
  const codes = mountCodesPanel(find(".codes"), page);
  const remeasure = mountRemeasure(find(".remeasure"), {
    start: client.startRun,
    look: client.run,
    cancel: client.cancelRun,
    onResult(result) {
      if (result.scene === present().region) {
        tradeoff = { ...result, can_be_measured_anew: true };
        drawTradeoff();
      }
    },
    onError: explain,
  });
  /** @type {Trace | null} */
  let trace = null;
  /** @type {Tradeoff | null} */
  let tradeoff = null;
  /** @type {{errors: Float64Array[], wish: import("../../api/queries.js").ErrorMapWish} | null} */
  let errors = null;
  /** @type {{answer: Stepped, collision: Collision} | null} */
  let stepped = null;
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let pause;

  const tradeoffs = createFollower({
    load: client.tradeoff,
    isEnough: isSame,
    onAnswer(answer) {
      tradeoff = answer;
      drawTradeoff();
    },
    onError: explain,
  });
  const errorMaps = createFollower({
    load: client.errorMap,
    isEnough: isEnoughErrorMap,
    onAnswer(answer, wish) {
      errors = { errors: answer, wish };
      drawErrorMap();
    },
    onNothing() {
      errors = null;
      errorMap.showReason(say("errorMap.nowhere"));
    },
    onError: explain,
    pause: () => MAP_PAUSE,
  });
  const overlays = createFollower({
    load: (/** @type {SteppedWish} */ { collision, accuracy }, signal) =>
      client.stepped(collision, accuracy, signal),
    isEnough: isSame,
    onAnswer(answer, { collision }) {
      stepped = { answer, collision };
      drawOverlay();
    },
    onError: explain,
  });
  const calculations = createFollower({
    async load(/** @type {StepsWish} */ { collision, region, error }, signal) {
      const [here, there] = await Promise.all([
        client.steps(collision, error, signal),
        client.steps(region, error, signal),
      ]);
      return { here, there };
    },
    isEnough: isSame,
    onAnswer(answers, { region, error }) {
      calculator.show({ ...answers, region });
      codes.settleSteps({ needed: answers.here, error });
    },
    onError: explain,
  });

  function drawTradeoff() {
    if (tradeoff) {
      tradeoffPanel.show(tradeoff, present());
      remeasure.offer(tradeoff.scene, tradeoff.can_be_measured_anew);
    }
  }

  function drawErrorMap() {
    if (errors) {
      errorMap.show(errors.errors, errors.wish.view, present());
    }
  }

  /** Once the exact force and the steps of one collision are here, whichever comes last. */
  function drawOverlay() {
    const isShown = showsSteps(present());
    if (isShown && trace && stepped && sameCollision(trace.parameters, stepped.collision)) {
      overlay.show(trace, stepped.answer);
    }
  }

  /** @param {PageState} state */
  function followOverlay({ collision, accuracy, ...state }) {
    if (!showsSteps(state)) {
      return;
    }
    if (trace) {
      overlays.follow({ collision, accuracy: accuracyQuery(inSteps(accuracy)) });
    } else {
      overlay.showReason(say("trace.none"));
    }
  }

  /** @param {PageState} state */
  function followCalculator({ collision, region, wanted_error: error }) {
    clearTimeout(pause);
    pause = setTimeout(() => calculations.follow({ collision, region, error }), CALCULATOR_PAUSE);
  }

  const parameters = () => ({ ...present().collision });

  return {
    show(state, previous) {
      if (showsSteps(state)) {
        overlay.options(state.accuracy);
      }
      if (state.scene !== "accuracy") {
        return;
      }
      tradeoffPanel.options(state);
      calculator.options(state);
      errorMap.name(failingOf(state.accuracy));
      errorMap.point(state.collision);
      if (previous && LOOKS.tradeoff.some((key) => previous[key] !== state[key])) {
        drawTradeoff();
      }
      if (previous && LOOKS.errorMap.some((key) => previous[key] !== state[key])) {
        drawErrorMap();
      }
    },

    follow(state, previous, { dragging }) {
      if (!dragging) {
        followOverlay(state);
      }
      if (state.scene !== "accuracy" || dragging) {
        return;
      }
      tradeoffs.follow(state.region);
      errorMaps.follow(errorMapWish(state, false, errorMaps.asked()));
      followCalculator(state);
      codes.follow(state);
    },

    /** The exact force lies under the steps; while dragging, the pictures come after it. */
    settle(answer, { change }) {
      trace = answer.trace;
      afterNextFrame(() => {
        const state = present();
        followOverlay(state);
        drawOverlay();
        if (state.scene === "accuracy" && change.dragging) {
          errorMaps.follow(errorMapWish(state, true, errorMaps.asked()));
        }
      });
    },

    forget() {
      for (const follower of [tradeoffs, errorMaps, overlays, calculations, codes]) {
        follower.forget();
      }
    },

    pictures: {
      tradeoff: {
        title: say("tradeoff.title"),
        subject: () => present().region,
        subjectTitle: () => titleOf(REGIONS, present().region),
        request: () => ({ call: "tradeoff", query: { scene: present().region } }),
        parameters: () => ({}),
        table: () => tradeoff && tradeoffTable(tradeoff),
      },
      error_map: {
        title: say("errorMap.picture"),
        subject: () => failingOf(present().accuracy).method,
        subjectTitle: () => titleOf(METHODS, failingOf(present().accuracy).method),
        request() {
          const state = present();
          const wish = errors?.wish ?? {
            ...axesFor(state, false),
            counts: FULL_ERROR_MAP,
            accuracy: accuracyQuery(failingOf(state.accuracy)),
          };
          return { call: "map", query: errorMapQuery(wish) };
        },
        parameters,
        table() {
          const { collision } = present();
          return (
            errors &&
            errorTable(
              errors.errors,
              errors.wish.view,
              rowsOf(errors.wish.view, collision),
              collision,
            )
          );
        },
      },
      overlay: {
        title: say("overlay.picture"),
        request() {
          const { collision, accuracy } = present();
          return {
            call: "trace",
            query: steppedQuery(collision, accuracyQuery(inSteps(accuracy))),
          };
        },
        parameters,
        table() {
          const shown = overlay.shown();
          return shown && steppedTable(shown);
        },
      },
      steps: {
        title: say("steps.picture"),
        request() {
          const { collision, wanted_error: error } = present();
          return { call: "steps", query: stepsQuery(collision, error) };
        },
        parameters,
      },
      codes: {
        title: say("codes.picture"),
        request: () => ({ call: "codes", query: {}, body: codes.asked() }),
        parameters,
        table() {
          const answer = codes.shown();
          return answer && codesTable(answer);
        },
      },
    },
  };
}
