// @ts-check

import { placesAmong, spreadIndices } from "../../figures/sample.js";
import { ABSENT, significant } from "../../format/number.js";
import { say } from "../../format/words.js";
import { angleOf, speedOf } from "./bounce/motions.js";
import { rowsOf } from "../../state/map-view.js";
import { regimeOf } from "./regimes.js";

/**
 * @typedef {import("../../figures/tables.js").Table} Table
 * @typedef {import("../../api/answers.js").Trace} Trace
 */

/** Rows that sample a trace, to which its switches are added. */
const TRACE_ROWS = 40;
const SWITCH_ROWS = 60;
const CUT_ROWS = 30;

/** What a regime is called, without an arrow. */
const REGIME_KEYS = {
  forward: "regimes.slides",
  backward: "regimes.slidesBack",
  sticking: "regimes.sticks",
};

/** What the motions of a ball are called, one after another. */
const MOTION_KEYS = ["bounce.table.comes", "bounce.table.leaves", "bounce.table.leavesAgain"];

/** @param {Trace} trace @returns {Table} */
export function forceTable(trace) {
  return traceTable(trace, say("force.table"), {
    "F_t/μ": trace.tangential_force_over_mu,
    F_n: trace.normal_force,
  });
}

/** @param {Trace} trace @returns {Table} */
export function velocityTable(trace) {
  return traceTable(trace, say("velocity.table"), { "g_t(t)/g_n": trace.tangential_velocity });
}

/**
 * The ball before and after, over g_n.
 * @param {import("./bounce/motions.js").Motion[] | null} motions
 * @returns {Table | null}
 */
export function bounceTable(motions) {
  return (
    motions && {
      caption: say("bounce.table.caption"),
      headings: [
        say("bounce.table.motion"),
        say("bounce.table.angle"),
        say("bounce.table.speed"),
        say("bounce.table.normal"),
        say("bounce.table.centre"),
        say("bounce.table.spin"),
      ],
      rows: motions.map((motion, i) => [
        say(MOTION_KEYS[i]),
        `${significant(angleOf(motion))}°`,
        ...[speedOf(motion), motion.normal, motion.centre, motion.spin].map((value) =>
          significant(value),
        ),
      ]),
    }
  );
}

/**
 * @param {Trace} trace
 * @param {string} what
 * @param {Record<string, Float64Array>} columns
 * @returns {Table}
 */
function traceTable(trace, what, columns) {
  const { time, switch_times: switches } = trace;
  const marked = placesAmong(time, [...switches].slice(0, SWITCH_ROWS));
  const indices = spreadIndices(time.length, TRACE_ROWS, marked);
  const isSwitch = new Set(marked);
  return {
    caption: say("trace.caption", { what, shown: indices.length, all: time.length }),
    headings: [say("trace.time"), ...Object.keys(columns), say("trace.regime")],
    rows: indices.map((i) => [
      significant(time[i]),
      ...Object.values(columns).map((column) => significant(column[i])),
      regimeAt(trace, time[i], isSwitch.has(i)),
    ]),
  };
}

/**
 * The regime that holds or begins at an instant; the list of episodes may end before the contact does.
 * @param {Trace} trace
 * @param {number} instant
 * @param {boolean} beginsHere
 */
function regimeAt({ episodes, contact_duration: duration }, instant, beginsHere) {
  const episode = episodes.find(
    ({ start, end }) => instant >= start && (instant < end || end >= duration),
  );
  const regime = episode ? say(REGIME_KEYS[regimeOf(episode)]) : ABSENT;
  return beginsHere ? say("trace.fromHere", { regime }) : regime;
}

/**
 * The cut and its simple laws, at every so many of its points and at the present collision.
 * @param {import("../../api/queries.js").CutAxes & {cut: import("../../api/answers.js").Cut}} shown
 * @param {import("../../state/parameters.js").Collision} collision the present one
 * @returns {Table}
 */
export function cutTable({ cut, view, along, held, muOverAlpha }, collision) {
  const rows = rowsOf(view, collision);
  const [over, here, frame] =
    along === "kappa"
      ? ["κ", collision.kappa, `g_t/g_n = ${significant(held)}, μ/α = ${significant(muOverAlpha)}`]
      : [rows.along, rows.here, `κ = ${significant(held)}`];
  const [present] = placesAmong(cut.values, [here]);
  const indices = spreadIndices(cut.values.length, CUT_ROWS, [present]);
  return {
    caption: say("cut.caption", { over, frame, shown: indices.length, all: cut.values.length }),
    headings: [
      over,
      "ε_t",
      say("symbols.switchesName"),
      say("cut.coulomb"),
      say("cut.stiffBound"),
      say("cut.stiffLimit"),
    ],
    rows: indices.map((i) => [
      significant(cut.values[i]),
      significant(cut.epsilon_t[i]),
      String(cut.switches[i]),
      significant(cut.coulomb[i]),
      significant(cut.stiff_bound[i]),
      significant(cut.stiff_asymptote[i]),
    ]),
    here: indices.indexOf(present),
  };
}
