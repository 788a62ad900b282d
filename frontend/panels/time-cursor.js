// @ts-check

import { TRACE_MARGIN } from "../figures/plot-area.js";
import { significant } from "../format/number.js";
import { find } from "./find.js";

/**
 * @typedef {import("../api/client.js").Trace} Trace
 * @typedef {object} View one plot over time and the line that reads it
 * @property {HTMLElement} panel
 * @property {[symbol: string, column: "normal_force" | "tangential_force_over_mu" | "tangential_velocity"][]} columns
 */

/**
 * One instant of the contact, under the pointer, marked and read in every plot over time.
 * @param {View[]} views
 */
export function mountTimeCursor(views) {
  const { l, r, t, b } = TRACE_MARGIN;
  const cursors = views.map(({ panel }) => find(".time-cursor", panel));
  const readings = views.map(({ panel }) => find(".reading", panel));
  /** @type {Trace | null} */
  let trace = null;
  /** @type {number | null} share of the contact, 0 … 1 */
  let share = null;

  for (const cursor of cursors) {
    cursor.style.setProperty("inset", `${t / 16}rem ${r / 16}rem ${b / 16}rem ${l / 16}rem`);
    cursor.addEventListener("pointermove", (event) => {
      move(Math.min(1, Math.max(0, event.offsetX / cursor.clientWidth)));
    });
    cursor.addEventListener("pointerleave", () => move(null));
  }

  /** @param {number | null} next */
  function move(next) {
    share = next;
    draw();
  }

  function draw() {
    const sample =
      trace && share !== null ? nearest(trace.time, share * trace.contact_duration) : -1;
    for (const [k, cursor] of cursors.entries()) {
      cursor.toggleAttribute("data-on", sample >= 0);
      cursor.toggleAttribute("data-late", (share ?? 0) > 0.55);
      if (trace && sample >= 0) {
        cursor.style.setProperty("--x", String(trace.time[sample] / trace.contact_duration));
        readings[k].innerHTML = reading(trace, sample, views[k]);
      }
    }
  }

  return {
    /** @param {Trace} next */
    show(next) {
      trace = next;
      if (share !== null) {
        draw();
      }
    },
  };
}

/**
 * @param {Trace} trace
 * @param {number} sample
 * @param {View} view
 */
function reading(trace, sample, { columns }) {
  const values = columns.map(
    ([symbol, column]) => `${symbol} ${significant(trace[column][sample], 3)}`,
  );
  return [`<var>t</var> ${significant(trace.time[sample], 3)}`, ...values].join(" · ");
}

/**
 * The index of the sample nearest to an instant.
 * @param {Float64Array} time ascending
 * @param {number} instant
 */
function nearest(time, instant) {
  let low = 0;
  let high = time.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (time[middle] < instant) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return instant - time[low] < time[high] - instant ? low : high;
}
