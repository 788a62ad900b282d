import assert from "node:assert/strict";
import { test } from "node:test";

import {
  errorMapWish,
  FULL_ERROR_MAP,
  isEnoughErrorMap,
} from "../../../frontend/scenes/accuracy/error-map-wish.js";
import {
  cutWish,
  FULL_CUT,
  FULL_MAP,
  isEnoughCut,
  isEnoughMap,
  mapWish,
  QUICK_CUT,
  QUICK_MAP,
} from "../../../frontend/scenes/explorer/wishes.js";
import { USUAL_ACCURACY } from "../../../frontend/state/accuracy.js";

const STATE = {
  collision: { kappa: 63, mu_over_alpha: 1.4, gt_over_gn: 1.358, damping: 0 },
  accuracy: { ...USUAL_ACCURACY, method: "coulomb" },
  map: "epsilon_t",
  scale: "linear",
  map_y: "gt_over_gn",
  cut_x: "gt_over_gn",
};

/** The state at another collision, or with other options. */
function at(collision, options = {}) {
  return { ...STATE, ...options, collision: { ...STATE.collision, ...collision } };
}

const MAP = mapWish(STATE, false, null);
const CUT = cutWish(STATE, false, null);
const ERRORS = errorMapWish(STATE, false, null);

test("mapWish asks again only for another μ/α, other axes or another damping", () => {
  const isEnough = (state, dragging = false) => isEnoughMap(MAP, mapWish(state, dragging, MAP));
  assert.ok(isEnough(at({ kappa: 20, gt_over_gn: 3 })));
  assert.ok(isEnough(at({ kappa: 20 }), true));
  assert.ok(!isEnough(at({ mu_over_alpha: 2 })));
  assert.ok(!isEnough(at({ kappa: 120 })));
  assert.ok(!isEnough(at({}, { scale: "log" })));
  assert.ok(!isEnough(at({ damping: 0.1 }), true));
});

test("mapWish has fewer cells while μ/α is dragged and all when it rests", () => {
  const dragged = mapWish(at({ mu_over_alpha: 2 }), true, MAP);
  const resting = mapWish(at({ mu_over_alpha: 2 }), false, dragged);
  assert.deepEqual(
    [MAP, dragged, resting].map(({ counts }) => counts),
    [FULL_MAP, QUICK_MAP, FULL_MAP],
  );
  assert.ok(!isEnoughMap(dragged, resting));
});

test("mapWish keeps its axes while a drag goes beyond them", () => {
  const beyond = at({ kappa: 500, mu_over_alpha: 2 });
  const dragged = mapWish(beyond, true, MAP);
  assert.equal(dragged.view, MAP.view);
  assert.equal(mapWish(beyond, false, dragged).view.kappa.max, 500);
});

test("mapWish and cutWish are the same over ψ, whatever the μ/α", () => {
  const options = { map_y: "psi" };
  const map = mapWish(at({}, options), false, null);
  const cut = cutWish(at({}, options), false, null);
  assert.deepEqual([map.muOverAlpha, map.view.vertical], [1, "psi"]);
  assert.ok(isEnoughMap(map, mapWish(at({ mu_over_alpha: 2 }, options), true, map)));
  assert.ok(isEnoughMap(map, mapWish(at({ mu_over_alpha: 0.7 }, options), false, map)));
  assert.ok(isEnoughCut(cut, cutWish(at({ mu_over_alpha: 2 }, options), false, cut)));
});

test("cutWish asks again for another κ or μ/α, and not for another g_t/g_n", () => {
  const isEnough = (state, dragging = false) => isEnoughCut(CUT, cutWish(state, dragging, CUT));
  assert.ok(isEnough(at({ gt_over_gn: 3 }), true));
  assert.ok(isEnough(at({ gt_over_gn: 3 })));
  assert.ok(!isEnough(at({ kappa: 20 })));
  assert.ok(!isEnough(at({ mu_over_alpha: 2 })));
  assert.ok(!isEnough(at({}, { scale: "log" })));
});

test("cutWish along κ asks again for another impact or friction, over ψ too, and not for another κ", () => {
  for (const options of [{ cut_x: "kappa" }, { cut_x: "kappa", map_y: "psi" }]) {
    const asked = cutWish(at({}, options), false, null);
    const isEnough = (changes) => isEnoughCut(asked, cutWish(at(changes, options), true, asked));
    assert.deepEqual([asked.held, asked.muOverAlpha], [1.358, 1.4]);
    assert.ok(isEnough({ kappa: 20 }));
    assert.ok(!isEnough({ gt_over_gn: 3 }));
    assert.ok(!isEnough({ mu_over_alpha: 2 }));
    assert.ok(!isEnoughCut(CUT, asked));
  }
});

test("cutWish has fewer points while κ is dragged and all when it rests", () => {
  const dragged = cutWish(at({ kappa: 20 }), true, CUT);
  const resting = cutWish(at({ kappa: 20 }), false, dragged);
  assert.deepEqual(
    [CUT, dragged, resting].map(({ held, count }) => [held, count]),
    [
      [63, FULL_CUT],
      [20, QUICK_CUT],
      [20, FULL_CUT],
    ],
  );
  assert.ok(!isEnoughCut(dragged, resting));
});

test("errorMapWish asks again only for another method, knob, μ/α or axes", () => {
  const isEnough = (asked, state) => isEnoughErrorMap(asked, errorMapWish(state, false, asked));
  const exact = errorMapWish(at({}, { accuracy: USUAL_ACCURACY }), false, null);
  const stepped = { ...USUAL_ACCURACY, method: "timestep" };
  const steps = errorMapWish(at({}, { accuracy: stepped }), false, null);
  assert.ok(isEnough(ERRORS, at({ kappa: 20 })));
  assert.ok(!isEnough(ERRORS, at({ mu_over_alpha: 2 })));
  assert.ok(!isEnough(ERRORS, at({}, { scale: "log" })));
  assert.ok(!isEnough(ERRORS, at({}, { accuracy: USUAL_ACCURACY })));
  assert.ok(isEnough(exact, at({}, { accuracy: { ...USUAL_ACCURACY, tolerance: 1 } })));
  assert.ok(!isEnough(steps, at({}, { accuracy: { ...stepped, steps: 51 } })));
});

test("errorMapWish has fewer cells where each costs more", () => {
  const few = errorMapWish(at({}, { accuracy: { ...USUAL_ACCURACY, method: "ode" } }), false, null);
  const accuracy = { ...USUAL_ACCURACY, method: "timestep", steps: 1e5 };
  const fewer = errorMapWish(at({}, { accuracy }), false, null);
  const cells = [ERRORS, fewer, few].map(({ counts }) => counts.kappa * counts.gtOverGn);
  assert.equal(ERRORS.counts, FULL_ERROR_MAP);
  assert.ok(cells[0] > cells[1] && cells[1] > cells[2]);
  assert.ok(cells[1] * 1e5 <= 3.1e8);
});

test("errorMapWish is nothing where the method does not answer everywhere", () => {
  const accuracy = { ...USUAL_ACCURACY, method: "table" };
  const state = at({ kappa: 5000 }, { accuracy, scale: "log" });
  assert.equal(errorMapWish(state, false, null), null);
});
