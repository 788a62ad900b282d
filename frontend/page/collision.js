// @ts-check

import { collisionQuery } from "../api/queries.js";
import { say } from "../format/words.js";
import { accuracyOf, sameAccuracy } from "../state/accuracy.js";
import { scaleFor } from "../state/map-view.js";
import { INITIAL_COLLISION, PARAMETERS } from "../state/parameters.js";
import { offered } from "../state/scenes.js";
import { stateAt } from "../state/address/writing.js";
import { byTestId, find } from "../widgets/find.js";
import { mountParameterControl } from "../widgets/parameter-control.js";
import { mountAccuracyControl } from "./accuracy-control.js";
import { mountPresets } from "./presets.js";
import { mountResultStrip, resultTable } from "./result-strip.js";

/**
 * What the scenes share: the collision, to be set by its parameters or a preset, and its result.
 * @param {Pick<import("../scenes/scene.js").Page, "present" | "set" | "setCollision" | "setAccuracy">} page
 * @param {string} alone the key of what is said where a method would need the server that is not there
 */
export function mountCollision({ present, set, setCollision, setAccuracy }, alone) {
  const strip = mountResultStrip(byTestId("result"));
  const accuracyControl = mountAccuracyControl(byTestId("accuracy"), setAccuracy);
  const presets = mountPresets(byTestId("presets"), ({ link, alpha }, inputTimeStamp) => {
    const state = stateAt(present(), link);
    set({ ...state, alpha, scale: scaleFor(state.collision, state) }, { inputTimeStamp });
  });
  const controls = PARAMETERS.map((parameter) => ({
    ...parameter,
    ...mountParameterControl(find(".controls"), parameter, (value, change) =>
      setCollision({ [parameter.key]: value ?? parameter.initial }, change),
    ),
  }));
  const start = present();
  /** What is reset goes back to: in the frame of an author, to what that begins with. */
  const home = offered(start) ? start.collision : INITIAL_COLLISION;
  /** @type {import("../state/loading/collision-load.js").LoadedCollision | null} */
  let loaded = null;

  return {
    preview: strip.preview,
    offer: presets.offer,

    /**
     * @param {import("../state/address/options.js").PageState} state
     * @param {import("../state/address/options.js").PageState | null} previous
     */
    show(state, previous) {
      const accuracy = accuracyOf(state);
      if (previous && !sameAccuracy(accuracy, accuracyOf(previous))) {
        strip.preview(null);
      }
      accuracyControl.show(accuracy);
      for (const { key, show } of controls) {
        show(state.collision[key], home[key]);
      }
      presets.show(state);
    },

    /** @type {NonNullable<import("../scenes/scene.js").Scene["settle"]>} */
    settle(answer, { accuracy, change }, isPresent) {
      loaded = answer;
      strip.show(answer, change.dragging, isPresent);
      const refusal = answer.isAlone ? alone : `accuracy.refusals.${accuracy.method}`;
      accuracyControl.tell(answer.isOffered ? "" : refusal);
    },

    /** @type {import("../scenes/scene.js").Scene["pictures"]} */
    pictures: {
      result: {
        title: say("result.title"),
        request: () => ({ call: "collision", query: collisionQuery(present().collision) }),
        parameters: () => ({ ...present().collision }),
        table: () => loaded && resultTable(loaded),
      },
    },
  };
}
