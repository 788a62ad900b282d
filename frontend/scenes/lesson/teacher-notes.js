// @ts-check

import { textsOf } from "../../state/lesson.js";
import { make, told } from "../../widgets/elements.js";

/**
 * What a teacher wants to know of a step.
 * @param {import("../../state/lesson.js").Step} step
 * @param {import("../../format/words.js").Say} say
 */
export function teacherNotes(step, say) {
  const { aim, answer, misconception } = textsOf(step).notes;
  const rows = [
    [say("lesson.notes.aim"), say(aim)],
    [say("lesson.notes.answer"), say(answer)],
    [say("lesson.notes.misconception"), say(misconception)],
    [say("lesson.notes.time"), say("lesson.notes.minutes", { count: step.minutes })],
  ];
  return make(
    "dl",
    "notes",
    ...rows.flatMap(([name, text]) => [told("dt", "", name), told("dd", "", text)]),
  );
}
