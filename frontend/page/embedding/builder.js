// @ts-check

import { typable } from "../../format/number.js";
import { SYMBOLS } from "../../format/symbols.js";
import { knownLanguages, say } from "../../format/words.js";
import { PANELS, slidersOf } from "../../state/scenes.js";
import { writeAddress } from "../../state/address/writing.js";
import { codeBlock } from "../../widgets/copy.js";
import { make, told } from "../../widgets/elements.js";
import { find } from "../../widgets/find.js";
import { createBoxes, createSelect, createSize } from "./fields.js";
import { framed, framedScene, frameText } from "./frame-text.js";
import { createPreview } from "./preview.js";

/** @typedef {import("../../state/address/options.js").PageState} PageState */

/** In pixels. */
const WIDTH = { least: 200, most: 4000, usual: 720 };
const HEIGHT = { least: 100, most: 9000, usual: 480 };

/** @type {ReturnType<typeof createBuilder> | null} */
let builder = null;

/**
 * Opens what writes the frame of another page; what was chosen there stays chosen.
 * @param {PageState} state with which the frame begins
 * @param {string} [panel] that is wanted in it, alone
 */
export function openBuilder(state, panel) {
  builder ??= createBuilder();
  builder.open(state, panel);
}

/** @returns {{open: (state: PageState, panel?: string) => void}} */
function createBuilder() {
  const choices = createChoices(update);
  const preview = createPreview({ onSize: update });
  const outcome = make("div", "builder-outcome", preview.element);
  const codes = ["frame", "address"].map((name) => {
    const place = make("div", "");
    place.dataset.testid = `embedding-${name}`;
    outcome.append(place);
    return createCode(place, say(`embedding.${name}`));
  });
  const file = told("a", "", say("embedding.oneFile"));
  file.href = "restitution.html";
  file.download = "";
  outcome.append(
    told("p", "panel-note", say("embedding.moodle")),
    make("p", "panel-note", say("embedding.offline"), " ", file),
  );
  const title = told("h2", "", say("embedding.title"));
  title.id = "embedding-title";
  const close = told("button", "quiet", say("sheet.close"));
  const dialog = make(
    "dialog",
    "sheet builder",
    make("div", "sheet-head", title, close),
    make("div", "sheet-body", choices.element, outcome),
  );
  dialog.dataset.testid = "builder";
  dialog.setAttribute("aria-labelledby", title.id);
  document.body.append(dialog);
  close.addEventListener("click", () => dialog.close());
  dialog.addEventListener("close", preview.end);
  /** @type {PageState} */
  let start;

  function update() {
    const chosen = choices.made();
    if (chosen.panels.length === 0) {
      return;
    }
    const address = new URL(writeAddress(framed(start, chosen)), location.href).href;
    const { height, names } = preview.load(address);
    choices.fit(height);
    const frame = {
      address,
      title: `Restitution · ${(names ?? chosen.panels.map(titleOf)).join(", ")}`,
      ...choices.size(),
    };
    preview.show(frame);
    codes.forEach((show, i) => show([frameText(frame), address][i]));
  }

  return {
    open(state, panel) {
      start = state;
      choices.offer(state, panel);
      dialog.showModal();
      update();
    },
  };
}

/**
 * What is chosen of a frame.
 * @param {() => void} onChange
 */
function createChoices(onChange) {
  const panels = createBoxes(say("embedding.pictures"));
  const problem = make("p", "parameter-problem");
  const sliders = createBoxes(say("embedding.sliders"));
  const reader = /** @type {[string, string]} */ (["system", say("embedding.reader")]);
  const lang = createSelect(say("embedding.language"), [
    reader,
    ...knownLanguages().map(({ id, name }) => /** @type {[string, string]} */ ([id, name])),
  ]);
  const theme = createSelect(say("embedding.theme"), [
    reader,
    ["light", say("page.theme.light")],
    ["dark", say("page.theme.dark")],
  ]);
  const width = createSize(say("embedding.width"), WIDTH);
  const height = createSize(say("embedding.height"), HEIGHT);
  const fit = make("button", "parameter-reset");
  let isOwnHeight = false;
  let isFirst = true;
  fit.type = "button";
  fit.title = say("embedding.fit");
  fit.setAttribute("aria-label", fit.title);
  problem.setAttribute("role", "alert");
  const element = make(
    "form",
    "builder-choices",
    told("p", "panel-note", say("embedding.intro")),
    panels.element,
    problem,
    sliders.element,
    told("p", "panel-note", say("embedding.locked")),
    make("div", "builder-row", lang.label, theme.label),
    make("div", "builder-row", width.label, height.label, fit),
  );
  element.addEventListener("submit", (event) => event.preventDefault());
  element.addEventListener("change", ({ target }) => {
    isOwnHeight ||= target === height.field;
    onChange();
  });
  fit.addEventListener("click", () => {
    isOwnHeight = false;
    height.field.focus();
    onChange();
  });

  return {
    element,

    /** @type {typeof openBuilder} */
    offer(state, panel) {
      const own = panelsOf(framedScene(state)).filter(
        (name) => name !== "compare" || name === panel || state.pins.length > 0,
      );
      panels.offer(own.map((value) => ({ value, label: [told("span", "", titleOf(value))] })));
      if (panel || panels.ticked().length === 0) {
        panels.tick([panel ?? own.find((name) => !["result", "compare"].includes(name)) ?? ""]);
      }
      sliders.offer(
        slidersOf(framedScene(state)).map((value) => ({ value, label: sliderName(value, state) })),
      );
      sliders.element.hidden = slidersOf(framedScene(state)).length === 0;
      // Language and colours are the page's own, until they are chosen here.
      if (isFirst) {
        lang.field.value = state.lang;
        theme.field.value = state.theme;
        isFirst = false;
      }
    },

    /** @returns {import("./frame-text.js").Choices} */
    made() {
      const chosen = panels.ticked();
      problem.textContent = chosen.length > 0 ? "" : say("embedding.pick");
      // What share of g_t is spin is set in the picture of the bounce.
      sliders.show("spin_share", chosen.includes("contact"));
      return {
        panels: chosen,
        sliders: sliders.ticked(),
        lang: lang.field.value,
        theme: /** @type {PageState["theme"]} */ (theme.field.value),
      };
    },

    /** The height that the panels take, unless another one is wanted. @param {number | null} best */
    fit(best) {
      if (best !== null && !isOwnHeight) {
        height.put(best);
      }
      fit.disabled = !isOwnHeight;
    },

    size: () => ({ width: width.value(), height: height.value() }),
  };
}

/**
 * A text to be copied, which changes.
 * @param {HTMLElement} place
 * @param {string} name
 */
function createCode(place, name) {
  let shown = "";
  return (/** @type {string} */ text) => {
    if (text !== shown) {
      const isFocused = place.contains(document.activeElement);
      shown = text;
      place.replaceChildren(codeBlock(name, text));
      if (isFocused) {
        place.querySelector("button")?.focus();
      }
    }
  };
}

/** The panels of a scene as they follow one another on the page. @param {string} scene */
function panelsOf(scene) {
  const own = /** @type {Record<string, string[]>} */ (PANELS)[scene];
  const all = /** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll("[data-panel]"));
  return [...all]
    .filter((panel) => panel.closest("[data-scene]")?.matches(`[data-scene~="${scene}"]`))
    .map(({ dataset }) => dataset.panel ?? "")
    .filter((name) => name === "result" || own.includes(name));
}

/** What a panel is called. @param {string} name */
function titleOf(name) {
  return find(`[data-panel="${name}"]`).dataset.title ?? "";
}

/**
 * A slider's symbol and name, and where it begins.
 * @param {string} key
 * @param {PageState} state
 */
function sliderName(key, { collision, impact, spin_share }) {
  const values = /** @type {Record<string, unknown>} */ ({ spin_share, ...impact, ...collision });
  /** @type {Record<string, string>} */
  const symbols = SYMBOLS;
  const name = key === "spin_share" ? say("bounce.share") : say(`parameters.${key}`);
  const symbol = make("span", "builder-symbol");
  symbol.innerHTML = symbols[key] ?? "";
  const value = values[key];
  return [
    symbol,
    told("span", "", name),
    make("span", "builder-value", typeof value === "number" ? typable(value) : ""),
  ];
}
