// @ts-check

import { TRACE_MARGIN } from "../../figures/plot-area.js";
import { significant } from "../../format/number.js";
import { SYMBOLS } from "../../format/symbols.js";
import { find } from "../../widgets/find.js";
import { layOver } from "../../widgets/plots/overlay.js";

/** @typedef {import("../../api/answers.js").Trace} Trace */

/**
 * The plots over time and what is read in them: symbols and columns.
 * @type {{panel: string, columns: [string, "normal_force" | "tangential_force_over_mu" | "tangential_velocity"][]}[]}
 */
const VIEWS = [
  {
    panel: ".force",
    columns: [
      [SYMBOLS.tangential_force_over_mu, "tangential_force_over_mu"],
      [SYMBOLS.normal_force, "normal_force"],
    ],
  },
  { panel: ".velocity", columns: [[SYMBOLS.gt_over_gn, "tangential_velocity"]] },
];

/**
 * One instant of the contact, under the pointer, marked and read in every plot over time.
 * Where no pointer is, the instant that the bounce shows is marked, without its readings.
 * @param {(share: number) => void} onPoint told where the pointer is
 */
export function mountTimeCursor(onPoint) {
  const cursors = VIEWS.map(({ panel }) => find(".time-cursor", find(panel)));
  const readings = VIEWS.map(({ panel }) => find(".reading", find(panel)));
  /** @type {Trace | null} */
  let trace = null;
  /** @type {number | null} share of the contact, 0 … 1 */
  let share = null;
  /** That of the bounce, null while the ball flies. @type {number | null} */
  let shown = null;
  /** How long the axis is at least, in time. */
  let least = 0;

  for (const cursor of cursors) {
    layOver(cursor, TRACE_MARGIN);
    cursor.addEventListener("pointermove", (event) => {
      move(Math.min(1, Math.max(0, (event.offsetX / cursor.clientWidth) * axis())));
    });
    cursor.addEventListener("pointerleave", () => move(null));
  }

  /** @param {number | null} next */
  function move(next) {
    share = next;
    if (share !== null) {
      onPoint(share);
    }
    draw();
  }

  /** The length of the axis over that of the contact. */
  function axis() {
    return trace ? Math.max(1, least / trace.contact_duration) : 1;
  }

  function draw() {
    if (!trace) {
      return;
    }
    const sample = share === null ? -1 : nearest(trace.time, share * trace.contact_duration);
    const instant = share === null ? shown : trace.time[sample] / trace.contact_duration;
    const isThere = instant !== null;
    const place = (instant ?? 0) / axis();
    for (const [k, cursor] of cursors.entries()) {
      cursor.style.setProperty("--x", place.toFixed(4));
      cursor.toggleAttribute("data-on", isThere);
      cursor.toggleAttribute("data-read", share !== null);
      cursor.toggleAttribute("data-late", isThere && place > 0.55);
      if (share !== null) {
        readings[k].innerHTML = reading(trace, sample, VIEWS[k]);
      }
    }
  }

  return {
    /** @param {Trace} next */
    show(next) {
      trace = next;
      draw();
    },

    /** How long the axis is at least. @param {number} duration */
    reach(duration) {
      least = duration;
      draw();
    },

    /** Where the bounce is. @param {number | null} next share of the contact, null in flight */
    follow(next) {
      shown = next;
      if (share === null) {
        draw();
      }
    },
  };
}

/**
 * @param {Trace} trace
 * @param {number} sample
 * @param {typeof VIEWS[number]} view
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
