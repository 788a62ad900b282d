// @ts-check

import { GROUND } from "./contact-drawing.js";
import { courseOf } from "./course.js";
import { mountView } from "./view.js";

/**
 * @typedef {import("../../../figures/plot-area.js").Size} Size
 * @typedef {import("./motions.js").Motion} Motion
 * @typedef {ReturnType<typeof import("./clock.js").phaseAt>} Phase
 */

/**
 * What is drawn besides the instant.
 * @typedef {object} Bounced
 * @property {Motion[]} motions before and after
 * @property {(import("./contact-motion.js").Motion | null)[]} contacts null for one that is not drawn
 * @property {boolean} isWall
 * @property {1 | 2} times how often it bounces
 */

/** One of the views side by side: its share of the width, the flights in it, and where its clock stands. */
const CONTACT = { width: 0.44, first: 0, last: 0, phase: stands("contact", 0, 0.42) };

/** What stills show where nothing is to move: the way of the ball, and the spring wound up. */
const STILLS = {
  1: [
    { width: 0.28, first: 0, last: 0, phase: stands("flight", 0, 0) },
    CONTACT,
    { width: 0.28, first: 1, last: 1, phase: stands("flight", 1, 1) },
  ],
  2: [{ width: 0.56, first: 0, last: 2, phase: stands("flight", 2, 1) }, CONTACT],
};

/** The wall under a ball that flies, in pixels; beside the contact's it has the height of that. */
const FLOOR = 14;

/**
 * The picture of a bounce: one view in which its clock goes, or stills side by side.
 * @param {SVGSVGElement} picture
 * @param {DocumentFragment} template of a view
 */
export function mountPicture(picture, template) {
  /** @type {ReturnType<typeof mountView>[]} */
  const views = [];
  /** @type {import("./view.js").Shown[]} */
  let shown = [];
  let areStills = false;

  /** @param {number[]} widths @param {number} height */
  function lay(widths, height) {
    while (views.length > widths.length) {
      views.pop()?.element.remove();
    }
    let x = 0;
    for (const [i, width] of widths.entries()) {
      views[i] ??= mountView(picture, template);
      views[i].lay(x, { width, height });
      x += width;
    }
  }

  return {
    /** Whether stills are drawn. */
    areStills: () => areStills,

    /**
     * @param {Bounced} bounced
     * @param {Size} size
     * @param {Phase | null} phase of the clock, null for stills
     */
    draw(bounced, size, phase) {
      areStills = phase === null;
      shown = phase ? [viewed(bounced, size, phase)] : stills(bounced, size);
      lay(
        shown.map((each) => each.size.width),
        size.height,
      );
      shown.forEach((each, i) => views[i].draw(each));
    },

    /** The same at another instant. @param {Phase} phase */
    drawInstant(phase) {
      if (shown.length > 0 && !areStills) {
        shown[0].phase = phase;
        views[0].drawInstant(shown[0]);
      }
    },
  };
}

/** @param {Bounced} bounced @param {Size} size @param {Phase} phase @returns {import("./view.js").Shown} */
function viewed({ motions, contacts, isWall, times }, size, phase) {
  const course = courseOf(motions, { isWall, times, floor: FLOOR }, size);
  return { course, contacts, isWall, phase, size };
}

/**
 * Flights to one scale, so that what is as fast goes as far.
 * @param {Bounced} bounced
 * @param {Size} size
 * @returns {import("./view.js").Shown[]}
 */
function stills({ motions, contacts, isWall, times }, { width, height }) {
  const looks = STILLS[times].map((look) => {
    const own = { width: Math.round(look.width * width), height };
    const of = { isWall, times, floor: GROUND, first: look.first, last: look.last };
    return { own, of, phase: look.phase };
  });
  const scales = looks
    .filter(({ phase }) => phase.kind === "flight")
    .map(({ own, of }) => courseOf(motions, of, own).pixels);
  return looks.map(({ own, of, phase }) => ({
    course: courseOf(motions, { ...of, most: Math.min(...scales) }, own),
    contacts,
    isWall,
    phase,
    size: own,
  }));
}

/** @param {"flight" | "contact"} kind @param {number} index @param {number} progress @returns {Phase} */
function stands(kind, index, progress) {
  return { kind, index, progress, from: 0, to: 1 };
}
