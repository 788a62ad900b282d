// @ts-check

import { byTestId } from "./find.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/collision-load.js").LoadedCollision} LoadedCollision
 * @typedef {object} LessonHandlers
 * @property {(language: string) => Promise<Record<string, any>>} loadTexts
 * @property {(error: unknown) => void} onError
 * @property {(reason: string) => void} onLost
 * @property {(patch: Partial<PageState>) => void} onState
 */

/**
 * The scene "Lesson", whose code, texts and library come only when it is opened.
 * @param {LessonHandlers} handlers
 */
export function mountLessonDoor(handlers) {
  /** @type {ReturnType<typeof import("./lesson-scene.js").mountLessonScene> | null} */
  let scene = null;
  let isOpening = false;
  /** @type {PageState | null} */
  let state = null;
  /** @type {LoadedCollision | null} */
  let answer = null;

  async function open() {
    isOpening = true;
    const module = await import("./lesson-scene.js").catch(() => null);
    isOpening = false;
    if (!module) {
      handlers.onLost("The lesson did not arrive");
      return;
    }
    const { mountLessonScene } = module;
    scene = mountLessonScene(byTestId("lesson"), byTestId("handout"), handlers);
    if (state) {
      scene.follow(state);
    }
    if (answer) {
      scene.settle(answer, false);
    }
  }

  /** @param {PageState} next */
  function follow(next) {
    state = next;
    if (scene) {
      scene.follow(state);
    } else if (state.scene === "lesson" && !isOpening) {
      open();
    }
  }

  return {
    follow,

    /** Asks again for what did not come, as after the server was away. */
    forget() {
      scene?.forget();
      if (state) {
        follow(state);
      }
    },

    /**
     * What the server says of the present collision.
     * @param {LoadedCollision} next
     * @param {boolean} dragging
     */
    settle(next, dragging) {
      answer = next;
      scene?.settle(next, dragging);
    },

    unmount: () => scene?.unmount(),
  };
}
