// @ts-check

import { mapQuery } from "../../api/queries.js";
import { mapFigure } from "../../figures/map-figure.js";
import { MAP_MARGIN } from "../../figures/plot-area.js";
import { mapTable } from "../../figures/tables.js";
import { say } from "../../format/words.js";
import { createFollower, isSame } from "../../state/loading/follower.js";
import {
  contactBody,
  impactOf,
  materialOf,
  valuesOf,
  velocityView,
  workedOut,
} from "../../state/impact.js";
import {
  axesFor,
  axesInWords,
  horizontalAxis,
  placeOnMap,
  rowsOf,
  sameAxes,
} from "../../state/map-view.js";
import { collisionOfImpact, SOLID_ALPHA } from "../../state/parameters.js";
import { byTestId, find } from "../../widgets/find.js";
import { createMark } from "../../widgets/plots/mark.js";
import { layOver } from "../../widgets/plots/overlay.js";
import { afterNextFrame, announcePainted } from "../../widgets/painted.js";
import { createPlot } from "../../widgets/plots/plot.js";
import { mountImpactControls } from "./impact-controls.js";
import { createImpactResult } from "./impact-result.js";
import { epsilonBy, mountSphereCut } from "./sphere-cut.js";
import { sphereCutTable, velocityMapTable } from "./tables.js";
import { mountVelocityMap } from "./velocity-map.js";

/**
 * @typedef {import("../../state/address/options.js").PageState} PageState
 * @typedef {import("../../state/store.js").Change} Change
 * @typedef {import("../../state/impact.js").Impact} Impact
 * @typedef {import("../../state/impact.js").Material} Material
 * @typedef {import("../../api/answers.js").Scaling} Scaling
 * @typedef {import("../../api/answers.js").VelocityMap} VelocityMap
 * @typedef {ReturnType<typeof velocityView>} VelocityView
 * @typedef {import("./sphere-cut.js").ShownVelocities} ShownVelocities
 * @typedef {Record<string, any>} Body of a request
 * @typedef {{body: Body, change: Change, isNew: boolean}} ScalingWish
 * @typedef {{body: Body, subject: unknown, isQuick: boolean, view: VelocityView, change: Change}} VelocityWish
 */

/** Cells of the map of velocities, and points of the cut, at rest and while dragging. */
const FULL = { normal: 160, tangential: 120, cut: 400 };
/** A damped collision costs ten times as much, and each column has a damping of its own. */
const DAMPED = { normal: 96, tangential: 72, cut: 300 };
const QUICK = { normal: 48, tangential: 36, cut: 120 };
/** While dragging, half a pixel of a picture will do. */
const QUICK_TOLERANCE = 4e-3;
const QUANTITIES = ["epsilon_t", "coulomb"];

/** Of the universal map, which is background. */
const PLACE = {
  counts: { kappa: 200, gtOverGn: 150 },
  axes: /** @type {const} */ ({ scale: "log", map_y: "psi" }),
};

/** At most so often a map is asked for, in ms: the numbers and the cut go first. */
const PAUSE = 80;

/**
 * The scene "Real spheres": materials and velocities in SI units, ε_t over the velocities, and where on
 * the universal map this is.
 * @param {import("../scene.js").Page} page
 * @returns {import("../scene.js").Scene}
 */
export function mountSpheres({ client, present, set, preview, say: notify, explainBy }) {
  const velocities = mountVelocityMap(find(".velocities"), {
    onPlace: changeImpact,
    onOption: set,
  });
  const sphereCut = mountSphereCut(find(".sphere-cut"));
  const placePlot = createPlot(find(".place .plot"), mapFigure);
  const placeElement = byTestId("place-mark");
  layOver(placeElement, MAP_MARGIN);
  const placeMark = createMark(placeElement);
  const result = createImpactResult(find(".impact"));
  const controls = mountImpactControls(find(".impact-controls"), present(), {
    onMaterial: (material) => set({ impact: impactOf(material) }),
    onChange: changeImpact,
  });
  /** @type {Material[]} */
  let materials = [];
  let areMaterialsAsked = false;
  /** @type {{scaling: Scaling | null, velocities: ShownVelocities | null, cut: ShownVelocities | null, place: import("../../state/map-view.js").MapAxes & {grid: import("../../api/answers.js").MapGrid} | null}} */
  const shown = { scaling: null, velocities: null, cut: null, place: null };

  /**
   * @param {Partial<Impact>} patch
   * @param {Change} [change]
   */
  function changeImpact(patch, change) {
    set({ impact: { ...present().impact, ...patch } }, change);
  }

  /** @type {Parameters<typeof explainBy>[0]} */
  function onRefused(...reason) {
    notify(...reason);
    preview(null);
  }

  const scalings = createFollower({
    load: (/** @type {ScalingWish} */ { body }, signal) => client.scaling(body, signal),
    isEnough: (asked, { body, isNew }) => !isNew && isSame(asked.body, body),
    onAnswer(answer, { change }) {
      shown.scaling = answer;
      result.show(answer);
      set(collisionOfImpact(answer), { ...change, isWorkedOut: true });
      drawCut(change.dragging);
      announce("impact", change);
    },
    onError: explainBy((...reason) => {
      shown.scaling = null;
      placeMark.hide();
      result.refuse(...reason);
      onRefused(...reason);
    }),
  });
  const maps = createFollower({
    load: (/** @type {VelocityWish} */ { body }, signal) => client.velocityMap(body, signal),
    isEnough: isEnoughVelocities,
    onAnswer(map, { view, change }) {
      shown.velocities = { map, view };
      drawMap();
      announce("velocities", change);
    },
    onError: explainBy(velocities.showReason),
    pause: () => PAUSE,
  });
  const cuts = createFollower({
    load: (/** @type {VelocityWish} */ { body }, signal) => client.velocityMap(body, signal),
    isEnough: isEnoughVelocities,
    onAnswer(map, { view, change }) {
      shown.cut = { map, view };
      sphereCut.showReason("");
      drawCut(change.dragging);
      announce("sphere-cut", change);
    },
    onError: explainBy(() => sphereCut.showReason(say("spheres.cut.none"))),
  });
  const places = createFollower({
    load: client.map,
    isEnough: sameAxes,
    onAnswer(grid, { view, muOverAlpha }) {
      shown.place = { grid, view, muOverAlpha };
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
    if (shown.velocities) {
      velocities.show(shown.velocities.map, shown.velocities.view, present());
    }
  }

  /** @param {boolean} dragging */
  function drawCut(dragging) {
    const material = materialOf(materials, present().impact);
    const { scaling } = shown;
    const epsilon = scaling && epsilonBy(scaling, shown.cut, present().velocity_law);
    if (scaling) {
      velocities.settle(scaling, epsilon);
    }
    if (shown.cut && material) {
      const here =
        scaling && epsilon !== null ? { velocity: scaling.tangential_velocity_m_s, epsilon } : null;
      sphereCut.show(shown.cut, material, here, dragging);
    }
  }

  /** Laid over the map, so that moving it draws nothing anew. */
  function markPlace() {
    if (shown.place && shown.scaling) {
      const { view } = shown.place;
      const { collision } = present();
      placeMark.show(placeOnMap(view, collision), axesInWords(view, collision));
    }
  }

  async function loadMaterials() {
    areMaterialsAsked = true;
    try {
      materials = await client.materials();
      controls.offer(materials);
      const change = { dragging: false, inputTimeStamp: performance.now() };
      show(present(), null);
      follow(present(), null, change);
    } catch (error) {
      areMaterialsAsked = false;
      explainBy(onRefused)(error);
    }
  }

  /**
   * @param {PageState} state
   * @param {PageState | null} previous
   */
  function show(state, previous) {
    const material = materialOf(materials, state.impact);
    if (state.scene !== "spheres" || !material) {
      return;
    }
    const { normal_velocity_m_s: normal, tangential_velocity_m_s: tangential } = velocitiesOf(
      valuesOf(material, state.impact),
    );
    controls.show(material, state.impact, workedOut(shown.scaling));
    velocities.options(state);
    velocities.point({ normal, tangential });
    if (
      previous &&
      (previous.velocity_law !== state.velocity_law || previous.shape !== state.shape)
    ) {
      drawMap();
      drawCut(false);
    }
    markPlace();
  }

  /**
   * @param {PageState} state
   * @param {PageState | null} previous
   * @param {Change} change
   */
  function follow(state, previous, change) {
    if (state.scene !== "spheres") {
      return;
    }
    const material = materialOf(materials, state.impact);
    if (!areMaterialsAsked) {
      loadMaterials();
    }
    if (!material) {
      return;
    }
    const contact = contactBody(material, state.impact);
    const values = valuesOf(material, state.impact);
    // Set again to what it was, it is an impact of its own: the collision may come from elsewhere.
    const isNew = previous?.impact !== state.impact || previous.scene !== state.scene;
    scalings.follow({ body: { ...contact, impact: velocitiesOf(values) }, change, isNew });
    followVelocities(contact, values, change);
    if (!change.dragging) {
      places.follow({
        ...axesFor({ collision: state.collision, ...PLACE.axes }, false),
        counts: PLACE.counts,
      });
    }
  }

  /**
   * @param {Body} contact
   * @param {ReturnType<typeof valuesOf>} values
   * @param {Change} change
   */
  function followVelocities(contact, values, change) {
    const { dragging } = change;
    const { normal_velocity_m_s: normal } = velocitiesOf(values);
    const held = dragging && shown.velocities;
    const view = held ? held.view : velocityView(values, present().velocity_scale);
    const whole = values.dissipative_constant_s === 0 ? FULL : DAMPED;
    const counts = dragging ? QUICK : whole;
    const body = {
      ...contact,
      ...(dragging ? { tolerance: QUICK_TOLERANCE } : {}),
      quantities: QUANTITIES,
    };
    const rest = { isQuick: dragging, view, change };
    maps.follow({
      body: {
        ...body,
        normal_velocity_m_s: rangeOf(view.scale, view.normal, counts.normal),
        tangential_velocity_m_s: rangeOf(view.scale, view.tangential, counts.tangential),
      },
      subject: [contact, view.most, view.scale],
      ...rest,
    });
    cuts.follow({
      body: {
        ...body,
        // The least of columns that a map has, side by side.
        normal_velocity_m_s: { min: normal, max: normal * (1 + 1e-9), count: 2, scale: "linear" },
        tangential_velocity_m_s: rangeOf(view.scale, view.tangential, counts.cut),
      },
      subject: [contact, view.most, view.scale, normal],
      ...rest,
    });
  }

  const parameters = () => ({ material: present().impact.material });

  return {
    show,
    follow,

    /** The collision of another impact follows when it is worked out. */
    decides: (state, previous) => state.scene === "spheres" && state.impact !== previous.impact,

    forget() {
      for (const follower of [scalings, maps, cuts, places]) {
        follower.forget();
      }
    },

    pictures: {
      velocities: {
        title: say("spheres.velocities.picture"),
        request: () => ({ call: "scaling/map", query: {}, body: maps.asked()?.body ?? {} }),
        parameters,
        table: () => shown.velocities && velocityMapTable(shown.velocities.map),
      },
      sphere_cut: {
        title: say("spheres.cut.picture"),
        request: () => ({ call: "scaling/map", query: {}, body: cuts.asked()?.body ?? {} }),
        parameters,
        table: () => shown.cut && sphereCutTable(shown.cut.map),
      },
      impact: {
        title: say("spheres.result.picture"),
        request: () => ({ call: "scaling", query: {}, body: scalings.asked()?.body ?? {} }),
        parameters,
      },
      place: {
        title: say("spheres.place.picture"),
        request() {
          const axes = shown.place ?? axesFor({ ...present(), ...PLACE.axes }, false);
          const { view, muOverAlpha } = axes;
          return { call: "map", query: mapQuery({ view, muOverAlpha, counts: PLACE.counts }) };
        },
        parameters: () => ({ ...present().collision }),
        table() {
          const { collision } = present();
          return (
            shown.place &&
            mapTable(
              { grid: shown.place.grid, quantity: "epsilon_t" },
              rowsOf(shown.place.view, collision),
              collision,
            )
          );
        },
      },
    },
  };
}

/** @param {ReturnType<typeof valuesOf>} values */
function velocitiesOf({ normal_velocity_m_s: normal, tangential_velocity_m_s: tangential }) {
  return { normal_velocity_m_s: normal ?? 1, tangential_velocity_m_s: tangential ?? 0 };
}

/** @param {VelocityWish} asked @param {VelocityWish} wish */
function isEnoughVelocities(asked, wish) {
  return isSame(asked.subject, wish.subject) && (wish.isQuick || !asked.isQuick);
}

/**
 * @param {"linear" | "log"} scale
 * @param {import("../../state/scales.js").Scale} ends
 * @param {number} count
 */
function rangeOf(scale, { min, max }, count) {
  return { min, max, count, scale };
}
