// @ts-check

import { say } from "../format/words.js";
import { takeLaterTexts } from "./texts.js";

/**
 * @typedef {import("../scenes/scene.js").Scene} Scene
 * @typedef {import("../scenes/scene.js").Page} Page
 */

/**
 * A scene whose code, styles and words come when it is first shown; what it has missed it is told then.
 * @param {string} id
 * @param {(state: import("../state/address/options.js").PageState) => boolean} isShown
 * @param {() => Promise<(page: Page) => Scene>} load gives what mounts it
 * @param {Page} page
 * @param {(scene: Scene) => void} onMounted
 * @returns {Scene}
 */
export function createDeferredScene(id, isShown, load, page, onMounted) {
  /** @type {Scene | null} */
  let scene = null;
  let isComing = false;
  /** @type {Parameters<NonNullable<Scene["offer"]>>[0] | null} */
  let presets = null;
  /** The answer about the present collision. @type {Parameters<NonNullable<Scene["settle"]>> | null} */
  let answer = null;

  async function open() {
    isComing = true;
    const focused = document.activeElement;
    const mount = await letCome(id, () => bring(id, load, page));
    isComing = false;
    // What is not to be seen loses the focus: the keyboard goes on where the shell had led it.
    if (document.activeElement === document.body && focused instanceof HTMLElement) {
      focused.focus({ preventScroll: true });
    }
    if (!mount) {
      return;
    }
    const state = page.present();
    const change = { dragging: false, inputTimeStamp: performance.now() };
    scene = mount(page);
    onMounted(scene);
    if (presets) {
      scene.offer?.(presets);
    }
    scene.show(state, null, change);
    scene.follow(state, null, change);
    if (answer) {
      scene.settle?.(...answer);
    }
  }

  /** @param {import("../state/address/options.js").PageState} state */
  function openIfShown(state) {
    if (isShown(state) && !isComing) {
      open();
    }
  }

  return {
    show(state, previous, change) {
      if (state.collision !== previous?.collision || state.accuracy !== previous.accuracy) {
        answer = null;
      }
      if (scene) {
        scene.show(state, previous, change);
      } else {
        openIfShown(state);
      }
    },

    follow: (state, previous, change) => scene?.follow(state, previous, change),

    settle(...next) {
      const isPresent = next[2];
      answer = isPresent ? next : answer;
      scene?.settle?.(...next);
    },

    decides: (state, previous) => scene?.decides?.(state, previous) ?? false,

    offer(all) {
      presets = all;
      scene?.offer?.(all);
    },

    forget() {
      if (scene) {
        scene.forget();
      } else {
        openIfShown(page.present());
      }
    },

    pictures: {},
  };
}

/**
 * Lets something come, which is seen to be under way.
 * @template Part
 * @param {string} id
 * @param {() => Promise<Part>} load
 * @returns {Promise<Part | null>} null where it does not arrive
 */
export async function letCome(id, load) {
  const root = document.documentElement;
  root.toggleAttribute(`data-${id}-coming`, true);
  try {
    return await load();
  } catch {
    return null;
  } finally {
    root.toggleAttribute(`data-${id}-coming`, false);
  }
}

/**
 * Lets a part of the page come, with its style sheets and the words that are not in the first view.
 * @template Part
 * @param {string} id
 * @param {() => Promise<Part>} load
 * @param {Pick<Page, "client" | "reportLost">} page
 * @returns {Promise<Part | null>} null where it did not arrive, which is told
 */
export async function bring(id, load, { client, reportLost }) {
  try {
    const parts = [load(), takeLaterTexts(client.words), ...stylesOf(id)];
    return (await Promise.all(/** @type {[Promise<Part>]} */ (parts)))[0];
  } catch {
    reportLost(say("server.partMissing"));
    return null;
  }
}

/**
 * Lets the style sheets of a scene come, which keep their place among the others.
 * @param {string} id
 */
function stylesOf(id) {
  const links = document.querySelectorAll(`link[data-comes-with="${id}"]`);
  return [.../** @type {NodeListOf<HTMLLinkElement>} */ (links)].map(
    (link) =>
      new Promise((resolve, reject) => {
        if (link.sheet) {
          resolve(null);
          return;
        }
        link.addEventListener("load", resolve, { once: true });
        link.addEventListener(
          "error",
          (event) => {
            // So that it is asked for again when the scene is.
            link.disabled = true;
            reject(event);
          },
          { once: true },
        );
        link.disabled = false;
      }),
  );
}
