// @ts-check

import { lostShare } from "../format/energy.js";
import {
  ABSENT,
  approximate,
  duration,
  errorBound,
  percentage,
  significant,
  typable,
} from "../format/number.js";
import { say } from "../format/words.js";
import { METHODS, titleOf } from "../state/accuracy.js";
import { placeWithin } from "../state/scales.js";
import { byTestId, find } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";
import { write } from "../widgets/write.js";

/** @typedef {Pick<import("../state/loading/collision-load.js").LoadedCollision, "result" | "sentence">} Answered */

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
  const epsilonN = place("epsilon-n");
  const figures = find(".figures", element);
  const summary = place("summary");
  const provenance = place("provenance");
  const mark = place("gauge-mark");

  /**
   * @param {{epsilon_t: number, switches: number | null}} result
   * @param {(value: number) => string} inDigits
   */
  function showMain(result, inDigits) {
    writeFigure(epsilon, inDigits(result.epsilon_t));
    write(switches, count(result.switches));
    const { x, beyond } = placeWithin((result.epsilon_t + 1) / 2, 0);
    mark.style.setProperty("--place", String(x));
    mark.dataset.beyond = String(beyond.x);
  }

  return {
    /**
     * What the map knows of a collision that is on its way; the other numbers fade until it is here.
     * @param {import("../scenes/explorer/map-reading.js").MapReading | null} reading
     */
    preview(reading) {
      element.toggleAttribute("data-stale", true);
      element.toggleAttribute("data-from-map", reading !== null);
      summary.setAttribute("aria-busy", "true");
      if (reading) {
        showMain(reading, approximate);
      }
    },

    /**
     * @param {Answered} answer
     * @param {boolean} dragging a screen reader is told the sentence only when this is over
     * @param {boolean} isPresent whether it is of the present collision, and not of one a moment ago
     */
    show({ result, sentence }, dragging, isPresent) {
      summary.setAttribute("aria-busy", String(dragging));
      if (isPresent) {
        element.removeAttribute("data-stale");
        element.removeAttribute("data-from-map");
      }
      if (!element.hasAttribute("data-from-map")) {
        showMain(result, significant);
      }
      epsilon.title = say("result.convention");
      write(reversals, count(result.reversals));
      write(energyLost, percentage(lostShare(result)));
      writeFigure(contactDuration, significant(result.contact_duration));
      writeFigure(psi, significant(result.parameters.psi ?? Infinity));
      writeFigure(epsilonN, significant(result.epsilon_n));
      figures.toggleAttribute("data-damped", result.parameters.damping > 0);
      typeset(summary, sentence);
      provenance.title = result.milliseconds === null ? say("result.computedHere") : "";
      write(
        provenance,
        `${titleOf(METHODS, result.method)} ${errorBound(result.error_bound)} · ${took(result)}`,
      );
    },
  };
}

/** A number in its room, into which one with a power of ten goes smaller. @param {HTMLElement} element @param {string} text */
function writeFigure(element, text) {
  write(element, text);
  element.toggleAttribute("data-long", text.includes("×"));
}

/** Who has computed, or how long the server took for it. @param {Answered["result"]} result */
function took({ milliseconds }) {
  return milliseconds === null ? say("result.here") : duration(milliseconds);
}

/** @param {number | null} value */
function count(value) {
  return String(value ?? ABSENT);
}

/** The same in a table. @param {Answered} answer @returns {import("../figures/tables.js").Table} */
export function resultTable({ result, sentence }) {
  const { kappa, mu_over_alpha: mu, gt_over_gn: gt, damping, psi } = result.parameters;
  return {
    caption: say("result.caption", { sentence }),
    headings: [say("result.quantity"), say("result.value")],
    rows: [
      ["κ", typable(kappa)],
      ["μ/α", typable(mu)],
      ["g_t/g_n", typable(gt)],
      ["η", typable(damping)],
      ["ψ", significant(psi ?? Infinity)],
      ["ε_n", significant(result.epsilon_n, 8)],
      ["ε_t", significant(result.epsilon_t, 8)],
      [say("result.error"), errorBound(result.error_bound)],
      [say("symbols.switchesName"), count(result.switches)],
      [say("symbols.turnsName"), count(result.reversals)],
      [say("result.contact"), significant(result.contact_duration, 6)],
      [say("energy.lost"), percentage(lostShare(result))],
      [say("result.method"), titleOf(METHODS, result.method)],
    ],
  };
}
