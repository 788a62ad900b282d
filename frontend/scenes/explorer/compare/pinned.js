// @ts-check

import { collisionInALine } from "../../../format/sentence.js";
import { typable } from "../../../format/number.js";
import { PIN_LETTERS } from "../../../state/pins.js";

/**
 * A collision that is pinned, and what the server said of it, once it did.
 * @typedef {object} Pinned
 * @property {number} index of its letter
 * @property {import("../../../state/parameters.js").Collision} collision
 * @property {import("../../../state/loading/collision-load.js").LoadedCollision | null} loaded
 */

/** None of them is a pattern that the pictures have already; in CSS pixels, long ones and gaps by turns. */
export const DASHES = ["13px,4px", "9px,3px,2px,3px", "9px,3px,2px,3px,2px,3px"];

/** @param {Pick<Pinned, "index">} pinned */
export const letterAt = ({ index }) => PIN_LETTERS[index];

/** With all digits. @param {import("../../../state/parameters.js").Collision} collision */
export const inALine = (collision) => collisionInALine(collision, typable);
