// @ts-check

import { powerOfTen, significant } from "../../format/number.js";
import { INTEGRATORS, titleOf } from "../../state/accuracy.js";
import { REGIONS, WANTED_ERRORS } from "../../state/tradeoff-options.js";
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
  const table = document.createElement("table");
  const head = table.createTHead();
  head
    .insertRow()
    .append(heading("", ""), wide("this collision"), wide(`region: ${titleOf(REGIONS, region)}`));
  head
    .insertRow()
    .append(...["", "95 %", "all", "95 %", "all"].map((text) => heading(text, "col")));
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
    `So many steps per contact, and all larger numbers that were tried, keep the error in 95 % or in all of the contacts, which begin at ${here.phases} instants within a step (those of the region at ${there.phases}).`,
    triedOf(here.needed.velocity_verlet.worst_tried),
    `Fewer than √κ t_c/2 = ${significant(here.stability_limit, 3)} are unstable here.`,
    `The rule of 50 √κ, with velocity Verlet, takes ${Math.round(own.steps_max)} and errs by up to ${inError(own.velocity_verlet.error_max)};`,
    `in the region it errs by less than ${inError(general.velocity_verlet.error_p95)} in 95 %, by ${inError(general.velocity_verlet.error_max)} at worst.`,
  ].join(" ");
}

/**
 * How closely it was tried about the answer in the first row.
 * @param {StepsAnswer["needed"][string]["worst_tried"]} tried
 */
function triedOf(tried) {
  if (tried === null) {
    return "Tried were those of a ladder by factors of √2.";
  }
  const { first, last, count } = tried;
  const numbers = count === last - first + 1 ? "all numbers" : `${count} numbers`;
  return `For velocity Verlet, here, ${numbers} from ${first} to ${last} were tried, and beyond them a ladder by factors of √2.`;
}

/** @param {number | null} steps */
function inSteps(steps) {
  return steps === null ? "never" : steps.toLocaleString("en-GB").replaceAll(",", "\u202f");
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
