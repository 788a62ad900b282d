// @ts-check

import { duration, inUnits, powerOfTen, significant } from "../../format/number.js";
import { writeAddress } from "../../state/address/writing.js";
import { say } from "../../format/words.js";
import { make, told } from "../../widgets/elements.js";

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
 * @param {import("../../state/address/options.js").PageState} subject.state
 */
export function showCodes(place, { answer, bodies, steps, state }) {
  const velocity = inUnits(answer.normal_velocity_m_s, "m/s");
  const intro = told("p", "", say("codes.bodies", { bodies, velocity }));
  const change = link(say("codes.change"), writeAddress({ ...state, scene: "spheres" }));
  const list = make("dl", "");
  for (const [name, value] of quantitiesOf(answer, steps)) {
    list.append(make("div", "", told("dt", "", name), told("dd", "", value)));
  }
  const guide = make("p", "", link(say("codes.guide"), GUIDE));
  intro.append(" ", change);
  const codes = make("ul", "", ...answer.codes.map(itemOf));
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
  const name = make("h3", "", code, " ", make("code", "", style));
  const input = make("div", "");
  if (lines.length > 0) {
    input.append(make("pre", "", lines.join("\n")));
  } else {
    const key = law === "linear" ? "codes.untold" : "codes.none";
    input.append(told("p", "", say(key, { value: significant(kappa) })));
  }
  input.append(told("p", "codes-law", say(`codes.laws.${style}`)));
  const other = say(law === "this" ? "codes.otherDamping" : "codes.otherLaw");
  const restitution = epsilon === null ? other : `ε_t = ${significant(epsilon)}`;
  return make("li", "", name, input, told("p", "codes-restitution", restitution));
}

/**
 * @param {string} text
 * @param {string} address
 */
function link(text, address) {
  const element = told("a", "", text);
  element.href = address;
  return element;
}
