// @ts-check

import { sameCollision } from "../state/parameters.js";
import { letterOf } from "../state/presets.js";
import { isAt } from "../state/url.js";
import { byTestId } from "../widgets/find.js";
import { typeset } from "../widgets/typeset.js";

/** @typedef {import("../api/answers.js").Preset} Preset */

/**
 * The presets, figures of the paper among them: the letters of Fig. 5 in a row of their own, the others as they come.
 * @param {HTMLElement} element
 * @param {(preset: Preset, inputTimeStamp: number) => void} onChoose
 */
export function mountPresets(element, onChoose) {
  /** @type {{preset: Preset, button: HTMLButtonElement}[]} */
  let choices = [];
  /** @type {import("../state/url.js").PageState | null} */
  let present = null;
  const rows = document.createElement("div");
  rows.className = "preset-rows";
  const source = document.createElement("p");
  source.className = "preset-source";
  element.append(rows, source);

  function mark() {
    /** @type {Preset | null} */
    let chosen = null;
    for (const { preset, button } of choices) {
      const isChosen = present !== null && sameCollision(preset, present.collision);
      chosen = isChosen ? preset : chosen;
      // This runs at every step of a drag, where most steps change nothing here.
      if (button.ariaPressed !== String(isChosen)) {
        button.ariaPressed = String(isChosen);
      }
    }
    // What a figure shows is said where it is shown, with its axes.
    const caption = chosen && present && isAt(present, chosen.link) ? chosen.caption : "";
    typeset(source, chosen ? `${chosen.title}: ${caption || chosen.source}` : "");
    markSpheres();
  }

  /** Figures of real spheres have their velocities for parameters, and their own place. */
  function markSpheres() {
    const state = present;
    const found =
      state?.scene === "spheres"
        ? choices.find(({ preset }) => preset.caption && isAt(state, preset.link))
        : undefined;
    typeset(
      byTestId("figure-caption"),
      found ? `${found.preset.title}. ${found.preset.caption}` : "",
    );
  }

  /** @param {Preset} preset */
  function choice(preset) {
    const button = document.createElement("button");
    const letter = letterOf(preset);
    button.type = "button";
    button.className = letter ? "chip letter" : "chip";
    button.dataset.preset = preset.id;
    button.textContent = letter ?? preset.title.split(" · ")[0];
    if (letter) {
      button.setAttribute("aria-label", preset.title);
    }
    button.title = preset.title;
    button.addEventListener("click", (event) => onChoose(preset, event.timeStamp));
    choices.push({ preset, button });
    return button;
  }

  return {
    /** @param {Preset[]} presets */
    offer(presets) {
      choices = [];
      const lettered = presets.filter(letterOf);
      const others = presets.filter((preset) => !letterOf(preset));
      const letters = row("Fig. 5, a to o", lettered.map(choice));
      letters.classList.add("letters");
      const name = document.createElement("span");
      name.className = "row-name";
      name.textContent = "Fig. 5";
      letters.prepend(name);
      rows.replaceChildren(row("Presets", others.map(choice)), letters);
      letters.hidden = lettered.length === 0;
      mark();
    },

    /** @param {import("../state/url.js").PageState} state */
    show(state) {
      present = state;
      mark();
    },
  };
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
