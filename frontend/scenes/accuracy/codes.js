// @ts-check

import { duration, inUnits, powerOfTen, significant } from "../../format/number.js";
import { writeAddress } from "../../state/url.js";
import { say } from "../../format/words.js";
import { typeset } from "../../widgets/typeset.js";

/**
 * @typedef {import("../../api/answers.js").CodesAnswer} CodesAnswer
 * @typedef {CodesAnswer["codes"][number]} CodeInput
 * @typedef {import("./codes-panel.js").FoundSteps} FoundSteps
 */

const GUIDE = "guide/for-dem-codes.html";

/**
 * Shows what codes take for a collision, in place of what was shown.
 * @param {HTMLElement} place
 * @param {object} subject
 * @param {CodesAnswer} subject.answer
 * @param {string} subject.bodies
 * @param {FoundSteps | null} subject.steps that the collision takes
 * @param {import("../../state/url.js").PageState} subject.state
 */
export function showCodes(place, { answer, bodies, steps, state }) {
  const velocity = inUnits(answer.normal_velocity_m_s, "m/s");
  const intro = paragraph(say("codes.bodies", { bodies, velocity }));
  const change = link(say("codes.change"), writeAddress({ ...state, scene: "spheres" }));
  const list = document.createElement("dl");
  for (const [name, value] of quantitiesOf(answer, steps)) {
    const pair = document.createElement("div");
    pair.append(filled("dt", name), filled("dd", value));
    list.append(pair);
  }
  const guide = document.createElement("p");
  guide.append(link(say("codes.guide"), GUIDE));
  intro.append(" ", change);
  const codes = document.createElement("ul");
  codes.append(...answer.codes.map(itemOf));
  place.replaceChildren(intro, list, codes, guide);
}

/**
 * What the laws share, in SI units.
 * @param {CodesAnswer} answer
 * @param {FoundSteps | null} steps
 * @returns {[string, string][]}
 */
function quantitiesOf(answer, steps) {
  const seconds = answer.contact_duration_s;
  return [
    ["k_n", inUnits(answer.normal_stiffness_pa, "Pa")],
    ["k_t", inUnits(answer.tangential_stiffness_n_per_m, "N/m")],
    ["μ", significant(answer.friction_coefficient)],
    ["γ", `${significant(answer.viscous_damping_per_metre_second)} /(m s)`],
    ["g_t", inUnits(answer.tangential_velocity_m_s, "m/s")],
    ["ε_n", significant(answer.epsilon_n)],
    ["ε_t", significant(answer.epsilon_t)],
    [say("codes.duration"), inUnits(seconds, "s")],
    ...(steps ? [stepOf(seconds, steps)] : []),
  ];
}

/**
 * @param {number} seconds of the contact
 * @param {FoundSteps} steps
 * @returns {[string, string]}
 */
function stepOf(seconds, { needed, error: wanted }) {
  const error = powerOfTen(Math.round(Math.log10(Number(wanted))));
  const steps = needed.needed.velocity_verlet.worst;
  const text =
    steps === null
      ? say("codes.stepNever", { error })
      : say("codes.stepFor", { step: duration((1000 * seconds) / steps), steps, error });
  return [say("codes.step"), text];
}

/** @param {CodeInput} each */
function itemOf({ code, style, law, lines, kappa, epsilon_t: epsilon }) {
  const item = document.createElement("li");
  const name = holding("h3", code);
  const input = document.createElement("div");
  name.append(" ", holding("code", style));
  if (lines.length > 0) {
    input.append(holding("pre", lines.join("\n")));
  } else {
    const key = law === "linear" ? "codes.untold" : "codes.none";
    input.append(paragraph(say(key, { value: significant(kappa) })));
  }
  input.append(paragraph(say(`codes.laws.${style}`), "codes-law"));
  const other = say(law === "this" ? "codes.otherDamping" : "codes.otherLaw");
  const restitution = epsilon === null ? other : `ε_t = ${significant(epsilon)}`;
  item.append(name, input, paragraph(restitution, "codes-restitution"));
  return item;
}

/**
 * @param {string} name of an element
 * @param {string} text with symbols
 */
function filled(name, text) {
  const element = document.createElement(name);
  typeset(element, text);
  return element;
}

/**
 * @param {string} name of an element
 * @param {string} text as it stands
 */
function holding(name, text) {
  const element = document.createElement(name);
  element.textContent = text;
  return element;
}

/**
 * @param {string} text
 * @param {string} [className]
 */
function paragraph(text, className = "") {
  const element = filled("p", text);
  element.className = className;
  return element;
}

/**
 * @param {string} text
 * @param {string} address
 */
function link(text, address) {
  const element = document.createElement("a");
  element.href = address;
  typeset(element, text);
  return element;
}
