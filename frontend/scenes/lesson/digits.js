// @ts-check

import { ABSENT } from "../../format/number.js";
import { spokenLanguage } from "../../format/words.js";

/** Below this a reading is shown as 0. */
const ROUNDED_AWAY = 1e-12;

/**
 * A number as it is written in the language of the page, with a real minus sign.
 * @param {number | null} value
 */
export function inDigits(value) {
  if (value === null) {
    return ABSENT;
  }
  const digits = new Intl.NumberFormat(spokenLanguage(), {
    maximumSignificantDigits: 4,
    // 37.200 on its own might be 37.2.
    useGrouping: false,
  });
  return digits.format(Math.abs(value) < ROUNDED_AWAY ? 0 : value).replace("-", "\u2212");
}
