// @ts-check

import { mapFigure } from "../figures/map-figure.js";
import { MAP_MARGIN } from "../figures/plot-area.js";
import { sphereCutFigure } from "../figures/sphere-cut-figure.js";
import { contactBody, impactOf, valuesOf, velocityView } from "../state/impact.js";
import { createLatest } from "../state/latest.js";
import { horizontalAxis, mapView, placeOnMap } from "../state/map-view.js";
import { carriedOver, SOLID_ALPHA } from "../state/parameters.js";
import { byTestId, find } from "./find.js";
import { mountImpactControls } from "./impact-controls.js";
import { createImpactResult } from "./impact-result.js";
import { layOver } from "./overlay.js";
import { afterNextFrame, announcePainted } from "./painted.js";
import { createPlot } from "./plot.js";
import { mountVelocities } from "./velocities.js";
import { withhold } from "./withhold.js";

/**
 * @typedef {import("../state/url.js").PageState} PageState
 * @typedef {import("../state/impact.js").Impact} Impact
 * @typedef {import("../state/impact.js").Material} Material
 * @typedef {import("../api/answers.js").Scaling} Scaling
 * @typedef {import("../api/answers.js").VelocityMap} VelocityMap
 * @typedef {import("../api/answers.js").MapGrid} MapGrid
 * @typedef {import("../state/map-view.js").MapView} MapView
 * @typedef {{map: VelocityMap, view: ReturnType<typeof velocityView>}} ShownVelocities
 * @typedef {{dragging: boolean, inputTimeStamp: number}} Change
 * @typedef {{body: Record<string, any>, view: ShownVelocities["view"], change: Change}} VelocityWish
 */

/** Cells of the map of velocities, and points of the cut, at rest and while dragging. */
const FULL = { normal: 160, tangential: 120, cut: 400 };
/** A damped collision costs ten times as much, and each column has a damping of its own. */
const DAMPED = { normal: 96, tangential: 72, cut: 300 };
const QUICK = { normal: 48, tangential: 36, cut: 120 };
/** While dragging, half a pixel of a picture will do. */
const QUICK_TOLERANCE = 4e-3;
/** Of the universal map, which is background. */
const PLACE = { kappa: 200, gtOverGn: 150 };
const QUANTITIES = ["epsilon_t", "coulomb"];

/** At most so often a map is asked for, in ms: the numbers and the cut go first. */
const PAUSE = 80;

/** Of what was asked for. */
const NOTHING = { subject: "", isQuick: false };

/**
 * The scene "Real spheres": materials and velocities in SI units, ε_t over the velocities, and where on
 * the universal map this is.
 * @param {object} handlers
 * @param {object} handlers.load each from the server
 * @param {() => Promise<Material[]>} handlers.load.materials
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<Scaling>} handlers.load.scaling
 * @param {(body: Record<string, any>, signal: AbortSignal) => Promise<VelocityMap>} handlers.load.velocityMap
 * @param {(muOverAlpha: number, view: MapView, counts: typeof PLACE, signal: AbortSignal) => Promise<MapGrid>} handlers.load.map
 * @param {(refuse: (reason: string) => void) => (error: unknown) => void} handlers.explainBy
 * @param {(reason: string) => void} handlers.onRefused
 * @param {(patch: Partial<PageState>, change?: Change) => void} handlers.onState
 */
export function mountSpheresScene({ load, explainBy, onRefused, onState }) {
  const velocities = mountVelocities(find(".velocities"), {
    onPlace: changeImpact,
    onOption: (patch) => onState(patch),
  });
  const cutPlot = createPlot(find(".sphere-cut .plot"), sphereCutFigure);
  const cutStage = find(".sphere-cut .plot-stage");
  const placePlot = createPlot(find(".place .plot"), mapFigure);
  const placeMark = byTestId("place-mark");
  layOver(placeMark, MAP_MARGIN);
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
  const asked = { materials: false, place: "", map: { ...NOTHING }, cut: { ...NOTHING } };

  /**
   * @param {Partial<Impact>} patch
   * @param {Change} [change]
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
      onState(carriedOver(answer), change);
      drawCut(change.dragging);
      announce("impact", change);
    },
    onError: explainBy((reason) => {
      shown.scaling = null;
      placeMark.removeAttribute("data-placed");
      result.refuse(reason);
      onRefused(reason);
    }),
  });
  const maps = createLatest({
    load: ({ body }, signal) => load.velocityMap(body, signal),
    onAnswer(map, /** @type {VelocityWish} */ { view, change }) {
      shown.velocities = { map, view };
      drawMap();
      announce("velocities", change);
    },
    onError: explainBy(velocities.withhold),
    pause: PAUSE,
  });
  const cuts = createLatest({
    load: ({ body }, signal) => load.velocityMap(body, signal),
    onAnswer(map, /** @type {VelocityWish} */ { view, change }) {
      shown.cut = { map, view };
      withhold(cutStage, "");
      drawCut(change.dragging);
      announce("sphere-cut", change);
    },
    onError: explainBy(() => withhold(cutStage, "No cut of this one")),
  });
  const places = createLatest({
    load: (view, signal) => load.map(1, view, PLACE, signal),
    onAnswer(grid, /** @type {MapView} */ view) {
      shown.place = { grid, view };
      const horizontal = horizontalAxis(view, "kappa", SOLID_ALPHA);
      placePlot.show({ grid, view, horizontal, quantity: "epsilon_t" });
      markPlace();
    },
    onError: explainBy(onRefused),
  });

  /**
   * @param {string} view
   * @param {Change} change
   */
  function announce(view, { inputTimeStamp }) {
    afterNextFrame(() => announcePainted(view, inputTimeStamp));
  }

  function drawMap() {
    if (shown.velocities && present) {
      velocities.show(shown.velocities.map, shown.velocities.view, present);
    }
  }

  /** @param {boolean} dragging */
  function drawCut(dragging) {
    const material = materialOf(present);
    if (!shown.cut || !material) {
      return;
    }
    const { map, view } = shown.cut;
    const { tangential } = view;
    const normal = map.normal_velocity_m_s[0];
    const { scaling } = shown;
    const subject = {
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
    };
    cutPlot.show(subject, dragging);
    byTestId("measured-key").hidden = !material.measured;
  }

  /** Laid over the map, so that moving it draws nothing anew. */
  function markPlace() {
    if (shown.place && shown.scaling && present) {
      const { x, y } = placeOnMap(shown.place.view, present.collision);
      placeMark.style.setProperty("--x", String(x));
      placeMark.style.setProperty("--y", String(1 - y));
      placeMark.toggleAttribute("data-placed", true);
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
      explainBy(onRefused)(error);
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
    const isNew = before?.impact !== state.impact || before.scene !== state.scene;
    request(material, state, change, isNew);
    if (!change.dragging) {
      const view = mapView(state.collision, { scale: "log", map_y: "psi" });
      const wish = JSON.stringify(view);
      if (asked.place !== wish) {
        asked.place = wish;
        places.request(view);
      }
    }
    markPlace();
  }

  /**
   * @param {Material} material
   * @param {PageState} state
   * @param {Change} change
   * @param {boolean} isNew whether the impact was just set, if perhaps to what it was
   */
  function request(material, { impact }, change, isNew) {
    const { dragging } = change;
    const values = valuesOf(material, impact);
    const normal = values.normal_velocity_m_s ?? 1;
    const tangential = values.tangential_velocity_m_s ?? 0;
    const view = dragging && shown.velocities ? shown.velocities.view : velocityView(values);
    const whole = values.dissipative_constant_s === 0 ? FULL : DAMPED;
    const counts = dragging ? QUICK : whole;
    const quickly = dragging ? { tolerance: QUICK_TOLERANCE } : {};
    const contact = contactBody(material, impact);
    velocities.point({ normal, tangential });
    const scaling = {
      ...contact,
      impact: { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential },
    };
    if (isNew || JSON.stringify(scaling) !== JSON.stringify(bodies.scaling)) {
      bodies.scaling = scaling;
      scalings.request({ body: scaling, change });
    }
    if (isWanted("map", [contact, view.most], dragging)) {
      bodies.map = {
        ...contact,
        ...quickly,
        quantities: QUANTITIES,
        normal_velocity_m_s: rangeOf(view.normal, counts.normal),
        tangential_velocity_m_s: rangeOf(view.tangential, counts.tangential),
      };
      maps.request({ body: bodies.map, view, change });
    }
    if (isWanted("cut", [contact, view.most, normal], dragging)) {
      bodies.cut = {
        ...contact,
        ...quickly,
        quantities: QUANTITIES,
        // The least of columns that a map has, side by side.
        normal_velocity_m_s: { min: normal, max: normal * (1 + 1e-9), count: 2, scale: "linear" },
        tangential_velocity_m_s: rangeOf(view.tangential, counts.cut),
      };
      cuts.request({ body: bodies.cut, view, change });
    }
  }

  /**
   * Whether a picture is another than that asked for last, or a better one of the same.
   * @param {"map" | "cut"} what
   * @param {unknown} subject
   * @param {boolean} dragging
   */
  function isWanted(what, subject, dragging) {
    const before = asked[what];
    const next = { subject: JSON.stringify(subject), isQuick: dragging };
    if (before.subject === next.subject && (dragging || !before.isQuick)) {
      return false;
    }
    asked[what] = next;
    return true;
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
      Object.assign(bodies, { scaling: {} });
      Object.assign(asked, { place: "", map: NOTHING, cut: NOTHING });
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
