// @ts-check

import { byTestId } from "./find.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/collision-load.js").LoadedCollision} LoadedCollision
 * @typedef {object} LessonHandlers
 * @property {(language: string) => Promise<Record<string, any>>} loadTexts
 * @property {(error: unknown) => void} onError
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
    const { mountLessonScene } = await import("./lesson-scene.js");
    scene = mountLessonScene(byTestId("lesson"), byTestId("handout"), handlers);
    if (state) {
      scene.follow(state);
    }
    if (answer) {
      scene.settle(answer, false);
    }
  }

  return {
    /** @param {PageState} next */
    follow(next) {
      state = next;
      if (scene) {
        scene.follow(state);
      } else if (state.scene === "lesson" && !isOpening) {
        open();
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
