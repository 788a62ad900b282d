// @ts-check

import { bounceQuery, cutQuery, mapQuery, traceQuery } from "../../api/queries.js";
import { say } from "../../format/words.js";
import { mostSwitches } from "../../figures/map-figure.js";
import { mapTable } from "../../figures/tables.js";
import { accuracyOf, sameAccuracy, USUAL_ACCURACY } from "../../state/accuracy.js";
import { createFollower } from "../../state/loading/follower.js";
import { horizontalAxis, placeOnMap, rowsOf } from "../../state/map-view.js";
import { BOUNCES, sameCollision, SPIN_SHARE } from "../../state/parameters.js";
import { picturesOf } from "../../state/scenes.js";
import { byTestId, find } from "../../widgets/find.js";
import { afterNextFrame, announcePainted } from "../../widgets/painted.js";
import { createBallLoad } from "../../state/loading/collision-load.js";
import { mountBounce } from "./bounce/bounce.js";
import { mountCut } from "./cut/cut.js";
import { mountEnergyToggle } from "./energy-toggle.js";
import { NO_GHOSTS, over } from "./ghosts.js";
import { readMap } from "./map-reading.js";
import { mountMap } from "./map.js";
import { bounceTable, cutTable, forceTable, velocityTable } from "./tables.js";
import { mountTimeCursor } from "./time-cursor.js";
import { mountForceTrace, mountVelocity } from "./trace-plots.js";
import {
  ballWish,
  isEnoughBall,
  cutWish,
  FULL_CUT,
  FULL_MAP,
  isEnoughCut,
  isEnoughMap,
  isQuickCut,
  isQuickMap,
  mapWish,
} from "./wishes.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../api/answers.js").Trace} Trace
 */

/** At most so often the server is asked for a map or a cut, in ms. */
const PAUSES = { map: 200, cut: 50 };

/** The share of a hand's time that the kernel in the page may take for one of them. */
const SHARE = 1 / 8;

/** What changes the look of the map, but not what is asked for. @type {(keyof PageState)[]} */
const MAP_LOOKS = ["map", "map_x", "alpha", "shape"];

/**
 * The scene "Explorer": force, velocity and contact over time, the map, and the cut through it.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene & Record<"showGhosts" | "showTrails", (ghosts: import("./ghosts.js").Ghosts) => void>}
 */
export function mountExplorer({ source, present, set, setCollision, preview, explain, explainBy }) {
  const force = mountForceTrace(byTestId("force-trace"));
  const velocity = mountVelocity(byTestId("velocity"));
  const timeCursor = mountTimeCursor((share) => bounce.point(share));
  const bounce = mountBounce(find(".bounce"), { onShare: timeCursor.follow, onOption: set });
  const energyToggle = mountEnergyToggle(find(".velocity"), (energy) => set({ energy }));
  const map = mountMap(find(".map-panel"), { onPlace: setCollision, onOption: set });
  const cut = mountCut(find(".cut-panel"), { onPlace: setCollision, onOption: set });
  /** @type {Trace | null} */
  let trace = null;
  /** @type {import("../../api/queries.js").MapWish & {grid: import("../../api/answers.js").MapGrid, most: number} | null} */
  let shownMap = null;
  /** @type {Parameters<typeof cut.show>[0] | null} */
  let shownCut = null;
  let hasPlayed = false;
  let ghosts = NO_GHOSTS;
  let trails = NO_GHOSTS;

  const maps = createFollower({
    load: (wish, signal) => source.of(isQuickMap(wish)).map(wish, signal),
    isUrgent: (wish) => isQuickMap(wish) && source.isNear(true),
    isEnough: isEnoughMap,
    onAnswer(grid, wish) {
      const isQuick = isQuickMap(wish);
      const most = mostSwitches(grid, isQuick ? shownMap?.most : 0);
      shownMap = { grid, most, ...wish };
      cut.colorUpTo(most, isQuick);
      if (isQuick) {
        // computed in one frame, drawn in another: a hand that drags waits for neither
        afterNextFrame(drawMap);
      } else {
        drawMap();
      }
    },
    onError: explain,
    pause: (took, wish) => pauseAfter(took, isQuickMap(wish), PAUSES.map),
  });

  const cuts = createFollower({
    load: (wish, signal) => source.of(isQuickCut(wish)).cut(wish, signal),
    isUrgent: (wish) => isQuickCut(wish) && source.isNear(true),
    isEnough: isEnoughCut,
    onAnswer(loaded, { count, ...wish }) {
      shownCut = { cut: loaded, ...wish };
      cut.show(shownCut, count !== FULL_CUT);
      cut.point(present().collision);
    },
    onError: explainBy(cut.showRefusal),
    pause: (took, wish) => pauseAfter(took, isQuickCut(wish), PAUSES.cut),
  });

  const balls = createFollower({
    load: createBallLoad(source),
    isUrgent: ({ dragging }) => dragging && source.isNear(true),
    isEnough: isEnoughBall,
    onAnswer: bounce.showBall,
    onError(error) {
      // Its factors hold for other collisions, too: the next one asks again.
      balls.forget();
      explain(error);
    },
  });

  /**
   * The least from the start of a map or a cut to that of the next one.
   * @param {number} took in ms, as what is returned
   * @param {boolean} isQuick
   * @param {number} ofServer
   */
  function pauseAfter(took, isQuick, ofServer) {
    return isQuick && source.isNear(true) ? took / SHARE : ofServer;
  }

  function drawMap() {
    if (shownMap) {
      const { map: quantity, map_x, alpha, shape } = present();
      map.show(
        { ...shownMap, quantity, horizontal: horizontalAxis(shownMap.view, map_x, alpha) },
        shape,
        isQuickMap(shownMap),
      );
    }
  }

  /**
   * What the map on the page knows of a collision, in the next frame, whatever the server takes.
   * @param {PageState} state
   * @param {number} inputTimeStamp
   */
  function read({ collision }, inputTimeStamp) {
    const reading = shownMap && readMap(shownMap, collision);
    preview(reading);
    if (reading) {
      map.legend.point(reading);
    }
    bounce.preview(reading && reading.epsilon_t);
    announceNext(reading ? ["crosshair", "strip"] : ["crosshair"], inputTimeStamp);
  }

  /** @param {string[]} views @param {number} inputTimeStamp */
  function announceNext(views, inputTimeStamp) {
    afterNextFrame(() => views.forEach((view) => announcePainted(view, inputTimeStamp)));
  }

  /**
   * @param {PageState} state
   * @param {boolean} dragging
   */
  function followMap(state, dragging) {
    const shown = picturesOf(state);
    if (shown.map) {
      maps.follow(mapWish(state, dragging, maps.asked()));
    }
    if (shown.cut) {
      cuts.follow(cutWish(state, dragging, cuts.asked()));
    }
    if (shown.contact) {
      balls.follow(ballWish(state, dragging));
    }
  }

  /** The first picture moves by itself, as soon as it is there. */
  function playOnce() {
    if (!hasPlayed) {
      hasPlayed = true;
      bounce.playGently();
    }
  }

  /**
   * The force first; what can wait a frame, after it, and while dragging, map and cut after that.
   * @param {Trace} next
   * @param {string} sentence about the collision
   * @param {import("../../state/store.js").Change} change
   */
  function showTrace(next, sentence, { dragging, inputTimeStamp }) {
    const isLight = force.show(next, dragging) && velocity.show(next, true);
    timeCursor.show(next);
    afterNextFrame(() => {
      announcePainted("force-trace", inputTimeStamp);
      if (!isLight) {
        velocity.show(next, dragging);
      }
      if (!dragging) {
        force.describe(next, sentence);
        velocity.describe(next);
        playOnce();
      }
    });
  }

  /** @param {string} reason */
  function showNoTrace(reason) {
    force.showReason(say("trace.noneFor", { reason }));
    velocity.showReason(say("trace.none"));
  }

  /** What lies behind the next pictures over time. */
  function lay() {
    const behind = over(trails, ghosts);
    force.showGhosts(behind);
    velocity.showGhosts(behind);
    timeCursor.reach(behind.duration);
  }

  const parameters = () => ({ ...present().collision });
  const request = () => ({ call: "trace", query: traceQuery(present().collision) });

  return {
    showGhosts(next) {
      ghosts = next;
      [map, cut].forEach((picture) => picture.showGhosts(next));
      lay();
      if (trace) {
        force.show(trace, false);
        velocity.show(trace, false);
      }
    },

    showTrails(next) {
      trails = next;
      lay();
    },

    show(state, previous, { dragging, inputTimeStamp }) {
      map.point(state.collision);
      map.options(state);
      cut.options(state);
      cut.point(state.collision);
      energyToggle.show(state.energy);
      bounce.show(state);
      velocity.showEnergy(state.energy === "shown");
      if (previous && !sameCollision(state.collision, previous.collision)) {
        const isAtOnce = source.isNear(dragging) && sameAccuracy(accuracyOf(state), USUAL_ACCURACY);
        if (isAtOnce) {
          announceNext(["crosshair", "strip"], inputTimeStamp);
        } else {
          read(state, inputTimeStamp);
        }
      }
      if (previous && MAP_LOOKS.some((key) => state[key] !== previous[key])) {
        drawMap();
      }
    },

    follow(state, previous, { dragging }) {
      if (!dragging) {
        followMap(state, false);
      }
    },

    settle(answer, { change, isPictured }, isPresent) {
      trace = answer.trace;
      if (isPresent) {
        map.settle(answer.result, change.dragging);
      }
      cut.settle(answer.result);
      bounce.settle(answer, isPresent);
      if (trace) {
        showTrace(trace, answer.sentence, change);
      } else if (isPictured) {
        showNoTrace(answer.reason);
        afterNextFrame(() => announcePainted("force-trace", change.inputTimeStamp));
      }
      if (change.dragging) {
        afterNextFrame(() => followMap(present(), true));
      }
    },

    offer(presets) {
      cut.offer(presets);
      map.offer(presets);
    },

    forget() {
      maps.forget();
      cuts.forget();
      balls.forget();
    },

    pictures: {
      force: {
        title: say("force.title"),
        request,
        parameters,
        table: () => trace && [forceTable(trace), ...ghosts.tables(forceTable)],
      },
      velocity: {
        title: say("velocity.title"),
        request,
        parameters,
        table: () => trace && [velocityTable(trace), ...ghosts.tables(velocityTable)],
      },
      contact: {
        title: say("bounce.title"),
        request: () => ({ call: "bounce", query: bounceQuery(ballWish(present(), false)) }),
        parameters() {
          const { bounce: off, spin_share } = present();
          return {
            ...parameters(),
            ...(off === BOUNCES[0].id ? {} : { bounce: off }),
            ...(spin_share === SPIN_SHARE.initial ? {} : { spin_share }),
          };
        },
        table: () => bounceTable(bounce.motions()),
      },
      map: {
        title: say("map.title"),
        subject: () => present().map,
        subjectTitle: () =>
          present().map === "switches" ? say("symbols.switchesName") : present().map,
        request() {
          const { view, muOverAlpha } = shownMap ?? mapWish(present(), false, null);
          return { call: "map", query: mapQuery({ view, muOverAlpha, counts: FULL_MAP }) };
        },
        parameters,
        table() {
          const { collision, map: quantity } = present();
          return (
            shownMap &&
            mapTable({ grid: shownMap.grid, quantity }, rowsOf(shownMap.view, collision), collision)
          );
        },
        place() {
          if (!shownMap) {
            return null;
          }
          const { x, y, beyond } = placeOnMap(shownMap.view, present().collision);
          return { x: beyond.x ? null : x, y: beyond.y ? null : 1 - y };
        },
      },
      cut: {
        title: say("cut.name"),
        request() {
          const wish = shownCut ?? cutWish(present(), false, null);
          return { call: "cut", query: cutQuery({ ...wish, count: FULL_CUT }) };
        },
        parameters,
        table() {
          if (!shownCut) {
            return null;
          }
          return cutTable(shownCut, present().collision);
        },
      },
    },
  };
}
