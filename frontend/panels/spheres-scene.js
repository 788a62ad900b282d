// @ts-check

import { placeFigure } from "../figures/place-figure.js";
import { sphereCutFigure } from "../figures/sphere-cut-figure.js";
import { contactBody, impactOf, valuesOf, velocityView } from "../state/impact.js";
import { createLatest } from "../state/latest.js";
import { horizontalAxis, mapView, placeOnMap } from "../state/map-view.js";
import { byTestId, find } from "./find.js";
import { mountImpactControls } from "./impact-controls.js";
import { createImpactResult } from "./impact-result.js";
import { createPlot } from "./plot.js";
import { mountVelocities } from "./velocities.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/impact.js").Impact} Impact
 * @typedef {import("../state/impact.js").Material} Material
 * @typedef {import("../api/client.js").Scaling} Scaling
 * @typedef {import("../api/client.js").VelocityMap} VelocityMap
 * @typedef {import("../api/client.js").MapGrid} MapGrid
 * @typedef {import("../state/map-view.js").MapView} MapView
 * @typedef {{map: VelocityMap, view: ReturnType<typeof velocityView>}} ShownVelocities
 * @typedef {{dragging: boolean, inputTimeStamp: number}} Change
 */

/** Cells of the map of velocities, at rest and while dragging. */
const FULL = { normal: 160, tangential: 120 };
const QUICK = { normal: 60, tangential: 45 };
/** Of the cut, along g_t. */
const CUT = 400;
/** Of the universal map, which is background. */
const PLACE = { kappa: 200, gtOverGn: 150 };
const QUANTITIES = ["epsilon_t", "coulomb"];

/** At most so often a map or a cut is asked for, in ms. */
const PAUSE = 80;

/**
 * The scene "Real spheres": materials and velocities in SI units, ε_t over the velocities, and where on
 * the universal map this is.
 * @param {object} handlers
 * @param {object} handlers.load each from the server
 * @param {() => Promise<Material[]>} handlers.load.materials
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<Scaling>} handlers.load.scaling
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<VelocityMap>} handlers.load.velocityMap
 * @param {(muOverAlpha: number, view: MapView, counts: typeof PLACE, signal: AbortSignal) => Promise<MapGrid>} handlers.load.map
 * @param {(error: unknown) => void} handlers.onError
 * @param {(patch: Partial<PageState>, change?: Change) => void} handlers.onState
 */
export function mountSpheresScene({ load, onError, onState }) {
  const velocities = mountVelocities(find(".velocities"), {
    onPlace: changeImpact,
    onOption: (patch) => onState(patch),
  });
  const cutPlot = createPlot(find(".sphere-cut .plot"), sphereCutFigure);
  const placePlot = createPlot(find(".place .plot"), placeFigure);
  const result = createImpactResult(find(".impact"));
  const controls = mountImpactControls(find(".impact-controls"), {
    onMaterial: (material) => onState({ impact: impactOf(material) }),
    onChange: changeImpact,
  });
  /** @type {Material[]} */
  let materials = [];
  /** @type {PageState | null} */
  let present = null;
  /** @type {{scaling: Scaling | null, velocities: ShownVelocities | null, cut: ShownVelocities | null, place: {grid: MapGrid, view: MapView} | null}} */
  const shown = { scaling: null, velocities: null, cut: null, place: null };
  /** What was posted last, by what it is for. @type {Record<"scaling" | "map" | "cut", Record<string, any>>} */
  const bodies = { scaling: {}, map: {}, cut: {} };
  const asked = { materials: false, place: "" };

  /**
   * @param {Partial<Impact>} patch
   * @param {Change} change
   */
  function changeImpact(patch, change) {
    if (present) {
      onState({ impact: { ...present.impact, ...patch } }, change);
    }
  }

  const scalings = createLatest({
    load: ({ body }, signal) => load.scaling(body, signal),
    onAnswer(answer, /** @type {{body: Record<string, any>, change: Change}} */ { change }) {
      shown.scaling = answer;
      result.show(answer);
      velocities.settle(answer);
      const { kappa, mu_over_alpha, gt_over_gn, damping } = answer;
      onState({ collision: { kappa, mu_over_alpha, gt_over_gn, damping } }, change);
      showControls();
      drawCut();
      drawPlace();
    },
    onError,
  });
  const maps = createLatest({
    load: ({ body }, signal) => load.velocityMap(body, signal),
    onAnswer(
      map,
      /** @type {{body: Record<string, any>, view: ShownVelocities["view"]}} */ { view },
    ) {
      shown.velocities = { map, view };
      drawMap();
    },
    onError,
    pause: PAUSE,
  });
  const cuts = createLatest({
    load: ({ body }, signal) => load.velocityMap(body, signal),
    onAnswer(
      map,
      /** @type {{body: Record<string, any>, view: ShownVelocities["view"]}} */ { view },
    ) {
      shown.cut = { map, view };
      drawCut();
    },
    onError,
    pause: PAUSE,
  });
  const places = createLatest({
    load: (view, signal) => load.map(1, view, PLACE, signal),
    onAnswer(grid, /** @type {MapView} */ view) {
      shown.place = { grid, view };
      drawPlace();
    },
    onError,
  });

  function drawMap() {
    if (shown.velocities && present) {
      velocities.show(shown.velocities.map, shown.velocities.view, present);
    }
  }

  function drawCut() {
    const material = materialOf(present);
    if (!shown.cut || !material) {
      return;
    }
    const { map, view } = shown.cut;
    const { tangential } = view;
    const normal = map.normal_velocity_m_s[0];
    const { scaling } = shown;
    cutPlot.show({
      curves: {
        epsilon_t: map.epsilon_t.map((row) => row[0]),
        coulomb: map.coulomb.map((row) => row[0]),
      },
      tangential,
      // Measured at another normal velocity, a point stands at the same angle.
      measured: (material.measured?.points ?? []).map((point) => ({
        share: tangential.toShare(
          normal * (point.tangential_velocity_m_s / point.normal_velocity_m_s),
        ),
        epsilon_t: point.epsilon_t,
      })),
      here:
        scaling && scaling.epsilon_t !== null
          ? {
              share: tangential.toShare(scaling.tangential_velocity_m_s),
              epsilon_t: scaling.epsilon_t,
            }
          : null,
    });
    byTestId("measured-key").hidden = !material.measured;
  }

  function drawPlace() {
    if (shown.place && present) {
      const { grid, view } = shown.place;
      const { x, y } = placeOnMap(view, present.collision);
      const horizontal = horizontalAxis(view, "kappa");
      placePlot.show({ grid, view, horizontal, quantity: "epsilon_t", place: { x, y } });
    }
  }

  /** @param {PageState | null} state */
  function materialOf(state) {
    return materials.find(({ id }) => id === state?.impact.material) ?? materials[0] ?? null;
  }

  function showControls() {
    const material = materialOf(present);
    if (material && present) {
      controls.show(material, present.impact, shown.scaling?.tangential_stiffness_n_per_m ?? NaN);
    }
  }

  async function loadMaterials() {
    asked.materials = true;
    try {
      materials = await load.materials();
      controls.offer(materials);
      if (present) {
        follow(present, { dragging: false, inputTimeStamp: performance.now() });
      }
    } catch (error) {
      asked.materials = false;
      onError(error);
    }
  }

  /**
   * @param {PageState} state
   * @param {Change} change
   */
  function follow(state, change) {
    const before = present;
    present = state;
    if (state.scene !== "spheres") {
      return;
    }
    if (!asked.materials) {
      loadMaterials();
    }
    const material = materialOf(state);
    if (!material) {
      return;
    }
    showControls();
    velocities.options(state);
    if (before?.velocity_law !== state.velocity_law || before.shape !== state.shape) {
      drawMap();
    }
    request(material, state, change);
    if (!change.dragging) {
      const view = mapView(state.collision, { scale: "log", map_y: "psi" });
      const wish = JSON.stringify(view);
      if (asked.place !== wish) {
        asked.place = wish;
        places.request(view);
      }
    }
    drawPlace();
  }

  /**
   * @param {Material} material
   * @param {PageState} state
   * @param {Change} change
   */
  function request(material, { impact }, change) {
    const values = valuesOf(material, impact);
    const normal = values.normal_velocity_m_s ?? 1;
    const tangential = values.tangential_velocity_m_s ?? 0;
    const held = change.dragging && shown.velocities ? shown.velocities.view : velocityView(values);
    const counts = change.dragging ? QUICK : FULL;
    const contact = contactBody(material, impact);
    velocities.point({ normal, tangential });
    ask(
      "scaling",
      {
        ...contact,
        impact: { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential },
      },
      (body) => scalings.request({ body, change }),
    );
    ask(
      "map",
      {
        ...contact,
        quantities: QUANTITIES,
        normal_velocity_m_s: rangeOf(held.normal, counts.normal),
        tangential_velocity_m_s: rangeOf(held.tangential, counts.tangential),
      },
      (body) => maps.request({ body, view: held }),
    );
    ask(
      "cut",
      {
        ...contact,
        quantities: QUANTITIES,
        // The least of columns that a map has, side by side.
        normal_velocity_m_s: { min: normal, max: normal * (1 + 1e-9), count: 2, scale: "linear" },
        tangential_velocity_m_s: rangeOf(held.tangential, CUT),
      },
      (body) => cuts.request({ body, view: held }),
    );
  }

  /**
   * Asks unless that is what was asked last.
   * @param {keyof typeof bodies} what
   * @param {Record<string, any>} body
   * @param {(body: Record<string, any>) => void} send
   */
  function ask(what, body, send) {
    if (JSON.stringify(bodies[what]) !== JSON.stringify(body)) {
      bodies[what] = body;
      send(body);
    }
  }

  return {
    follow,

    /** What each panel shows, for its menu. */
    shown: () => ({
      scaling: shown.scaling,
      velocities: shown.velocities?.map ?? null,
      sphereCut: shown.cut?.map ?? null,
      place: shown.place,
    }),

    /** What was posted for each. */
    bodies: () => bodies,

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      Object.assign(bodies, { scaling: {}, map: {}, cut: {} });
      asked.place = "";
    },

    unmount() {
      velocities.unmount();
      cutPlot.destroy();
      placePlot.destroy();
    },
  };
}

/**
 * @param {import("../state/scales.js").Scale} scale
 * @param {number} count
 */
function rangeOf({ min, max }, count) {
  return { min, max, count, scale: "linear" };
}
