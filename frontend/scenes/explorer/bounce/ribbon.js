// @ts-check

import { spreadApart } from "../../../figures/spread.js";
import { make } from "../../../widgets/elements.js";
import { regimePieces } from "../regimes.js";
import { shareAt } from "./clock.js";

const COLORS = {
  forward: "var(--sliding)",
  backward: "var(--sliding-back)",
  sticking: "var(--sticking)",
  many: "var(--many)",
};
const FLIGHT = "var(--well)";
/** A number in its circle. */
const NUMBER_PIXELS = 15;
/** How far a number may stand from its switch, in widths of a number. */
const FARTHEST = 1.5;

/**
 * What the clock goes over: flights, and contacts in the colours of their regimes with their switches numbered.
 * @param {HTMLElement} element
 */
export function mountRibbon(element) {
  return {
    /**
     * @param {import("./clock.js").Stretch[]} stretches
     * @param {(import("../../../api/answers.js").Trace | null)[]} traces of the contacts
     * @param {number} width in pixels of the design
     */
    show(stretches, traces, width) {
      const stops = stretches.flatMap((stretch) => {
        const trace = stretch.kind === "contact" ? traces[stretch.index] : null;
        return trace
          ? stopsOf(stretches, stretch.index, trace, width)
          : [stop(FLIGHT, stretch.from, stretch.to)];
      });
      element.style.setProperty("background-image", `linear-gradient(90deg,${stops.join(",")})`);
      element.replaceChildren(
        ...traces.flatMap((trace, i) => (trace ? numbersOf(stretches, i, trace, width) : [])),
      );
    },
  };
}

/**
 * @param {import("./clock.js").Stretch[]} stretches
 * @param {number} contact
 * @param {import("../../../api/answers.js").Trace} trace
 * @param {number} width
 */
function stopsOf(stretches, contact, trace, width) {
  const { contact_duration: duration } = trace;
  const at = (/** @type {number} */ time) => shareAt(stretches, contact, time / duration);
  const pixels = (width * (at(duration) - at(0))) / duration;
  return regimePieces(trace, pixels).map(({ kind, start, end }) =>
    stop(COLORS[kind], at(start), at(end)),
  );
}

/** @param {string} color @param {number} from @param {number} to */
function stop(color, from, to) {
  return `${color} ${(100 * from).toFixed(3)}% ${(100 * to).toFixed(3)}%`;
}

/**
 * @param {import("./clock.js").Stretch[]} stretches
 * @param {number} contact
 * @param {import("../../../api/answers.js").Trace} trace
 * @param {number} width
 */
function numbersOf(stretches, contact, { switch_times: times, contact_duration: duration }, width) {
  const [begin, end] = [0, 1].map((share) => width * shareAt(stretches, contact, share));
  const wanted = [...times].map((time) => begin + (time / duration) * (end - begin));
  const spread = spreadApart(wanted, NUMBER_PIXELS, begin, end) ?? [];
  const isNear = spread.every((place, i) => Math.abs(place - wanted[i]) < FARTHEST * NUMBER_PIXELS);
  return (isNear ? spread : []).map((place, i) => {
    const number = make("span", "", String(i + 1));
    number.style.setProperty("--share", (place / width).toFixed(4));
    return number;
  });
}
