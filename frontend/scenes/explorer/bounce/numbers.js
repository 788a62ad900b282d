// @ts-check

import { say } from "../../../format/words.js";
import { ABSENT, approximate, significant } from "../../../format/number.js";
import { make, told } from "../../../widgets/elements.js";
import { write } from "../../../widgets/write.js";
import { angleOf, speedOf } from "./motions.js";

const KEYS = ["bounce.comes", "bounce.leaves", "bounce.leavesAgain"];
/** What is smaller is rounding, over g_n. */
const NOTHING = 1e-12;

/**
 * The numbers of the motions before and after, above the picture.
 * @param {HTMLElement} element
 */
export function mountNumbers(element) {
  const groups = KEYS.map((key, i) => {
    const number = (/** @type {string} */ name) => {
      const value = make("span", "", ABSENT);
      value.dataset.testid = `bounce-${name}-${i}`;
      return value;
    };
    const values = { angle: number("angle"), speed: number("speed"), spin: number("spin") };
    const group = make("p", "");
    const head = make("b", "", say(key));
    group.append(
      ...[head, values.angle],
      ...[make("var", "of-velocity", "v"), values.speed],
      ...[make("var", "of-spin", "Rω"), values.spin, told("span", "of-unit", "g_n")],
    );
    return { group, values };
  });
  element.append(...groups.map(({ group }) => group));
  groups[2].group.hidden = true;

  return {
    /**
     * @param {import("./motions.js").Motion[]} motions
     * @param {boolean} isExact and not read off a map, what comes after the first of them
     */
    show(motions, isExact) {
      element.toggleAttribute("data-again", motions.length > 2);
      for (const [i, { group, values }] of groups.entries()) {
        const motion = motions[i];
        group.hidden = !motion;
        if (motion) {
          const inDigits = (/** @type {number} */ value) =>
            isExact || i === 0
              ? significant(Math.abs(value) < NOTHING ? 0 : value)
              : approximate(value);
          write(values.angle, `${inDigits(angleOf(motion))}°`);
          write(values.speed, inDigits(speedOf(motion)));
          write(values.spin, inDigits(motion.spin));
        }
      }
    },
  };
}
