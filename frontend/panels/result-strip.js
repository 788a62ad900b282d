// @ts-check

import { duration, errorBound, percentage, significant } from "../format/number.js";
import { byTestId } from "./find.js";
import { typeset } from "./typeset.js";

/**
 * The strip with ε_t and what else is to be said of the collision.
 * @param {HTMLElement} element
 */
export function mountResultStrip(element) {
  const place = (/** @type {string} */ id) => byTestId(id, element);
  const epsilon = place("epsilon-t");
  const switches = place("switches");
  const reversals = place("reversals");
  const energyLost = place("energy-lost");
  const contactDuration = place("contact-duration");
  const psi = place("psi");
  const summary = place("summary");
  const provenance = place("provenance");
  const mark = place("gauge-mark");

  return {
    /**
     * @param {import("../api/client.js").CollisionAnswer} result
     * @param {boolean} dragging a screen reader is told the sentence only when this is over
     */
    show(result, dragging) {
      summary.setAttribute("aria-busy", String(dragging));
      write(epsilon, significant(result.epsilon_t));
      epsilon.toggleAttribute(
        "data-long",
        Math.abs(result.epsilon_t) < 1e-3 && result.epsilon_t !== 0,
      );
      epsilon.title = result.convention;
      write(switches, count(result.switches));
      write(reversals, count(result.reversals));
      write(energyLost, lostShare(result.energy));
      write(contactDuration, significant(result.contact_duration));
      write(psi, significant(result.parameters.psi ?? Infinity));
      typeset(summary, result.summary);
      write(
        provenance,
        `${result.method} ${errorBound(result.error_bound)} · ${duration(result.milliseconds)}`,
      );
      mark.style.setProperty("--place", String((result.epsilon_t + 1) / 2));
    },
  };
}

/**
 * @param {HTMLElement} element
 * @param {string} text
 */
function write(element, text) {
  if (element.textContent !== text) {
    element.textContent = text;
  }
}

/** @param {number | null} value */
function count(value) {
  return value === null ? "–" : String(value);
}

/** @param {{initial: number, dissipated: number}} energy */
function lostShare({ initial, dissipated }) {
  return percentage(initial > 0 ? dissipated / initial : 0);
}
