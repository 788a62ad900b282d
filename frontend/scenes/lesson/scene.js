// @ts-check

import { byTestId } from "../../widgets/find.js";

/**
 * The scene "Lesson", beside the pictures of the explorer. Its code and texts come only when it is opened.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountLesson(page) {
  /** @type {ReturnType<typeof import("./lesson.js").mountOpenLesson> | null} */
  let lesson = null;
  let isOpening = false;
  /** @type {import("../../state/collision-load.js").LoadedCollision | null} */
  let answer = null;

  async function open() {
    isOpening = true;
    const module = await import("./lesson.js").catch(() => null);
    isOpening = false;
    if (!module) {
      page.reportLost("The lesson did not arrive");
      return;
    }
    lesson = module.mountOpenLesson(byTestId("lesson"), byTestId("handout"), page);
    lesson.show(page.present());
    if (answer) {
      lesson.settle(answer, false);
    }
  }

  /** @param {import("../../state/url.js").PageState} state */
  function show(state) {
    if (lesson) {
      lesson.show(state);
    } else if (state.scene === "lesson" && !isOpening) {
      open();
    }
  }

  return {
    show,

    // It asks for no more than the collision, and for its texts when it is shown.
    follow() {},

    settle(next, { change }, isPresent) {
      if (isPresent) {
        answer = next;
        lesson?.settle(next, change.dragging);
      }
    },

    forget() {
      lesson?.forget();
      show(page.present());
    },

    pictures: {},
  };
}
