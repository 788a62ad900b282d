// @ts-check

import { knownLanguages, say, spokenLanguage } from "../format/words.js";
import { settingOf } from "../state/lesson.js";
import { SCENES } from "../state/scenes.js";
import { linkTo } from "../state/address/bar.js";
import { writeAddress } from "../state/address/writing.js";
import { copyText } from "../widgets/copy.js";
import { setOrRemove } from "../widgets/elements.js";
import { byTestId, find } from "../widgets/find.js";

/** @typedef {import("../state/address/options.js").PageState} PageState */

/** So long, in ms, a button says that it has done its work. */
const SAID = 2000;
/** A window so high, in rem, has room for the symbols below the controls. */
const ROOM_FOR_SYMBOLS = 80;

/** Where the skip link leads in scenes without the usual controls. @type {Record<string, string>} */
const MAIN_PARTS = { spheres: "impact-controls", paper: "paper" };

/**
 * What is around the pictures: scenes, colours, and the link to share.
 * @param {object} handlers
 * @param {() => PageState} handlers.present
 * @param {(patch: Partial<PageState>) => void} handlers.onOption
 */
export function mountShell({ present, onOption }) {
  const root = document.documentElement;
  const theme = /** @type {HTMLSelectElement} */ (byTestId("theme"));
  const language = /** @type {HTMLSelectElement} */ (byTestId("language"));
  const share = byTestId("share");
  const scenes = byTestId("scenes");
  const skip = /** @type {HTMLAnchorElement} */ (find(".skip"));
  const usualName = share.textContent;
  const rem = Number.parseFloat(getComputedStyle(root).fontSize);
  // Open from the start where the page would else end above it.
  /** @type {HTMLDetailsElement} */ (byTestId("symbols")).open =
    matchMedia("(min-width: 75rem)").matches && innerHeight >= ROOM_FOR_SYMBOLS * rem;
  let shown = "";
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;

  const links = SCENES.map(({ id }) => {
    const link = document.createElement("a");
    link.textContent = say(`page.scenes.${id}`);
    link.addEventListener("click", (event) => {
      event.preventDefault();
      onOption({ scene: id, ...settingOf(id, present().step) });
    });
    return { id, link };
  });
  scenes.append(...links.map(({ link }) => link));
  scenes.hidden = SCENES.length < 2;

  theme.addEventListener("change", () => {
    onOption({ theme: /** @type {PageState["theme"]} */ (theme.value) });
  });
  language.append(...knownLanguages().map(languageOption));
  language.addEventListener("change", () => onOption({ lang: language.value }));
  share.addEventListener("click", async () => {
    const done = await copyText(linkTo(writeAddress(present())));
    share.textContent = say(done ? "page.copied" : "page.copyYourself");
    byTestId("said").textContent = done ? say("page.linkCopied") : "";
    clearTimeout(timer);
    timer = setTimeout(() => {
      share.textContent = usualName;
      byTestId("said").textContent = "";
    }, SAID);
  });
  byTestId("present").addEventListener("click", begin);
  addEventListener("keydown", ({ key, target, ctrlKey, metaKey, altKey }) => {
    const isTyped = /** @type {Element} */ (target).matches?.("input, select, textarea");
    if (key !== "p" || ctrlKey || metaKey || altKey || isTyped) {
      return;
    }
    if (present().presenting === "on") {
      onOption({ presenting: "off" });
    } else {
      begin();
    }
  });

  /** On a projector. A frame may be forbidden the whole screen, and presents in what it has. */
  function begin() {
    if (present().embed === "none") {
      root.requestFullscreen?.().catch(() => {});
      onOption({ presenting: "on", scene: present().scene === "lesson" ? "lesson" : "explorer" });
    }
  }

  return {
    /** @param {PageState} state */
    show(state) {
      const { scene } = state;
      const wanted = `${scene} ${state.theme} ${state.step} ${state.lang}`;
      if (wanted === shown) {
        return;
      }
      const focused = document.activeElement;
      shown = wanted;
      theme.value = state.theme;
      language.value = state.lang === "system" ? spokenLanguage() : state.lang;
      setOrRemove(root, "data-theme", state.theme, "system");
      root.dataset.shown = scene;
      for (const part of document.querySelectorAll("main [data-scene]")) {
        const own = part.getAttribute("data-scene")?.split(" ") ?? [];
        part.toggleAttribute("hidden", !own.includes(scene));
      }
      skip.href = `#${MAIN_PARTS[scene] ?? "controls"}`;
      for (const { id, link } of links) {
        link.href = writeAddress({ ...state, scene: id, ...settingOf(id, state.step) });
        setOrRemove(link, "aria-current", id === scene ? "page" : "");
      }
      // What led here may have gone with its scene: the keyboard goes on in this one.
      if (focused?.closest("[hidden]")) {
        find(skip.hash).focus({ preventScroll: true });
      }
    },
  };
}

/** @param {{id: string, name: string}} language */
function languageOption({ id, name }) {
  const option = new Option(name, id);
  option.lang = id;
  return option;
}
