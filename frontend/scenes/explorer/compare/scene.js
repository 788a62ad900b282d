// @ts-check

import { say } from "../../../format/words.js";
import { USUAL_ACCURACY } from "../../../state/accuracy.js";
import { createCollisionLoad } from "../../../state/loading/collision-load.js";
import { withoutPin, writePin, writePins } from "../../../state/pins.js";
import { make, told } from "../../../widgets/elements.js";
import { byTestId, find } from "../../../widgets/find.js";
import { NO_GHOSTS } from "../ghosts.js";
import { createGhosts } from "./ghosts.js";
import { inALine, letterAt } from "./pinned.js";
import { createTable } from "./table.js";

/**
 * @typedef {import("./pinned.js").Pinned} Pinned
 * @typedef {import("../../../state/loading/collision-load.js").LoadedCollision} LoadedCollision
 * @typedef {import("../../../state/address/options.js").PageState} PageState
 */

/** Pictures whose legend says which line is of which collision, where the table is not beside them. */
const KEYED = [".force", ".velocity"];

/** A collision that is pinned is no drag's: its answer is waited for. */
const UNENDING = new AbortController().signal;

/**
 * What is pinned: its lines and marks in the explorer's pictures, and the table of differences.
 * @param {import("../../scene.js").Page} page
 * @param {(ghosts: import("../ghosts.js").Ghosts) => void} showGhosts
 * @returns {import("../../scene.js").Scene}
 */
export function mountCompare({ source, present, set, setCollision, explain }, showGhosts) {
  const root = document.documentElement;
  const panel = byTestId("compare");
  const load = createCollisionLoad(source);
  const table = createTable({
    onBack: (collision) => setCollision(collision),
    onAway(index) {
      set({ pins: withoutPin(present().pins, index) });
      (panel.querySelector("button") ?? byTestId("pin")).focus();
    },
  });
  const nothing = told("p", "panel-note", say("compare.nothing"));
  const title = make("h2", "unseen", say("compare.title"));
  title.id = "compare-title";
  panel.setAttribute("aria-labelledby", title.id);
  panel.prepend(title, nothing, table.element);
  /** By what stands for them in an address: what the server said, null while it is asked and where it refused. @type {Map<string, LoadedCollision | null>} */
  const known = new Map();
  let shown = "";
  /** @type {PageState["pins"] | null} */
  let asked = null;

  /** @param {PageState} state */
  function pinnedOf({ scene, pins }) {
    return pins.flatMap((collision, index) =>
      collision && scene === "explorer"
        ? [{ index, collision, loaded: known.get(writePin(collision)) ?? null }]
        : [],
    );
  }

  function draw() {
    const pinned = pinnedOf(present());
    const isAny = pinned.length > 0;
    root.toggleAttribute("data-compared", isAny);
    nothing.hidden = isAny;
    table.element.hidden = !isAny;
    table.show(pinned);
    KEYED.forEach((picture) => drawKeys(find(`${picture} .legend`), pinned));
    showGhosts(isAny ? createGhosts(pinned) : NO_GHOSTS);
  }

  /** @param {PageState} state */
  async function ask(state) {
    if (state.pins === asked || state.scene !== "explorer") {
      return;
    }
    asked = state.pins;
    const pinned = pinnedOf(state);
    const missing = pinned.filter(({ collision }) => !known.has(writePin(collision)));
    const answers = missing.map(async ({ collision }) => {
      const key = writePin(collision);
      known.set(key, null);
      const change = { dragging: false, inputTimeStamp: 0 };
      const wish = { collision, accuracy: USUAL_ACCURACY, change, isPictured: true };
      known.set(key, await load(wish, UNENDING));
    });
    const failed = (await Promise.allSettled(answers)).find(({ status }) => status === "rejected");
    if (missing.length > 0) {
      draw();
    }
    if (failed) {
      explain(/** @type {PromiseRejectedResult} */ (failed).reason);
    }
  }

  return {
    show(state) {
      const wanted = `${state.scene} ${state.embed} ${writePins(state.pins)}`;
      if (wanted !== shown) {
        shown = wanted;
        draw();
      }
    },

    follow: ask,

    settle(answer, { change }, isPresent) {
      if (isPresent || change.dragging) {
        table.tell(answer.result);
      }
    },

    forget() {
      asked = null;
      for (const [key, loaded] of known) {
        if (!loaded) {
          known.delete(key);
        }
      }
    },

    pictures: {
      compare: {
        title: say("compare.title"),
        request: () => ({ call: "collisions", query: {}, body: bodyOf(present()) }),
        parameters: () => ({ ...present().collision }),
        table: () => table.rows(),
      },
    },
  };
}

/**
 * What `/collisions` is asked: the present one, then those that are pinned.
 * @param {PageState} state
 */
function bodyOf({ collision, pins }) {
  const all = [collision, ...pins.filter((pin) => pin !== null)];
  const column = (/** @type {keyof typeof collision} */ key) => all.map((each) => each[key]);
  const isDamped = all.some(({ damping }) => damping > 0);
  return {
    kappa: column("kappa"),
    mu_over_alpha: column("mu_over_alpha"),
    gt_over_gn: column("gt_over_gn"),
    ...(isDamped ? { damping: column("damping") } : {}),
  };
}

/**
 * @param {HTMLElement} legend
 * @param {Pinned[]} pinned
 */
function drawKeys(legend, pinned) {
  legend.querySelectorAll(".pin-key").forEach((key) => key.remove());
  for (const pin of pinned) {
    const letter = letterAt(pin);
    const swatch = make("span", `swatch pin-line pin-${letter}`);
    const values = told("span", "", `${letter}: ${inALine(pin.collision)}`);
    legend.append(make("li", "pin-key", swatch, values));
  }
}
