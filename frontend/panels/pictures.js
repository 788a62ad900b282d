// @ts-check

import {
  contactTable,
  cutTable,
  forceTable,
  errorTable,
  mapTable,
  resultTable,
  sphereCutTable,
  steppedTable,
  velocityMapTable,
  velocityTable,
} from "../figures/tables.js";
import { collapseTable, stiffLawTable, switchLawTable } from "../figures/law-tables.js";
import { tradeoffTable } from "../figures/tradeoff-table.js";
import { significant } from "../format/number.js";
import { accuracyQuery, failingOf, inSteps } from "../state/accuracy.js";
import { FULL_CUT } from "../state/cut-loader.js";
import { FULL_MAP } from "../state/map-loader.js";
import { axesMuOverAlpha, heightOf, mapView, placeOnMap } from "../state/map-view.js";
import { find } from "./find.js";
import { mountPictureMenu } from "./picture-menu.js";

/**
 * What the panels show at the moment.
 * @typedef {object} Shown
 * @property {import("../api/answers.js").CollisionAnswer | null} result
 * @property {import("../api/answers.js").Trace | null} trace
 * @property {{grid: import("../api/answers.js").MapGrid, view: import("../state/map-view.js").MapView} | null} map
 * @property {import("../api/answers.js").Tradeoff | null} tradeoff
 * @property {import("../figures/collapse-figure.js").FrictionCurve[] | null} collapse
 * @property {import("../figures/stiff-law-figure.js").StiffCut[] | null} stiffLaw
 * @property {import("../figures/switch-law-figure.js").SwitchLaw | null} switchLaw
 * @property {{errors: Float64Array[], wish: import("../state/error-map-loader.js").ErrorMapWish} | null} errors
 * @property {import("../api/answers.js").Stepped | null} stepped
 * @property {import("../api/answers.js").Scaling | null} scaling
 * @property {import("../api/answers.js").VelocityMap | null} velocities
 * @property {import("../api/answers.js").VelocityMap | null} sphereCut
 * @property {{grid: import("../api/answers.js").MapGrid, view: import("../state/map-view.js").MapView} | null} place
 * @property {{cut: import("../api/answers.js").Cut, kappa: number, view: import("../state/map-view.js").MapView} | null} cut
 */

/** @typedef {import("../state/parameters.js").Collision} Collision */

/**
 * Gives every picture of the page its menu.
 * @param {object} page
 * @param {() => import("../state/url.js").PageState} page.present
 * @param {() => Shown} page.shown
 * @param {import("./picture-menu.js").Load} page.load
 * @param {() => Record<"scaling" | "map" | "cut", Record<string, any>>} page.bodies what is posted for the pictures of real spheres
 * @param {object} page.queries what the server is asked for each picture
 * @param {(collision: Collision) => Record<string, string>} page.queries.collision
 * @param {(collision: Collision) => Record<string, string>} page.queries.trace
 * @param {(muOverAlpha: number, view: import("../state/map-view.js").MapView, counts: typeof FULL_MAP) => Record<string, string>} page.queries.map
 * @param {(wish: import("../api/answers.js").CutWish) => Record<string, string>} page.queries.cut
 * @param {(wish: import("../state/error-map-loader.js").ErrorMapWish) => Record<string, string>} page.queries.errorMap
 * @param {(collision: Collision, accuracy: Record<string, string>) => Record<string, string>} page.queries.stepped
 * @param {() => Record<string, string>[]} page.queries.collapse
 * @param {() => Record<string, string>[]} page.queries.stiffLaw
 * @param {() => Record<string, string>} page.queries.switchLaw
 */
export function mountPictures({ present, shown, queries, bodies, load }) {
  const parameters = () => ({ ...present().collision });
  const impactParameters = () => ({ material: present().impact.material });
  const trace = () => ({ call: "trace", query: queries.trace(present().collision) });

  /** @type {Record<string, import("./picture-menu.js").Picture>} */
  const pictures = {
    result: {
      title: "Result",
      request: () => ({ call: "collision", query: queries.collision(present().collision) }),
      parameters,
      table: () => made(shown().result, resultTable),
    },
    force: {
      title: "Force",
      request: trace,
      parameters,
      table: () => made(shown().trace, forceTable),
    },
    velocity: {
      title: "Velocity",
      request: trace,
      parameters,
      table: () => made(shown().trace, velocityTable),
    },
    contact: {
      title: "Contact",
      request: trace,
      parameters,
      table: () => made(shown().trace, contactTable),
    },
    map: {
      title: "Map",
      subject: () => present().map,
      request() {
        const { collision } = present();
        const view = shown().map?.view ?? mapView(collision, present());
        const muOverAlpha = axesMuOverAlpha(view, collision);
        return { call: "map", query: queries.map(muOverAlpha, view, FULL_MAP) };
      },
      parameters,
      table: () =>
        made(shown().map, ({ grid, view }) =>
          mapTable({ grid, quantity: present().map }, rowsOf(view), present().collision),
        ),
      place: () =>
        made(shown().map, ({ view }) => {
          const { x, y } = placeOnMap(view, present().collision);
          return { x, y: 1 - y };
        }),
    },
    cut: {
      title: "Cut",
      request() {
        const { collision } = present();
        const view = shown().cut?.view ?? mapView(collision, present());
        const muOverAlpha = axesMuOverAlpha(view, collision);
        const wish = { kappa: collision.kappa, muOverAlpha, view, count: FULL_CUT };
        return { call: "cut", query: queries.cut(wish) };
      },
      parameters,
      table: () =>
        made(shown().cut, ({ cut, kappa, view }) => {
          const { along, here } = rowsOf(view);
          return cutTable(cut, along, here, kappa);
        }),
    },
    tradeoff: {
      title: "Error against time",
      subject: () => present().region,
      request: () => ({ call: "tradeoff", query: { scene: present().region } }),
      parameters: () => ({}),
      table: () => made(shown().tradeoff, tradeoffTable),
    },
    error_map: {
      title: "Error",
      subject: () => failingOf(present().accuracy).method,
      request() {
        const { collision, accuracy } = present();
        const view = mapView(collision, present());
        const wish = shown().errors?.wish ?? {
          view,
          muOverAlpha: axesMuOverAlpha(view, collision),
          counts: FULL_MAP,
          accuracy: accuracyQuery(failingOf(accuracy)),
        };
        return { call: "map", query: queries.errorMap(wish) };
      },
      parameters,
      table: () =>
        made(shown().errors, ({ errors, wish }) =>
          errorTable(errors, wish.view, rowsOf(wish.view), present().collision),
        ),
    },
    overlay: {
      title: "Force in time steps",
      request() {
        const { collision, accuracy } = present();
        return {
          call: "trace",
          query: queries.stepped(collision, accuracyQuery(inSteps(accuracy))),
        };
      },
      parameters,
      table: () => made(shown().stepped, steppedTable),
    },
    velocities: {
      title: "ε_t over the velocities",
      request: () => ({ call: "scaling/map", query: {}, body: bodies().map }),
      parameters: impactParameters,
      table: () => made(shown().velocities, velocityMapTable),
    },
    sphere_cut: {
      title: "ε_t over the tangential velocity",
      request: () => ({ call: "scaling/map", query: {}, body: bodies().cut }),
      parameters: impactParameters,
      table: () => made(shown().sphereCut, sphereCutTable),
    },
    impact: {
      title: "Impact",
      request: () => ({ call: "scaling", query: {}, body: bodies().scaling }),
      parameters: impactParameters,
    },
    place: {
      title: "Place on the universal map",
      request() {
        const { collision } = present();
        const view = shown().place?.view ?? mapView(collision, PLACE_AXES);
        return { call: "map", query: queries.map(1, view, FULL_MAP) };
      },
      parameters,
      table: () =>
        made(shown().place, ({ grid, view }) =>
          mapTable({ grid, quantity: "epsilon_t" }, rowsOf(view), present().collision),
        ),
    },
    paper: {
      title: "The paper",
      request: () => ({ call: "paper", query: {} }),
      parameters: () => ({}),
    },
    collapse: {
      title: "Collapse onto two parameters",
      request: () => ({ call: "cut", query: queries.collapse()[0] }),
      parameters: () => ({}),
      table: () => made(shown().collapse, collapseTable),
    },
    stiff_law: {
      title: "The stiff limit",
      request: () => ({ call: "cut", query: queries.stiffLaw()[0] }),
      parameters: () => ({}),
      table: () => made(shown().stiffLaw, stiffLawTable),
    },
    switch_law: {
      title: "Largest number of switches",
      request: () => ({ call: "map", query: queries.switchLaw() }),
      parameters: () => ({}),
      table: () => made(shown().switchLaw, switchLawTable),
    },
    steps: {
      title: "Steps for an error",
      request() {
        const { collision, wanted_error: error } = present();
        return {
          call: "steps",
          query: { ...queries.collision({ ...collision, damping: 0 }), error },
        };
      },
      parameters,
    },
  };

  /** What the vertical axis of the map runs over. @param {import("../state/map-view.js").MapView} view */
  function rowsOf({ vertical }) {
    const { collision } = present();
    const here = heightOf(vertical, collision);
    return vertical === "psi"
      ? { along: "ψ", here, frame: "at any μ/α" }
      : { along: "g_t/g_n", here, frame: `at μ/α = ${significant(collision.mu_over_alpha)}` };
  }

  for (const [name, picture] of Object.entries(pictures)) {
    mountPictureMenu(find(`[data-panel="${name}"]`), picture, present, load);
  }
}

/** Those of the universal map. */
const PLACE_AXES = /** @type {const} */ ({ scale: "log", map_y: "psi" });

/**
 * What is made of something, if it is there.
 * @template Thing, Made
 * @param {Thing | null} thing
 * @param {(thing: Thing) => Made} make
 */
function made(thing, make) {
  return thing === null ? null : make(thing);
}
