// @ts-check

import { createClient, NeedsServer, Unreachable } from "./api/client.js";
import { say, spokenLanguage } from "./format/words.js";
import { mountCollision } from "./page/collision.js";
import { bring, createDeferredScene, letCome } from "./page/deferred-scene.js";
import { createExplanation } from "./page/explanation.js";
import { mountFace } from "./page/face.js";
import { mountFirstHint } from "./page/first-hint.js";
import { mountMessage } from "./page/messages.js";
import { mountPin } from "./page/pin.js";
import { mountShell } from "./page/shell.js";
import { contentsOfFile, takeLaterTexts, takeTexts } from "./page/texts.js";
import { mountUndo } from "./page/undo.js";
import { mountPictureMenu } from "./pictures/picture-menu.js";
import { mountSaveAll } from "./pictures/save-all.js";
import { mountExplorer } from "./scenes/explorer/scene.js";
import { accuracyOf, sameAccuracy, withAccuracy } from "./state/accuracy.js";
import { createAddressBar, presentSearch } from "./state/address/bar.js";
import { createCollisionLoad, serverAlone } from "./state/loading/collision-load.js";
import { createConnection } from "./state/loading/connection.js";
import { createLatest } from "./state/loading/latest.js";
import { showsSteps } from "./state/lesson.js";
import { sameCollision } from "./state/parameters.js";
import { embedded, isPresented, SCENES } from "./state/scenes.js";
import { createStore } from "./state/store.js";
import { readAddress } from "./state/address/reading.js";
import { byTestId, find } from "./widgets/find.js";
import { afterNextFrame, announcePainted } from "./widgets/painted.js";
import { mountSweepButtons } from "./widgets/sweep-buttons.js";

/**
 * @typedef {import("./state/address/options.js").PageState} PageState
 * @typedef {import("./state/store.js").Change} Change
 */

const contents = contentsOfFile();
/** What there is instead of a server. */
const file =
  contents && (await (await import("./page/one-file/open.js")).openFile(contents, presentSearch()));
takeTexts(file?.words);

const client = file?.client ?? createClient();
const { state: initialState, problems } = readAddress(presentSearch());
const store = createStore(initialState);
const banner = mountMessage(byTestId("banner"));
const notice = mountMessage(byTestId("notice"));
const addressBar = createAddressBar((state, wrong) => {
  store.set(state, { fromAddress: true });
  reportAddressProblems(wrong);
});
const connection = createConnection({
  isAnswering,
  onLost(reason) {
    const isAlone = source.isNear(false);
    banner.say(say(isAlone ? "server.lostForMost" : "server.lost", { reason }));
    if (isAlone) {
      nearScenes.forEach((scene) => scene.forget());
      followNearby(store.get(), null, changeNow());
    }
  },
  onRecovered: () => {
    banner.clear();
    loadAll();
  },
});
const source = file?.source ?? serverAlone(client);
const explainBy = createExplanation(connection.reportLost);
/** What a frame lets through of a change. @type {typeof import("./page/embedding/frame.js").unlocked} */
let unlocked = (patch) => patch;
const setters = {
  present: store.get,
  /** @type {import("./scenes/scene.js").Page["set"]} */
  set: (patch, change) => store.set(unlocked(patch, store.get(), change), change),
  /** @type {import("./scenes/scene.js").Page["setCollision"]} */
  setCollision: (patch, change) =>
    setters.set({ collision: { ...store.get().collision, ...patch } }, change),
  /** @type {import("./scenes/scene.js").Page["setAccuracy"]} */
  setAccuracy: (patch, change) => store.set(withAccuracy(store.get(), patch), change),
};
const shell = mountShell({ present: store.get, onOption: store.set });
const collision = mountCollision(setters, file ? "oneFile.needed" : "accuracy.away");
const face = mountFace(store.set);
const undo = mountUndo({ present: store.get, set: store.set });
const firstHint = mountFirstHint();

/** @type {import("./scenes/scene.js").Page} */
const page = {
  ...setters,
  client,
  source,
  preview: collision.preview,
  say: notice.say,
  explainBy,
  explain: explainBy(notice.say),
  reportLost(reason) {
    if (connection.isLost()) {
      notice.say(reason);
    }
    connection.reportLost(reason);
  },
};
mountPin(page);
const takePresses = mountSweepButtons(store.set);
const explorer = mountExplorer(page);
/** What is not in the first view. @type {[string, (state: PageState) => boolean, Parameters<typeof createDeferredScene>[2]][]} */
const DEFERRED = [
  [
    "frame",
    ({ embed }) => embed !== "none",
    async () => {
      const frame = await import("./page/embedding/frame.js");
      unlocked = frame.unlocked;
      return frame.mountFrame;
    },
  ],
  [
    "compare",
    (state) =>
      state.scene === "explorer" && (state.pins.length > 0 || embedded(state).includes("compare")),
    async () => {
      const { mountCompare } = await import("./scenes/explorer/compare/scene.js");
      return (its) => mountCompare(its, explorer.showGhosts);
    },
  ],
  [
    "spheres",
    isScene("spheres"),
    async () => (await import("./scenes/spheres/scene.js")).mountSpheres,
  ],
  ["accuracy", showsSteps, async () => (await import("./scenes/accuracy/scene.js")).mountAccuracy],
  ["paper", isScene("paper"), async () => (await import("./scenes/paper/scene.js")).mountPaper],
  ["lesson", isScene("lesson"), async () => (await import("./scenes/lesson/scene.js")).mountLesson],
  [
    "presenting",
    isPresented,
    async () => (await import("./page/presenting/presenting.js")).mountPresenting,
  ],
  [
    "sweeping",
    ({ sweep }) => sweep !== null,
    async () => {
      const [{ mountSweeping }, { createTrails }] = await Promise.all([
        import("./page/sweeping/sweeping.js"),
        import("./scenes/explorer/trails.js"),
      ]);
      return (its) => mountSweeping(its, takePresses, createTrails(explorer.showTrails));
    },
  ],
];
/** @type {import("./pictures/picture-menu.js").Load} */
const load = {
  file: client.file,
  font: client.font,
  explain: page.explain,
  server: file?.server ?? "",
  reportLost: connection.reportLost,
};
/** @type {import("./pictures/panel-picture.js").PanelPicture[]} */
const panels = [];
const deferred = DEFERRED.map(([id, isShown, its]) =>
  createDeferredScene(id, isShown, file?.standIns[id] ?? its, page, mountMenus),
);
const scenes = [explorer, ...deferred];
/** Those that the kernel in the page can do for. */
const nearScenes = [explorer, ...deferred.filter((_, i) => DEFERRED[i][0] === "compare")];
[collision, explorer].forEach(mountMenus);
byTestId("embed").addEventListener("click", () => openBuilder());
mountSaveAll(panels, store.get, {
  ...load,
  words: () => takeLaterTexts(client.words),
  say: notice.say,
});

const collisions = createLatest({
  load: createCollisionLoad(source),
  onAnswer: settle,
  onError: page.explain,
  isUrgent: ({ change }) => change.dragging && source.isNear(true),
});
/** How often the kernel may be asked for; in one file it is there from the start. */
let triesOfKernel = file ? 0 : 3;
let arePresetsHere = false;
/** Whether the language becomes again what it was. */
let isTakenBack = false;

store.subscribe((state, previous, change) => {
  // Not under a hand that drags: the pictures below would move.
  if (!change.dragging) {
    notice.clear();
  }
  if (state.lang !== previous.lang && state.lang !== spokenLanguage() && !isTakenBack) {
    speak(previous.lang);
  }
  show(state, previous, change);
  if (!change.fromAddress) {
    addressBar.follow(state, change);
  }
  undo.follow(state, change);
  if (!connection.isLost()) {
    follow(state, previous, change);
    return;
  }
  if (source.isNear(false)) {
    followNearby(state, previous, change);
  }
  if (!change.dragging) {
    banner.remind();
  }
});

addressBar.correct(initialState);
show(initialState, null, changeNow());
loadAll();
reportAddressProblems(problems);

/** @param {Pick<import("./scenes/scene.js").Scene, "pictures">} scene */
function mountMenus({ pictures }) {
  for (const [name, picture] of Object.entries(pictures)) {
    panels.push(mountPictureMenu(find(`[data-panel="${name}"]`), picture, openBuilder, load));
  }
}

/** Shows how the page stands in the frame of another one. @param {string} [panel] that is wanted there */
async function openBuilder(panel) {
  if (file) {
    page.explain(new NeedsServer());
    return;
  }
  const builder = await bring("embedding", () => import("./page/embedding/builder.js"), page);
  builder?.openBuilder(store.get(), panel);
}

/** @param {string} id @returns {(state: PageState) => boolean} */
function isScene(id) {
  return ({ scene }) => scene === id;
}

/** @returns {Change} */
function changeNow() {
  return { dragging: false, inputTimeStamp: performance.now() };
}

/**
 * What is known without asking anyone.
 * @param {PageState} state
 * @param {PageState | null} previous
 * @param {Change} change
 */
function show(state, previous, change) {
  shell.show(state);
  face.show(state);
  firstHint.show(state);
  collision.show(state, previous);
  scenes.forEach((scene) => scene.show(state, previous, change));
}

/**
 * Asks for the collision first, then for what the scene shows besides.
 * @param {PageState} state
 * @param {PageState | null} previous
 * @param {Change} change
 */
function follow(state, previous, change) {
  if (!previous || !scenes.some((scene) => scene.decides?.(state, previous))) {
    request(state, change);
  }
  scenes.forEach((scene) => scene.follow(state, previous, change));
}

/**
 * The same while the server is away, of what the kernel in the page knows.
 * @param {PageState} state
 * @param {PageState | null} previous
 * @param {Change} change
 */
function followNearby(state, previous, change) {
  // the collision of an impact is not known without a server
  if (isPicturedIn(state)) {
    request(state, change);
  }
  nearScenes.forEach((scene) => scene.follow(state, previous, change));
}

/**
 * @param {PageState} state
 * @param {Change} change
 */
function request(state, change) {
  collisions.request({
    collision: state.collision,
    accuracy: accuracyOf(state),
    change,
    isPictured: isPicturedIn(state),
  });
}

/** @param {PageState} state */
function isPicturedIn({ scene }) {
  return SCENES.some(({ id, hasTrace }) => hasTrace && id === scene);
}

/** @type {Parameters<typeof createLatest<import("./state/loading/collision-load.js").CollisionWish, import("./state/loading/collision-load.js").LoadedCollision>>[0]["onAnswer"]} */
function settle(answer, wish) {
  const now = store.get();
  const isPresent =
    sameCollision(wish.collision, now.collision) && sameAccuracy(wish.accuracy, accuracyOf(now));
  collision.settle(answer, wish, isPresent);
  if (triesOfKernel > 0) {
    // not before there is a picture to look at
    triesOfKernel -= 1;
    afterNextFrame(bringKernel);
  }
  if (!wish.isPictured) {
    afterNextFrame(() => announcePainted("result", wish.change.inputTimeStamp));
  }
  scenes.forEach((scene) => scene.settle?.(answer, wish, isPresent));
}

/** A browser that refuses the kernel, or a proxy whose policy does, leaves the page as it is without. */
async function bringKernel() {
  const found = await letCome("kernel", async () => {
    const { sourceWithKernel } = await import("./page/kernel.js");
    return sourceWithKernel(client, {
      isAway: connection.isLost,
      // eslint-disable-next-line no-console -- for whoever looks into it; a reader could do nothing
      onFault: (...what) => console.warn("the kernel in the page", ...what),
    });
  });
  if (found) {
    triesOfKernel = 0;
    Object.assign(source, found);
  }
}

function loadAll() {
  scenes.forEach((scene) => scene.forget());
  follow(store.get(), null, changeNow());
  loadPresets();
}

/**
 * Opens the page anew, in the language that its address names by now; without a server all stays as it is.
 * @param {PageState["lang"]} before
 */
async function speak(before) {
  if (await isAnswering()) {
    location.reload();
    return;
  }
  page.reportLost(say("server.silent"));
  isTakenBack = true;
  store.set({ lang: before });
  isTakenBack = false;
}

async function loadPresets() {
  if (arePresetsHere) {
    return;
  }
  try {
    const presets = await client.presets();
    arePresetsHere = true;
    [collision, ...scenes].forEach(({ offer }) => offer?.(presets));
  } catch (error) {
    page.explain(error);
  }
}

/** Whether the server computes again: one that is merely there may still be too busy. */
async function isAnswering() {
  try {
    await client.isAnswering(store.get().collision);
    return true;
  } catch (error) {
    return !(error instanceof Unreachable);
  }
}

/** @param {string[]} wrong */
function reportAddressProblems(wrong) {
  if (wrong.length > 0) {
    notice.say(say("address.problems", { problems: wrong.join("; ") }));
  }
}
