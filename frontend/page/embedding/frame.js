// @ts-check

import { significant, typable } from "../../format/number.js";
import { collisionInALine } from "../../format/sentence.js";
import { embedded, offered } from "../../state/scenes.js";
import { writeAddress } from "../../state/address/writing.js";
import { setOrRemove } from "../../widgets/elements.js";
import { byTestId, find } from "../../widgets/find.js";
import { typeset } from "../../widgets/typeset.js";

/** @typedef {import("../../state/address/options.js").PageState} PageState */

/** Panels as high as their text; the others share what the frame has. */
const TEXTS = ["result", "compare", "paper"];

/** Values besides those of collision and impact. @type {(keyof PageState)[]} */
const SINGLE = ["alpha", "bounce", "spin_share"];

/** Each is told by the other. */
const TOLD_TWICE = ["normal_restitution", "dissipative_constant_s"];

/** What is dragged on a picture, and the values that it moves. @type {[string, (state: PageState) => string[]][]} */
const HANDLES = [
  ["crosshair", () => ["kappa", "gt_over_gn"]],
  ["error-crosshair", () => ["kappa", "gt_over_gn"]],
  ["cut-mark", ({ cut_x }) => [cut_x]],
  ["velocity-crosshair", () => ["normal_velocity_m_s", "tangential_velocity_m_s"]],
  // α is of the bodies, which are not to be changed.
  ["alpha-reset", () => []],
];

/**
 * The page cut down to some panels and sliders, for the frame of another page.
 * @param {Pick<import("../../scenes/scene.js").Page, "present">} page
 * @returns {import("../../scenes/scene.js").Scene}
 */
export function mountFrame({ present }) {
  const root = document.documentElement;
  const caption = byTestId("embed-caption");
  const fullPage = /** @type {HTMLAnchorElement} */ (byTestId("full-page"));
  let shown = "";

  // Only when it is about to be followed: it changes with every step of a drag.
  for (const kind of ["pointerenter", "focus"]) {
    fullPage.addEventListener(kind, leadOut);
  }
  // Who writes the frame asks, when it is there, how high it should be.
  addEventListener("message", async ({ data, source, ports: [port] }) => {
    if (source === parent && data === "restitution-size" && port) {
      // without it the frame has the usual size
      (await import("./size.js").catch(() => null))?.tellSize(port);
    }
  });
  parent.postMessage("restitution-frame", "*");

  function leadOut() {
    fullPage.href = writeAddress({ ...present(), embed: "none", sliders: "usual" });
  }

  return {
    /** @param {PageState} state */
    show(state) {
      const { scene, embed, sliders, cut_x } = state;
      const wanted = `${scene} ${embed} ${sliders} ${cut_x}`;
      if (wanted === shown) {
        return;
      }
      shown = wanted;
      const panels = embedded(state);
      const names = offered(state);
      const { one, two, wide } = layOut(panels);
      setOrRemove(root, "data-embed", panels.join(" "));
      root.toggleAttribute("data-locked", names !== null);
      root.style.setProperty("--rows", one);
      root.style.setProperty("--rows-of-two", two);
      for (const panel of /** @type {NodeListOf<HTMLElement>} */ (
        document.querySelectorAll("[data-panel]")
      )) {
        const name = panel.dataset.panel ?? "";
        placeAt(panel, panels.indexOf(name));
        panel.toggleAttribute("data-wide", wide.includes(name));
      }
      offer(state, names);
      // Found here, for a :has() in a style sheet is looked for at every text that Plotly measures.
      for (const group of document.querySelectorAll(".dashboard > *")) {
        const holds = group.querySelector("[data-embedded]") !== null;
        group.toggleAttribute("data-holds-embedded", holds);
      }
      leadOut();
    },

    follow() {},

    /** The line under the panels. */
    settle({ result: { parameters, epsilon_t: epsilon } }) {
      const line = `${collisionInALine(parameters, short)}: ε_t = ${significant(epsilon)}`;
      // The results beyond the paper are not of this collision.
      typeset(caption, root.dataset.shown === "paper" ? "" : line);
    },

    forget() {},
    pictures: {},
  };
}

/**
 * The sliders that a frame has, and on its pictures what moves the same values.
 * @param {PageState} state
 * @param {string[] | null} names null where nothing is locked
 */
function offer(state, names) {
  for (const controls of document.querySelectorAll(".controls")) {
    const rows = /** @type {HTMLElement[]} */ ([
      ...controls.querySelectorAll(":scope > .parameter"),
    ]);
    for (const row of rows) {
      const place = names?.indexOf((row.dataset.parameter ?? "").replaceAll("-", "_")) ?? 0;
      row.hidden = place < 0;
      row.style.order = String(place);
    }
    const isOwn = controls.getAttribute("data-scene")?.split(" ").includes(state.scene) ?? false;
    const isOffered = names?.some((name) => name !== "spin_share") ?? false;
    controls.toggleAttribute("data-embedded", isOwn && isOffered);
  }
  find(".spin-share").toggleAttribute("data-offered", names?.includes("spin_share") ?? false);
  for (const [id, moves] of HANDLES) {
    byTestId(id).inert = names !== null && !moves(state).some((name) => names.includes(name));
  }
}

/**
 * @param {HTMLElement} panel
 * @param {number} place among the panels of a frame; negative if it is not there
 */
function placeAt(panel, place) {
  panel.toggleAttribute("data-embedded", place >= 0);
  panel.style.order = place < 0 ? "" : String(place);
}

/** A parameter as it reads in a line: those of real spheres have all digits. @param {number} value */
function short(value) {
  return typable(Number(value.toPrecision(6)));
}

/**
 * How panels stand in one column and in two, where a picture without a neighbour takes both.
 * @param {string[]} panels in their order
 * @returns {{one: string, two: string, wide: string[]}} the rows of either, and what takes both columns
 */
export function layOut(panels) {
  const rows = panels.map((panel) => (TEXTS.includes(panel) ? "auto" : "minmax(min-content, 1fr)"));
  /** @type {string[]} */
  const two = [];
  /** @type {string[]} */
  const wide = [];
  for (let i = 0; i < panels.length; i++) {
    two.push(rows[i]);
    if (rows[i] === "auto" || rows[i + 1] !== rows[i]) {
      wide.push(panels[i]);
    } else {
      i++;
    }
  }
  return { one: rows.join(" "), two: two.join(" "), wide };
}

/**
 * What of a change a frame lets through: of the values those that its author offers, of the rest all.
 * What is worked out of them follows.
 * @param {Partial<PageState>} patch
 * @param {PageState} state
 * @param {Partial<import("../../state/store.js").Change>} [change]
 * @returns {Partial<PageState>}
 */
export function unlocked(patch, state, { isWorkedOut = false } = {}) {
  const names = offered(state);
  if (!names || isWorkedOut) {
    return patch;
  }
  const free = names.some((name) => TOLD_TWICE.includes(name)) ? [...names, ...TOLD_TWICE] : names;
  const isFree = (/** @type {[string, unknown]} */ [name]) => free.includes(name);
  /** @template {object} T @param {T} now @param {T} next @returns {T} */
  const merged = (now, next) => ({
    ...now,
    ...Object.fromEntries(Object.entries(next).filter(isFree)),
  });
  const { collision, impact, ...rest } = patch;
  const kept = Object.entries(rest).filter(
    (entry) => isFree(entry) || !SINGLE.includes(/** @type {keyof PageState} */ (entry[0])),
  );
  return {
    ...Object.fromEntries(kept),
    ...(collision && { collision: merged(state.collision, collision) }),
    ...(impact && { impact: merged(state.impact, impact) }),
  };
}
