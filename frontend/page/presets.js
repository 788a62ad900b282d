// @ts-check

import { say } from "../format/words.js";
import { sameCollision } from "../state/parameters.js";
import { letterOf, textsOf } from "../state/presets.js";
import { isAt } from "../state/address/writing.js";
import { markLanguage } from "../widgets/elements.js";
import { byTestId } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/**
 * @typedef {import("../api/answers.js").Preset} Preset
 * @typedef {{preset: Preset, texts: ReturnType<typeof textsOf>, button: HTMLButtonElement}} Choice
 */

/**
 * The presets, figures of the paper among them: the letters of Fig. 5 in a row of their own, the others as they come.
 * @param {HTMLElement} element
 * @param {(preset: Preset, inputTimeStamp: number) => void} onChoose
 */
export function mountPresets(element, onChoose) {
  /** @type {Choice[]} */
  let choices = [];
  /** @type {import("../state/address/options.js").PageState | null} */
  let present = null;
  const rows = document.createElement("div");
  rows.className = "preset-rows";
  const source = document.createElement("p");
  source.className = "preset-source";
  element.append(rows, source);

  function mark() {
    /** @type {Choice | null} */
    let chosen = null;
    for (const each of choices) {
      const { preset, button } = each;
      const isChosen = present !== null && sameCollision(preset, present.collision);
      chosen = isChosen ? each : chosen;
      // This runs at every step of a drag, where most steps change nothing here.
      if (button.ariaPressed !== String(isChosen)) {
        button.ariaPressed = String(isChosen);
      }
    }
    // What a figure shows is said where it is shown, with its axes.
    if (chosen && present) {
      const { title, caption, source: work } = chosen.texts;
      const isHere = caption && isAt(present, chosen.preset.link);
      tell(source, say("presets.told", { title, text: isHere ? caption : work }), chosen);
    } else {
      typeset(source, "");
    }
    markSpheres();
  }

  /** Figures of real spheres have their velocities for parameters, and their own place. */
  function markSpheres() {
    const state = present;
    const found =
      state?.scene === "spheres"
        ? choices.find(({ preset }) => preset.caption && isAt(state, preset.link))
        : undefined;
    const place = byTestId("figure-caption");
    if (found) {
      tell(place, `${found.texts.title}. ${found.texts.caption}`, found);
    } else {
      typeset(place, "");
    }
  }

  /** @param {Preset} preset */
  function choice(preset) {
    const button = document.createElement("button");
    const letter = letterOf(preset);
    const texts = textsOf(preset);
    const { title, language } = texts;
    button.type = "button";
    button.className = letter ? "chip letter" : "chip";
    button.dataset.preset = preset.id;
    markLanguage(button, language);
    button.textContent = letter ?? title.split(" · ")[0];
    if (letter) {
      button.setAttribute("aria-label", title);
    }
    button.title = title;
    button.addEventListener("click", (event) => onChoose(preset, event.timeStamp));
    choices.push({ preset, texts, button });
    return button;
  }

  return {
    /** @param {Preset[]} presets */
    offer(presets) {
      choices = [];
      const lettered = presets.filter(letterOf);
      const others = presets.filter((preset) => !letterOf(preset));
      const letters = row(say("presets.letters"), lettered.map(choice));
      letters.classList.add("letters");
      const name = document.createElement("span");
      name.className = "row-name";
      name.textContent = say("presets.figure5");
      letters.prepend(name);
      rows.replaceChildren(row(say("presets.title"), others.map(choice)), letters);
      letters.hidden = lettered.length === 0;
      mark();
    },

    /** @param {import("../state/address/options.js").PageState} state */
    show(state) {
      present = state;
      mark();
    },
  };
}

/**
 * @param {HTMLElement} element
 * @param {string} text
 * @param {Choice} choice whose words it has
 */
function tell(element, text, { texts }) {
  markLanguage(element, texts.language);
  typeset(element, text);
}

/**
 * @param {string} label
 * @param {HTMLElement[]} buttons
 */
function row(label, buttons) {
  const group = document.createElement("div");
  group.className = "chips";
  group.setAttribute("role", "group");
  group.setAttribute("aria-label", label);
  group.append(...buttons);
  return group;
}
