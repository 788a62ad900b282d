// @ts-check

import { byTestId } from "../../widgets/find.js";
import { mountGlass } from "./glass.js";
import { mountOpenLesson } from "./lesson.js";
import { createPredictions } from "./predictions.js";
import { createRecord } from "./record.js";

/**
 * The scene "Lesson", beside the pictures of the explorer.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountLesson(page) {
  const record = createRecord();
  const predictions = createPredictions(record);
  const glass = mountGlass();
  const lesson = mountOpenLesson(byTestId("lesson"), byTestId("handout"), page, {
    record,
    predictions,
    glass,
  });

  return {
    show(state) {
      glass.lay(predictions.isPending(state));
      lesson.show(state);
    },

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
