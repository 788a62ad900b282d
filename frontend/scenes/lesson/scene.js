// @ts-check

import { byTestId } from "../../widgets/find.js";
import { mountOpenLesson } from "./lesson.js";

/**
 * The scene "Lesson", beside the pictures of the explorer.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountLesson(page) {
  const lesson = mountOpenLesson(byTestId("lesson"), byTestId("handout"), page);

  return {
    show: lesson.show,

    // It asks for no more than the collision.
    follow() {},

    settle(answer, { change }, isPresent) {
      if (isPresent) {
        lesson.settle(answer, change.dragging);
      }
    },

    forget() {},

    pictures: {},
  };
}
