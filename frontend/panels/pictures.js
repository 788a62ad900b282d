// @ts-check

import { forceTable, mapTable, resultTable, velocityTable } from "../figures/tables.js";
import { FULL_MAP } from "../state/map-loader.js";
import { mapView, placeOnMap } from "../state/map-view.js";
import { find } from "./find.js";
import { mountPictureMenu } from "./picture-menu.js";

/**
 * What the panels show at the moment.
 * @typedef {object} Shown
 * @property {import("../api/client.js").CollisionAnswer | null} result
 * @property {import("../api/client.js").Trace | null} trace
 * @property {{grid: import("../api/client.js").MapGrid, view: import("../state/map-view.js").MapView} | null} map
 */

/** @typedef {import("../state/parameters.js").Collision} Collision */

/**
 * Gives every picture of the page its menu.
 * @param {object} page
 * @param {() => import("../state/url.js").PageState} page.present
 * @param {() => Shown} page.shown
 * @param {object} page.queries what the server is asked for each picture
 * @param {(collision: Collision) => Record<string, string>} page.queries.collision
 * @param {(collision: Collision) => Record<string, string>} page.queries.trace
 * @param {(muOverAlpha: number, view: import("../state/map-view.js").MapView, counts: typeof FULL_MAP) => Record<string, string>} page.queries.map
 */
export function mountPictures({ present, shown, queries }) {
  const parameters = () => ({ ...present().collision });
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
    map: {
      title: "Map",
      subject: () => present().map,
      request() {
        const { collision, scale } = present();
        const view = shown().map?.view ?? mapView(collision, scale);
        return { call: "map", query: queries.map(collision.mu_over_alpha, view, FULL_MAP) };
      },
      parameters,
      table: () =>
        made(shown().map, ({ grid }) =>
          mapTable({ grid, quantity: present().map }, present().collision),
        ),
      place: () =>
        made(shown().map, ({ view }) => {
          const { x, y } = placeOnMap(view, present().collision);
          return { x, y: 1 - y };
        }),
    },
  };
  for (const [name, picture] of Object.entries(pictures)) {
    mountPictureMenu(find(`[data-panel="${name}"]`), picture, present);
  }
}

/**
 * What is made of something, if it is there.
 * @template Thing, Made
 * @param {Thing | null} thing
 * @param {(thing: Thing) => Made} make
 */
function made(thing, make) {
  return thing === null ? null : make(thing);
}
