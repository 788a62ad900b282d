// @ts-check

import { createClient, createExplanation, Unreachable } from "./api/client.js";
import { createLaws } from "./api/laws.js";
import {
  collisionQuery,
  cutQuery,
  errorMapQuery,
  mapQuery,
  steppedQuery,
  traceQuery,
} from "./api/queries.js";
import { mostSwitches } from "./figures/map-figure.js";
import { mountAccuracyScene } from "./panels/accuracy-scene.js";
import { mountAccuracyControl } from "./panels/accuracy-control.js";
import { mountCut } from "./panels/cut.js";
import { mountEnergyToggle } from "./panels/energy-toggle.js";
import { mountContactAnimation } from "./panels/contact-animation.js";
import { find, byTestId } from "./panels/find.js";
import { mountLessonDoor } from "./panels/lesson-door.js";
import { mountMap } from "./panels/map.js";
import { mountMessage } from "./panels/messages.js";
import { afterNextFrame, announcePainted } from "./panels/painted.js";
import { mountPaperScene } from "./panels/paper-scene.js";
import { mountParameterControl } from "./panels/parameter-control.js";
import { mountPictures } from "./panels/pictures.js";
import { mountPresets } from "./panels/presets.js";
import { mountResultStrip } from "./panels/result-strip.js";
import { mountShell } from "./panels/shell.js";
import { mountSpheresScene } from "./panels/spheres-scene.js";
import { mountTimeCursor } from "./panels/time-cursor.js";
import { mountForceTrace, mountVelocity } from "./panels/trace-plots.js";
import { sameAccuracy } from "./state/accuracy.js";
import { createAddressBar } from "./state/address-bar.js";
import { createConnection } from "./state/connection.js";
import { createCollisionLoad } from "./state/collision-load.js";
import { createLatest } from "./state/latest.js";
import { createCutLoader, FULL_CUT } from "./state/cut-loader.js";
import { createMapLoader } from "./state/map-loader.js";
import { horizontalAxis, scaleFor } from "./state/map-view.js";
import { readMap } from "./state/map-reading.js";
import { PARAMETERS, sameCollision } from "./state/parameters.js";
import { WITH_MAP } from "./state/scenes.js";
import { createStore } from "./state/store.js";
import { readAddress, stateAt } from "./state/url.js";

/**
 * @typedef {import("./state/url.js").PageState} PageState
 * @typedef {import("./state/store.js").Change} Change
 * @typedef {import("./state/parameters.js").Collision} Collision
 */

const client = createClient();
const laws = createLaws(client.columns);
const { state: initialState, problems } = readAddress(location.search);
const store = createStore(initialState);
const addressBar = createAddressBar((state, wrong) => {
  store.set(state, { fromAddress: true });
  complain(wrong);
});

const banner = mountMessage(byTestId("banner"));
const notice = mountMessage(byTestId("notice"));
const explainBy = createExplanation((reason) => connection.reportLost(reason));
const explain = explainBy(notice.say);
const shell = mountShell({ present: store.get, onOption: (patch) => store.set(patch) });
const strip = mountResultStrip(byTestId("result"));
const accuracyControl = mountAccuracyControl(byTestId("accuracy"), (patch, change) => {
  store.set({ accuracy: { ...store.get().accuracy, ...patch } }, change);
});
const force = mountForceTrace(byTestId("force-trace"));
const velocity = mountVelocity(byTestId("velocity"));
const timeCursor = mountTimeCursor((share) => animation.point(share));
const animation = mountContactAnimation(find(".contact"), { onShare: timeCursor.follow });
const map = mountMap(find(".map-panel"), { onPlace: changeCollision, onOption: store.set });
const cut = mountCut(find(".cut-panel"), changeCollision);
const accuracyScene = mountAccuracyScene({
  load: client,
  onError: explain,
  onOption: (patch) => store.set(patch),
  onAccuracy: (patch) => store.set({ accuracy: { ...store.get().accuracy, ...patch } }),
  onPlace: changeCollision,
});
const spheresScene = mountSpheresScene({
  load: client,
  explainBy,
  onRefused(reason) {
    notice.say(reason);
    strip.preview(null);
  },
  onState: (patch, change) => store.set(patch, change),
});
const paperScene = mountPaperScene({
  load: { paper: client.paper, ...laws.load },
  onError: explain,
  onOption: (patch) => store.set(patch),
  onOpen(link) {
    store.set({ ...readAddress(link).state, theme: store.get().theme, lang: store.get().lang });
    scrollTo(0, 0);
  },
});
const lesson = mountLessonDoor({
  loadTexts: client.texts,
  onError: explain,
  onLost: (reason) => connection.reportLost(reason),
  onState: (patch) => store.set(patch),
});
const energyToggle = mountEnergyToggle(find(".velocity"), (energy) => store.set({ energy }));
const presets = mountPresets(byTestId("presets"), ({ link, alpha }, inputTimeStamp) => {
  const state = stateAt(store.get(), link);
  store.set({ ...state, alpha, scale: scaleFor(state.collision, state) }, { inputTimeStamp });
});
const controls = PARAMETERS.map((parameter) => ({
  ...parameter,
  ...mountParameterControl(find(".controls"), parameter, (value, change) =>
    changeCollision({ [parameter.key]: value ?? parameter.initial }, change),
  ),
}));

const collisions = createLatest({
  load: createCollisionLoad(client),
  onAnswer: showCollision,
  onError: explain,
});

const maps = createMapLoader({
  load: ({ muOverAlpha, view, counts }, signal) => client.map(muOverAlpha, view, counts, signal),
  onMap: (loaded) => {
    shownMap = loaded;
    drawMap();
    cut.colorUpTo(mostSwitches(loaded.grid));
  },
  onError: explain,
});

const cuts = createCutLoader({
  load: client.cut,
  onCut: (loaded, { count, ...wish }) => {
    shownCut = { cut: loaded, ...wish };
    cut.show(shownCut, count !== FULL_CUT);
    cut.point(store.get().collision);
  },
  onError: explainBy((reason) => cut.withhold(`No cut at this one: ${reason}`)),
});

/** @type {Parameters<Parameters<typeof createMapLoader<import("./api/answers.js").MapGrid>>[0]["onMap"]>[0] | null} */
let shownMap = null;
/** @type {import("./state/collision-load.js").LoadedCollision | null} */
let shownCollision = null;
/** @type {{cut: import("./api/answers.js").Cut, kappa: number, muOverAlpha: number, view: import("./state/map-view.js").MapView} | null} */
let shownCut = null;
let presetsAreHere = false;
let hasPlayed = false;

/** What changes the look of the map, but not what is asked for. @type {(keyof PageState)[]} */
const MAP_LOOKS = ["map", "map_x", "alpha", "shape"];

const connection = createConnection({
  isAnswering,
  onLost: (reason) => banner.say(`${reason}. The last picture stays; trying again …`),
  onRecovered: () => {
    banner.clear();
    loadAll();
  },
});

mountPictures({
  present: store.get,
  shown: () => ({
    result: shownCollision?.result ?? null,
    trace: shownCollision?.trace ?? null,
    map: shownMap,
    cut: shownCut,
    ...accuracyScene.shown(),
    ...spheresScene.shown(),
    ...paperScene.shown(),
  }),
  bodies: spheresScene.bodies,
  load: client,
  queries: {
    collision: collisionQuery,
    trace: traceQuery,
    map: mapQuery,
    cut: cutQuery,
    errorMap: errorMapQuery,
    stepped: steppedQuery,
    ...laws.queries,
  },
});

store.subscribe((state, previous, change) => {
  notice.clear();
  showState(state);
  if (!sameCollision(state.collision, previous.collision)) {
    animation.pause();
    preview(state.collision, change);
  }
  if (!change.fromAddress) {
    addressBar.follow(state, change.dragging);
  }
  if (MAP_LOOKS.some((key) => state[key] !== previous[key])) {
    drawMap();
  }
  if (!connection.isLost()) {
    spheresScene.follow(state, change);
    // The collision of another impact follows when it is worked out.
    if (state.scene !== "spheres" || state.impact === previous.impact) {
      ask(state, change);
    }
  }
});

addressBar.correct(initialState);
showState(initialState);
loadAll();
complain(problems);

/**
 * @param {Partial<Collision>} patch
 * @param {Partial<Change>} change
 */
function changeCollision(patch, change) {
  store.set({ collision: { ...store.get().collision, ...patch } }, change);
}

/** What is known without asking anyone. @param {PageState} state */
function showState(state) {
  shell.show(state);
  accuracyControl.show(state.accuracy);
  for (const { key, initial, show } of controls) {
    show(state.collision[key], initial);
  }
  map.point(state.collision);
  map.options(state);
  cut.point(state.collision);
  energyToggle.show(state.energy);
  velocity.showEnergy(state.energy === "shown");
  presets.show(state);
  lesson.follow(state);
}

function drawMap() {
  if (shownMap) {
    const { map: quantity, map_x, alpha, shape } = store.get();
    map.show(
      { ...shownMap, quantity, horizontal: horizontalAxis(shownMap.view, map_x, alpha) },
      shape,
    );
  }
}

/**
 * What the map on the page knows of it, in the next frame, whatever the server takes.
 * @param {Collision} collision
 * @param {Change} change
 */
function preview(collision, { inputTimeStamp }) {
  const reading = shownMap && readMap(shownMap, collision);
  strip.preview(reading);
  if (reading) {
    map.legend.point(reading);
  }
  afterNextFrame(() => {
    announcePainted("crosshair", inputTimeStamp);
    if (reading) {
      announcePainted("strip", inputTimeStamp);
    }
  });
}

function loadAll() {
  maps.forget();
  cuts.forget();
  accuracyScene.forget();
  spheresScene.forget();
  paperScene.forget();
  lesson.forget();
  const change = { dragging: false, inputTimeStamp: performance.now() };
  spheresScene.follow(store.get(), change);
  ask(store.get(), change);
  loadPresets();
}

/**
 * While dragging, map and cut are asked for only once the trace is on the screen.
 * @param {PageState} state
 * @param {Change} change
 */
function ask(state, change) {
  const { collision, accuracy, scene } = state;
  collisions.request({ collision, accuracy, change, isPictured: scene !== "spheres" });
  if (!change.dragging) {
    followRest(state, false);
  }
}

/**
 * What the scene shows besides the collision itself.
 * @param {PageState} state
 * @param {boolean} dragging
 */
function followRest(state, dragging) {
  if (WITH_MAP.includes(state.scene)) {
    maps.follow(state, dragging);
    cuts.follow(state, dragging);
  }
  // In the other scenes it learns that it is not shown.
  accuracyScene.follow(state, dragging);
  paperScene.follow(state);
}

/** Whether the server computes again: one that is merely there may still be too busy. */
async function isAnswering() {
  try {
    await client.collision(store.get().collision);
    return true;
  } catch (error) {
    return !(error instanceof Unreachable);
  }
}

async function loadPresets() {
  if (presetsAreHere) {
    return;
  }
  try {
    const items = await client.presets();
    presets.offer(items);
    cut.offer(items);
    presetsAreHere = true;
  } catch (error) {
    explain(error);
  }
}

/**
 * The strip and the force trace first; what can wait a frame, after them.
 * @param {import("./state/collision-load.js").LoadedCollision} answer
 * @param {import("./state/collision-load.js").CollisionWish} wish
 */
function showCollision(answer, { collision, accuracy, change, isPictured }) {
  shownCollision = answer;
  const { result, trace, reason, isOffered } = answer;
  const now = store.get();
  const isPresent = sameCollision(collision, now.collision) && sameAccuracy(accuracy, now.accuracy);
  strip.show(result, change.dragging, isPresent);
  accuracyControl.tell(isOffered ? "" : accuracy.method);
  if (isPresent) {
    map.settle(result, change.dragging);
    lesson.settle(answer, change.dragging);
  }
  cut.settle(result);
  shell.caption(result);
  let isLight = false;
  if (trace) {
    isLight = force.show(trace, change.dragging) && velocity.show(trace, true);
    timeCursor.show(trace);
  } else if (isPictured) {
    animation.withhold();
    force.withhold(`No picture of this one: ${reason}`);
    velocity.withhold("No picture of this one");
  }
  afterNextFrame(() => {
    announcePainted(isPictured ? "force-trace" : "result", change.inputTimeStamp);
    if (trace) {
      if (!isLight) {
        velocity.show(trace, change.dragging);
      }
      animation.show(trace);
    }
    accuracyScene.settle(trace);
    if (change.dragging) {
      followRest(store.get(), true);
    } else if (trace) {
      force.describe(trace);
      velocity.describe(trace);
      animation.describe();
      playOnce();
    }
  });
}

/** The first picture moves by itself, as soon as it is there. */
function playOnce() {
  if (!hasPlayed) {
    hasPlayed = true;
    animation.playGently();
  }
}

/** @param {string[]} wrong */
function complain(wrong) {
  if (wrong.length > 0) {
    notice.say(`In the address, ${wrong.join("; ")}. The usual value stands in.`);
  }
}
