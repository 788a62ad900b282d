// @ts-check

import { textsOfMaterial } from "../../format/materials.js";
import { say } from "../../format/words.js";
import { createFollower, isSame } from "../../state/loading/follower.js";
import { contactBody, materialOf, valuesOf } from "../../state/impact.js";
import { PARAMETERS } from "../../state/parameters.js";
import { embedded } from "../../state/scenes.js";
import { byTestId, find } from "../../widgets/find.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/impact.js").Material} Material
 * @typedef {import("../../api/answers.js").CodesAnswer} CodesAnswer
 * @typedef {{body: Record<string, any>, material: Material}} CodesWish
 * @typedef {{needed: import("../../api/answers.js").StepsAnswer, error: string}} FoundSteps
 */

/**
 * What DEM codes take for the present collision; it is folded, and nothing is asked or loaded for it until
 * it is unfolded.
 * @param {HTMLElement} element
 * @param {Pick<import("../scene.js").Page, "client" | "present" | "explain" | "reportLost">} page
 */
export function mountCodesPanel(element, { client, present, explain, reportLost }) {
  const details = /** @type {HTMLDetailsElement} */ (find("details", element));
  /** @type {Promise<Material[]> | null} */
  let materials = null;
  /** @type {{answer: CodesAnswer, wish: CodesWish} | null} */
  let shown = null;
  /** How many steps the collision takes. @type {FoundSteps | null} */
  let steps = null;

  const codes = createFollower({
    load: (/** @type {CodesWish} */ { body }, signal) => client.codes(body, signal),
    isEnough: isSame,
    onAnswer(answer, wish) {
      shown = { answer, wish };
      draw();
    },
    onError: explain,
  });

  async function draw() {
    const module = await import("./codes.js").catch(() => null);
    if (!module) {
      codes.forget();
      reportLost(say("server.partMissing"));
    } else if (shown) {
      const { answer, wish } = shown;
      const isOfIt = steps && isSame(collisionIn(steps.needed.parameters), collisionIn(wish.body));
      module.showCodes(byTestId("codes-body", element), {
        answer,
        bodies: textsOfMaterial(wish.material).name,
        steps: isOfIt ? steps : null,
        state: present(),
      });
    }
  }

  async function follow() {
    try {
      materials ??= client.materials();
      const state = present();
      const material = materialOf(await materials, state.impact);
      const { body_1, body_2 } = contactBody(material, state.impact);
      const { normal_velocity_m_s } = valuesOf(material, state.impact);
      codes.follow({
        body: { body_1, body_2, normal_velocity_m_s, ...state.collision },
        material,
      });
    } catch (error) {
      materials = null;
      explain(error);
    }
  }

  details.addEventListener("toggle", () => {
    if (details.open) {
      follow();
    }
  });

  return {
    /** @param {PageState} state */
    follow(state) {
      details.open ||= embedded(state).includes("codes");
      if (details.open) {
        follow();
      }
    },

    /** @param {FoundSteps} found */
    settleSteps(found) {
      steps = found;
      if (details.open) {
        draw();
      }
    },

    shown: () => shown?.answer ?? null,
    asked: () => codes.asked()?.body ?? {},
    forget: codes.forget,
  };
}

/** The parameters of a collision among others. @param {Record<string, any>} among */
function collisionIn(among) {
  return PARAMETERS.map(({ key }) => among[key]);
}
