// @ts-check

import { lostShare } from "../../../format/energy.js";
import { ABSENT, percentage, significant, typable } from "../../../format/number.js";
import { say } from "../../../format/words.js";
import { make, told } from "../../../widgets/elements.js";
import { write } from "../../../widgets/write.js";
import { inALine, letterAt } from "./pinned.js";

/**
 * @typedef {import("./pinned.js").Pinned} Pinned
 * @typedef {import("../../../api/answers.js").CollisionAnswer} CollisionAnswer
 * @typedef {import("../../../state/parameters.js").Collision} Collision
 * @typedef {{parameters: Collision, result: CollisionAnswer | null}} Compared
 */

/**
 * What is compared: a value, none where nothing is known of it, and how it is written.
 * @type {{heading: () => string, className?: string, of: (compared: Compared) => number | null | undefined, written: (value: number) => string, times?: number}[]}
 */
const QUANTITIES = [
  { heading: () => "ε_t", of: ({ result }) => result?.epsilon_t, written: significant },
  { heading: () => "κ", of: ({ parameters }) => parameters.kappa, written: typable },
  { heading: () => "μ/α", of: ({ parameters }) => parameters.mu_over_alpha, written: typable },
  { heading: () => "g_t/g_n", of: ({ parameters }) => parameters.gt_over_gn, written: typable },
  {
    heading: () => "η",
    className: "damping",
    of: ({ parameters }) => parameters.damping,
    written: typable,
  },
  {
    heading: () => say("symbols.switchesName"),
    of: ({ result }) => result?.switches,
    written: String,
  },
  {
    heading: () => say("symbols.turnsName"),
    of: ({ result }) => result?.reversals,
    written: String,
  },
  {
    heading: () => say("energy.lost"),
    of: ({ result }) => result && lostShare(result),
    written: percentage,
    times: 100,
  },
  {
    heading: () => say("result.contact"),
    of: ({ result }) => result?.contact_duration,
    written: significant,
  },
];

/**
 * What is pinned beside what is present, with what each differs by from that.
 * @param {object} handlers
 * @param {(collision: Collision) => void} handlers.onBack asked for a collision that is pinned
 * @param {(index: number) => void} handlers.onAway
 */
export function createTable({ onBack, onAway }) {
  const head = make("tr", "", told("th", "difference", say("compare.difference")));
  const body = make("tbody", "");
  const table = make("table", "", make("thead", "", head), body);
  const element = make("div", "compare-frame", table);
  element.tabIndex = 0;
  element.setAttribute("role", "group");
  element.setAttribute("aria-label", say("compare.title"));
  for (const { heading, className = "" } of QUANTITIES) {
    head.append(Object.assign(told("th", className, heading()), { scope: "col" }));
  }
  head.children[0].setAttribute("scope", "col");
  /** @type {{compared: Compared | null, values: Element[], differences: Element[]}[]} the first is of what is present */
  let rows = [];

  /** @param {HTMLElement} title @param {Compared | null} compared */
  function addRow(title, compared) {
    const heading = make("th", "", title);
    heading.scope = "row";
    const cells = QUANTITIES.map(({ className = "" }) =>
      make("td", className, make("span", ""), make("small", "")),
    );
    body.append(make("tr", "", heading, ...cells));
    rows.push({
      compared,
      values: cells.map((cell) => cell.children[0]),
      differences: cells.map((cell) => cell.children[1]),
    });
  }

  function fill() {
    const present = rows[0].compared;
    let isDamped = false;
    for (const [k, { compared, values, differences }] of rows.entries()) {
      isDamped ||= (compared?.parameters.damping ?? 0) > 0;
      for (const [i, { of, written, times = 1 }] of QUANTITIES.entries()) {
        const value = compared && of(compared);
        const [here, its] = [present && of(present), value];
        write(values[i], typeof its === "number" ? written(its) : ABSENT);
        write(differences[i], k === 0 ? "" : differenceInWords(its, here, times));
      }
    }
    table.toggleAttribute("data-damped", isDamped);
  }

  return {
    element,

    /** @param {Pinned[]} pinned */
    show(pinned) {
      const present = rows[0]?.compared ?? null;
      rows = [];
      body.replaceChildren();
      addRow(told("span", "", say("compare.present")), present);
      for (const pin of pinned) {
        const result = pin.loaded?.result ?? null;
        addRow(headOf(pin, { onBack, onAway }), { parameters: pin.collision, result });
      }
      fill();
    },

    /** What the server says of the present collision. @param {CollisionAnswer} result */
    tell(result) {
      if (rows[0]) {
        rows[0].compared = { parameters: result.parameters, result };
        fill();
      }
    },

    /** The same for a sheet. @returns {import("../../../figures/tables.js").Table} */
    rows() {
      const text = (/** @type {Element} */ place) => place.textContent ?? "";
      return {
        caption: say("compare.caption"),
        headings: ["", ...QUANTITIES.map(({ heading }) => heading())],
        rows: [...body.children].flatMap((row, k) => {
          const name = row.querySelector("[data-letter]")?.getAttribute("data-letter");
          const { values, differences } = rows[k];
          return [
            [name ?? say("compare.present"), ...values.map(text)],
            ...(name ? [[say("compare.less", { letter: name }), ...differences.map(text)]] : []),
          ];
        }),
        here: 0,
      };
    },
  };
}

/**
 * @param {Pinned} pin
 * @param {Parameters<typeof createTable>[0]} handlers
 */
function headOf(pin, { onBack, onAway }) {
  const letter = letterAt(pin);
  const key = make("span", `swatch pin-line pin-${letter}`);
  const back = make("button", "pin-back", key, letter);
  const away = make("button", "pin-away", "×");
  const spoken = { letter, collision: inALine(pin.collision) };
  back.type = away.type = "button";
  back.dataset.letter = letter;
  back.dataset.testid = `pin-${letter}`;
  back.setAttribute("aria-label", say("compare.back", spoken));
  back.title = say("compare.back", spoken);
  away.dataset.testid = `unpin-${letter}`;
  away.setAttribute("aria-label", say("compare.away", { letter }));
  away.title = say("compare.away", { letter });
  back.addEventListener("click", () => onBack(pin.collision));
  away.addEventListener("click", () => onAway(pin.index));
  return make("span", "pin-chip", back, away);
}

/**
 * @param {number | null | undefined} value
 * @param {number | null | undefined} present
 * @param {number} times for a share that is written in percent
 */
function differenceInWords(value, present, times) {
  if (typeof value !== "number" || typeof present !== "number") {
    return "";
  }
  const difference = times * (value - present);
  const digits = Number.isInteger(difference) ? String(Math.abs(difference)).length : 3;
  const sign = difference > 0 ? "+" : "";
  return value === present ? "=" : `${sign}${significant(difference, Math.min(3, digits))}`;
}
