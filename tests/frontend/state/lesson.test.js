import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";

import { METHODS } from "../../../frontend/state/accuracy.js";
import { READINGS, settingOf, stepOf, STEPS, textsOf } from "../../../frontend/state/lesson.js";
import { PARAMETERS } from "../../../frontend/state/parameters.js";
import { readAddress } from "../../../frontend/state/address/reading.js";
import { writeAddress } from "../../../frontend/state/address/writing.js";
import { flat, LOCALES } from "../locales.js";

const FRONTEND = new URL("../../../frontend/", import.meta.url);
const goals = STEPS.filter(({ question }) => question.kind === "goal");
const choices = STEPS.filter(({ question }) => question.kind === "choice");

const locales = Object.fromEntries(Object.entries(LOCALES).map(([id, texts]) => [id, flat(texts)]));

test("every step says one thing, in two to four sentences", () => {
  for (const [id, texts] of Object.entries(locales)) {
    for (const step of STEPS) {
      const text = texts[textsOf(step).text];
      const sentences = text.replaceAll(/\d[.,]\d/g, "").match(/[.?!](?=\s|$)/g) ?? [];
      assert.ok(sentences.length >= 2 && sentences.length <= 4, `${id}: ${step.id}`);
    }
  }
});

test("the document for teachers has every step, with its title, question and time", () => {
  const document = readFileSync(new URL("../docs/lesson.md", FRONTEND), "utf8");
  const rows = STEPS.map(({ minutes, question, ...step }, i) => {
    const title = locales.en[textsOf({ question, ...step }).title];
    return `/?scene=lesson&step=${i + 1}) | ${title} | ${question.kind} | ${minutes} |`;
  });
  assert.deepEqual(
    rows.filter((row) => !document.includes(row)),
    [],
  );
  const total = STEPS.reduce((sum, { minutes }) => sum + minutes, 0);
  assert.ok(document.includes(`about ${total} minutes`));
});

test("an address that names a step alone brings what the step sets", () => {
  for (const [i, step] of STEPS.entries()) {
    const { state, problems } = readAddress(`?scene=lesson&step=${i + 1}`);
    assert.deepEqual(problems, []);
    for (const [key, value] of Object.entries(step.setting)) {
      assert.deepEqual(state[key], value, `${step.id}: ${key}`);
    }
  }
});

test("the address of a step that is played with leads back to where the play was", () => {
  for (const [i, step] of STEPS.entries()) {
    const { state } = readAddress(`?scene=lesson&step=${i + 1}&lang=de&notes=shown`);
    for (const { id: method } of METHODS) {
      const played = {
        ...state,
        collision: { ...step.setting.collision, kappa: 7, damping: 0.1 },
        accuracy: { ...step.setting.accuracy, method },
        map_y: "gt_over_gn",
        scale: "linear",
      };
      assert.deepEqual(readAddress(writeAddress(played)), { state: played, problems: [] });
    }
  }
});

test("outside of the lesson a step sets nothing", () => {
  assert.deepEqual(settingOf("explorer", "8"), {});
  assert.equal(readAddress("?step=8").state.map_y, "gt_over_gn");
});

test("steps are numbered from one, and there is none beyond the last", () => {
  assert.equal(stepOf("1"), STEPS[0]);
  assert.equal(stepOf(String(STEPS.length)), STEPS.at(-1));
  assert.equal(stepOf("0"), undefined);
  assert.match(readAddress(`?scene=lesson&step=${STEPS.length + 1}`).problems[0], /^step must be/);
});

test("every choice has one right option among the others", () => {
  assert.equal(choices.length, 3);
  for (const { question } of choices) {
    assert.ok(question.options.length >= 3);
    assert.ok(question.options.includes(question.right));
  }
});

/** An answer of the server, as far as goals look at it. */
function seen(step, { collision = {}, accuracy = {}, exact = {}, shown = {} }) {
  const { setting } = step;
  const answer = {
    epsilon_t: 0.5,
    switches: 2,
    reversals: 1,
    error_bound: 1e-14,
    estimates: { coulomb: 0 },
    parameters: { psi: 0.5 },
    ...exact,
  };
  return {
    state: {
      collision: { ...setting.collision, ...collision },
      accuracy: { ...setting.accuracy, ...accuracy },
    },
    exact: answer,
    shown: { ...answer, ...shown },
  };
}

test("a goal is met by what the server answers, and each miss has its own hint", () => {
  const cases = {
    stop: [
      [{ exact: { epsilon_t: -0.019 } }, "met"],
      [{ exact: { epsilon_t: 0.021 } }, "forward"],
      [{ exact: { epsilon_t: -0.021 } }, "backward"],
    ],
    reversal: [
      [{ exact: { reversals: 3 } }, "met"],
      [{ exact: { reversals: 2 } }, "few"],
      [{ exact: { reversals: null } }, "few"],
      [{ exact: { reversals: 0 } }, "never"],
    ],
    coulomb: [
      [{ exact: { switches: 0, epsilon_t: 0.3, estimates: { coulomb: 0.3 } } }, "met"],
      // a true zero that Coulomb's law has by chance
      [{ exact: { switches: 2, epsilon_t: 0, estimates: { coulomb: 0 } } }, "sticks"],
    ],
    gear: [
      [{ exact: { epsilon_t: -0.99 } }, "met"],
      [{ exact: { epsilon_t: -0.98 } }, "backward"],
      [{ exact: { epsilon_t: 0.9 } }, "forward"],
    ],
    collapse: [
      [{ collision: { mu_over_alpha: 2.8 }, exact: { parameters: { psi: 0.514 } } }, "met"],
      [{ collision: { mu_over_alpha: 2.8 }, exact: { parameters: { psi: 0.516 } } }, "apart"],
      [{ collision: { mu_over_alpha: 0 }, exact: { parameters: { psi: null } } }, "apart"],
      [{}, "friction"],
      [{ collision: { mu_over_alpha: 2.8, kappa: 17 } }, "other"],
      [{ collision: { mu_over_alpha: 2.8, damping: 0.1 } }, "other"],
    ],
    damping: [
      [{ exact: { switches: 5 } }, "met"],
      [{ exact: { switches: 4 } }, "even"],
      [{ exact: { switches: null } }, "even"],
    ],
    timestep: [
      [{ shown: { error_bound: 1e-3 } }, "met"],
      [{ shown: { error_bound: 2e-3 } }, "coarse"],
      [{ shown: { epsilon_t: -0.1, error_bound: 0.6 } }, "sign"],
      [{ accuracy: { method: "auto" } }, "method"],
      [{ collision: { kappa: 1 } }, "other"],
    ],
  };
  assert.deepEqual(
    Object.keys(cases),
    goals.map(({ id }) => id),
  );
  for (const step of goals) {
    for (const [answer, verdict] of cases[step.id]) {
      assert.equal(step.question.judge(seen(step, answer)), verdict, step.id);
    }
    const hinted = new Set(cases[step.id].map(([, verdict]) => verdict));
    assert.deepEqual([...hinted].sort(), ["met", ...step.question.hints].sort(), step.id);
  }
});

test("a goal names controls that are there, and numbers that the server gives", () => {
  const known = [...PARAMETERS.map(({ key }) => key), "steps"];
  for (const step of goals) {
    assert.ok(
      step.question.steers.every((key) => known.includes(key)),
      step.id,
    );
    for (const reading of step.question.readings) {
      assert.notEqual(READINGS[reading](seen(step, {})), undefined, `${step.id}: ${reading}`);
    }
  }
});
