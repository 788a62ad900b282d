// @ts-check

import { placeFigure } from "../figures/place-figure.js";
import { sphereCutFigure } from "../figures/sphere-cut-figure.js";
import { velocityMapFigure } from "../figures/velocity-map-figure.js";
import { typable } from "../format/number.js";
import { contactBody, impactOf, valuesOf, velocityView } from "../state/impact.js";
import { createLatest } from "../state/latest.js";
import { horizontalAxis, mapView, placeOnMap } from "../state/map-view.js";
import { mountCrosshair } from "./crosshair.js";
import { byTestId, find } from "./find.js";
import { mountImpactControls } from "./impact-controls.js";
import { createImpactResult } from "./impact-result.js";
import { createMapLegend } from "./map-legend.js";
import { createPlot } from "./plot.js";
import { onThemeChange } from "./theme.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/impact.js").Impact} Impact
 * @typedef {import("../state/impact.js").Material} Material
 * @typedef {import("../state/parameters.js").Collision} Collision
 * @typedef {import("../api/client.js").Scaling} Scaling
 * @typedef {import("../api/client.js").VelocityMap} VelocityMap
 * @typedef {import("../api/client.js").MapGrid} MapGrid
 * @typedef {ReturnType<typeof velocityView>} VelocityView
 * @typedef {{dragging: boolean, inputTimeStamp: number}} Change
 */

/** Cells of the map of velocities, at rest and while dragging. */
const FULL = { normal: 160, tangential: 120 };
const QUICK = { normal: 60, tangential: 45 };
/** Of the cut, along g_t. */
const CUT = 400;
/** Of the universal map, which is background. */
const PLACE = { kappa: 200, gtOverGn: 150 };

/** @type {import("./crosshair.js").Axes<VelocityView, {normal: number, tangential: number}>} */
const VELOCITY_AXES = {
  place(view, { normal, tangential }) {
    const [x, y] = [view.normal.toShare(normal), view.tangential.toShare(tangential)];
    return { x: within(x), y: within(y), outside: x > 1.01 || y > 1.01 || x < -0.01 };
  },
  at: (view, x, y) => ({
    normal_velocity_m_s: Number(view.normal.fromShare(within(x)).toPrecision(4)),
    tangential_velocity_m_s: Number(view.tangential.fromShare(within(y)).toPrecision(4)),
  }),
  horizontal: "normal_velocity_m_s",
  vertical: "tangential_velocity_m_s",
  words: ({ normal, tangential }) => `g_n ${typable(normal)} m/s, g_t ${typable(tangential)} m/s`,
};

/**
 * The scene "Real spheres": materials and velocities in SI units, ε_t over the velocities, and where on
 * the universal map this is.
 * @param {object} handlers
 * @param {object} handlers.load each from the server
 * @param {() => Promise<Material[]>} handlers.load.materials
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<Scaling>} handlers.load.scaling
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<VelocityMap>} handlers.load.velocityMap
 * @param {(muOverAlpha: number, view: import("../state/map-view.js").MapView, counts: typeof PLACE, signal: AbortSignal) => Promise<MapGrid>} handlers.load.map
 * @param {(error: unknown) => void} handlers.onError
 * @param {(patch: Partial<PageState>, change?: Change) => void} handlers.onState
 */
export function mountSpheresScene({ load, onError, onState }) {
  const velocities = find(".velocities");
  const mapPlot = createPlot(find(".plot", velocities), velocityMapFigure);
  const cutPlot = createPlot(find(".sphere-cut .plot"), sphereCutFigure);
  const placePlot = createPlot(find(".place .plot"), placeFigure);
  const legend = createMapLegend(byTestId("velocity-legend"));
  const result = createImpactResult(find(".impact"));
  const controls = mountImpactControls(find(".impact-controls"), {
    onMaterial: (material) => onState({ impact: impactOf(material) }),
    onChange: changeImpact,
  });
  const crosshair = mountCrosshair(find(".crosshair", velocities), VELOCITY_AXES, changeImpact);
  /** @type {Material[]} */
  let materials = [];
  /** @type {PageState | null} */
  let present = null;
  /** @type {Scaling | null} */
  let scaling = null;
  /** @type {{map: VelocityMap, view: VelocityView} | null} */
  let shownMap = null;
  /** @type {{map: VelocityMap, view: VelocityView} | null} */
  let shownCut = null;
  /** @type {{grid: MapGrid, view: import("../state/map-view.js").MapView} | null} */
  let shownPlace = null;
  const asked = { materials: false, scaling: "", map: "", cut: "", place: "" };
  /** @type {Record<"scaling" | "map" | "cut" | "place", Record<string, any>>} */
  const bodies = { scaling: {}, map: {}, cut: {}, place: {} };

  velocities.addEventListener("change", (event) => {
    const { name, value } = /** @type {HTMLInputElement} */ (event.target);
    onState({ [name]: value });
  });

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
      scaling = answer;
      result.show(answer);
      if (answer.epsilon_t !== null) {
        legend.point({ epsilon_t: answer.epsilon_t, switches: answer.switches });
      }
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
    onAnswer(map, /** @type {{body: Record<string, any>, view: VelocityView}} */ { view }) {
      shownMap = { map, view };
      drawMap();
    },
    onError,
    pause: 80,
  });
  const cuts = createLatest({
    load: ({ body }, signal) => load.velocityMap(body, signal),
    onAnswer(map, /** @type {{body: Record<string, any>, view: VelocityView}} */ { view }) {
      shownCut = { map, view };
      drawCut();
    },
    onError,
    pause: 80,
  });
  const places = createLatest({
    load: (view, signal) => load.map(1, view, PLACE, signal),
    onAnswer(grid, /** @type {import("../state/map-view.js").MapView} */ view) {
      shownPlace = { grid, view };
      drawPlace();
    },
    onError,
  });

  function drawMap() {
    if (!shownMap || !present) {
      return;
    }
    const { map, view } = shownMap;
    const law = present.velocity_law === "coulomb" ? "coulomb" : "epsilon_t";
    mapPlot.show({ cells: map[law], view });
    crosshair.lieOn(view);
    legend.draw("epsilon_t", 0);
    find(".plot", velocities).setAttribute(
      "aria-label",
      `ε_t ${law === "coulomb" ? "by Coulomb’s law " : ""}over normal and tangential velocity up to ${typable(view.most)} m/s.`,
    );
  }

  function drawCut() {
    const material = materialOf(present);
    if (!shownCut || !material) {
      return;
    }
    const { map, view } = shownCut;
    const { tangential } = view;
    const normal = map.normal_velocity_m_s[0];
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
    if (shownPlace && present) {
      const { grid, view } = shownPlace;
      const { x, y } = placeOnMap(view, present.collision);
      const horizontal = horizontalAxis(view, "kappa");
      placePlot.show({ grid, view, horizontal, quantity: "epsilon_t", place: { x, y } });
    }
  }
  const endThemeChanges = onThemeChange(() => legend.draw("epsilon_t", 0));

  /** @param {PageState | null} state */
  function materialOf(state) {
    return materials.find(({ id }) => id === state?.impact.material) ?? materials[0] ?? null;
  }

  function showControls() {
    const material = materialOf(present);
    if (material && present) {
      controls.show(material, present.impact, scaling?.tangential_stiffness_n_per_m ?? NaN);
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
    showLaw(state);
    const values = valuesOf(material, state.impact);
    const normal = values.normal_velocity_m_s ?? 1;
    const tangential = values.tangential_velocity_m_s ?? 0;
    crosshair.point({ normal, tangential });
    const contact = contactBody(material, state.impact);
    const impact = { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential };
    ask("scaling", { ...contact, impact }, (body) => scalings.request({ body, change }));
    if (before?.velocity_law !== state.velocity_law) {
      drawMap();
    }
    const held = change.dragging && shownMap ? shownMap.view : velocityView(values);
    const counts = change.dragging ? QUICK : FULL;
    const quantities = ["epsilon_t", "coulomb"];
    ask(
      "map",
      {
        ...contact,
        quantities,
        normal_velocity_m_s: rangeOf(held.normal, counts.normal),
        tangential_velocity_m_s: rangeOf(held.tangential, counts.tangential),
      },
      (body) => maps.request({ body, view: held }),
    );
    ask(
      "cut",
      {
        ...contact,
        quantities,
        normal_velocity_m_s: { min: normal, max: normal * (1 + 1e-9), count: 2, scale: "linear" },
        tangential_velocity_m_s: rangeOf(held.tangential, CUT),
      },
      (body) => cuts.request({ body, view: held }),
    );
    if (!change.dragging) {
      const view = mapView(state.collision, { scale: "log", map_y: "psi" });
      ask("place", { view }, () => places.request(view));
    }
    drawPlace();
  }

  /**
   * Asks unless that is what was asked last.
   * @param {"scaling" | "map" | "cut" | "place"} what
   * @param {Record<string, any>} body
   * @param {(body: Record<string, any>) => void} request
   */
  function ask(what, body, request) {
    const wish = JSON.stringify(body);
    if (asked[what] !== wish) {
      asked[what] = wish;
      bodies[what] = body;
      request(body);
    }
  }

  /** @param {PageState} state */
  function showLaw({ velocity_law: law }) {
    const choice = find(`[name="velocity_law"][value="${law}"]`, velocities);
    /** @type {HTMLInputElement} */ (choice).checked = true;
  }

  return {
    follow,

    /** What each panel shows, for its menu. */
    shown: () => ({
      scaling,
      velocities: shownMap?.map ?? null,
      sphereCut: shownCut?.map ?? null,
      place: shownPlace,
    }),

    /** What was posted for each. */
    bodies: () => bodies,

    /** Takes nothing for answered, as after the server was away. */
    forget() {
      Object.assign(asked, { scaling: "", map: "", cut: "", place: "" });
    },

    unmount() {
      endThemeChanges();
      for (const plot of [mapPlot, cutPlot, placePlot]) {
        plot.destroy();
      }
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

/** @param {number} share */
function within(share) {
  return Math.min(1, Math.max(0, share));
}
