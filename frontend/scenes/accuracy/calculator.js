// @ts-check

import { powerOfTen, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { INTEGRATORS, titleOf } from "../../state/accuracy.js";
import { REGIONS, STATISTICS, WANTED_ERRORS } from "../../state/tradeoff-options.js";
import { byTestId } from "../../widgets/find.js";
import { typeset } from "../../widgets/typeset.js";

/** @typedef {import("../../api/answers.js").StepsAnswer} StepsAnswer */

/**
 * The steps per contact that a wanted error takes, for the present collision and for a region.
 * @param {HTMLElement} element
 * @param {(patch: {wanted_error: string}) => void} onOption
 */
export function mountCalculator(element, onOption) {
  const body = byTestId("steps", element);
  const wanted = /** @type {HTMLSelectElement} */ (byTestId("wanted-error", element));
  const ascending = [...WANTED_ERRORS].sort((a, b) => Number(b) - Number(a));
  wanted.append(...ascending.map((error) => new Option(inPower(error), error)));
  wanted.addEventListener("change", () => onOption({ wanted_error: wanted.value }));

  return {
    /** @param {{wanted_error: string}} state */
    options({ wanted_error: error }) {
      wanted.value = error;
    },

    /** @param {{here: StepsAnswer, there: StepsAnswer, region: string}} answers */
    show(answers) {
      const note = document.createElement("p");
      typeset(note, noteOf(answers));
      body.replaceChildren(tableOf(answers), note);
    },
  };
}

/** @param {{here: StepsAnswer, there: StepsAnswer, region: string}} answers */
function tableOf({ here, there, region }) {
  const shares = [titleOf(STATISTICS, "p95"), say("steps.all")];
  const table = document.createElement("table");
  const head = table.createTHead();
  head
    .insertRow()
    .append(
      heading("", ""),
      wide(say("steps.here")),
      wide(say("steps.there", { region: titleOf(REGIONS, region) })),
    );
  head.insertRow().append(...["", ...shares, ...shares].map((text) => heading(text, "col")));
  const rows = table.createTBody();
  for (const [integrator, needed] of Object.entries(here.needed)) {
    const row = rows.insertRow();
    row.append(heading(titleOf(INTEGRATORS, integrator), "row"));
    for (const { p95, worst } of [needed, there.needed[integrator]]) {
      for (const steps of [p95, worst]) {
        row.insertCell().textContent = inSteps(steps);
      }
    }
  }
  return table;
}

/** @param {{here: StepsAnswer, there: StepsAnswer}} answers */
function noteOf({ here, there }) {
  const [own, general] = [here.rule, there.rule];
  return [
    say("steps.phases", { here: here.phases, there: there.phases }),
    triedOf(here.needed.velocity_verlet.worst_tried),
    say("steps.unstable", { limit: significant(here.stability_limit, 3) }),
    say("steps.rule", {
      steps: Math.round(own.steps_max),
      error: inError(own.velocity_verlet.error_max),
      usual: inError(general.velocity_verlet.error_p95),
      worst: inError(general.velocity_verlet.error_max),
    }),
  ].join(" ");
}

/**
 * How closely it was tried about the answer in the first row.
 * @param {StepsAnswer["needed"][string]["worst_tried"]} tried
 */
function triedOf(tried) {
  if (tried === null) {
    return say("steps.triedLadder");
  }
  const { first, last, count } = tried;
  const isAll = count === last - first + 1;
  return say(isAll ? "steps.triedAll" : "steps.triedSome", { numbers: count, first, last });
}

/** @param {number | null} steps */
function inSteps(steps) {
  return steps === null
    ? say("steps.never")
    : steps.toLocaleString("en-GB").replaceAll(",", "\u202f");
}

/** @param {number | null} error */
function inError(error) {
  return significant(error, 2);
}

/** @param {string} error */
function inPower(error) {
  return powerOfTen(Math.round(Math.log10(Number(error))));
}

/**
 * @param {string} text
 * @param {string} scope
 */
function heading(text, scope) {
  const cell = document.createElement(text ? "th" : "td");
  cell.textContent = text;
  if (text) {
    cell.scope = scope;
  }
  return cell;
}

/** @param {string} text */
function wide(text) {
  const cell = heading(text, "colgroup");
  cell.colSpan = 2;
  return cell;
}
