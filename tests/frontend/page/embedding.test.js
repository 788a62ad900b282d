import assert from "node:assert/strict";
import { test } from "node:test";

import { frameText, framed } from "../../../frontend/page/embedding/frame-text.js";
import { layOut, unlocked } from "../../../frontend/page/embedding/frame.js";
import { readAddress } from "../../../frontend/state/address/reading.js";
import { writeAddress } from "../../../frontend/state/address/writing.js";

const stateAt = (search) => readAddress(search).state;

test("unlocked lets through of the values what the author offers, and all that is no value", () => {
  const state = stateAt("?kappa=20&embed=map&sliders=kappa");
  const wish = stateAt(
    "?kappa=30&gt_over_gn=2&alpha=0.4&bounce=sphere&spin_share=0.5&map=switches",
  );
  const { embed, sliders } = state;
  const { collision, impact, map, ...rest } = unlocked({ ...wish, embed, sliders }, state);
  assert.deepEqual(collision, { ...state.collision, kappa: 30 });
  assert.deepEqual(impact, state.impact);
  assert.equal(map, "switches");
  for (const name of ["alpha", "bounce", "spin_share"]) {
    assert.ok(!(name in rest), name);
  }
});

test("unlocked holds back nothing where nothing is locked, nor what is worked out", () => {
  const wish = { collision: { kappa: 1, mu_over_alpha: 1, gt_over_gn: 1, damping: 0 }, alpha: 0.4 };
  for (const search of ["", "?sliders=kappa", "?embed=map"]) {
    assert.equal(unlocked(wish, stateAt(search)), wish, search);
  }
  const locked = stateAt("?embed=velocities&sliders=none");
  assert.equal(unlocked(wish, locked, { isWorkedOut: true }), wish);
  assert.deepEqual(unlocked(wish, locked), { collision: locked.collision });
});

test("unlocked lets the damping go with the restitution that tells it", () => {
  const state = stateAt("?embed=impact&sliders=normal_restitution&dissipative_constant_s=1e-6");
  const impact = { ...state.impact, normal_restitution: 0.8, dissipative_constant_s: null };
  assert.deepEqual(unlocked({ impact: { ...impact, radius_m: 1 } }, state).impact, impact);
  const spun = stateAt("?embed=contact&sliders=spin_share");
  assert.equal(unlocked({ spin_share: 1 }, spun).spin_share, 1);
});

test("layOut has pictures share the height in pairs, and gives texts and what is left over both columns", () => {
  const picture = "minmax(min-content, 1fr)";
  assert.deepEqual(layOut(["force"]), { one: picture, two: picture, wide: ["force"] });
  assert.deepEqual(layOut(["result", "contact", "force", "map"]), {
    one: `auto ${picture} ${picture} ${picture}`,
    two: `auto ${picture} ${picture}`,
    wide: ["result", "map"],
  });
  assert.deepEqual(layOut(["force", "result", "map"]).wide, ["force", "result", "map"]);
});

test("framed is a state that its own address gives back, without what is of the page around it", () => {
  const choices = { panels: ["force", "map"], sliders: ["kappa"], lang: "system", theme: "dark" };
  const lesson = stateAt("?scene=lesson&step=3&face=plain&notes=shown&kappa=20&pins=4.5,1.4,4");
  const state = framed(lesson, choices);
  const { state: read, problems } = readAddress(writeAddress(state));
  assert.deepEqual([read, problems], [state, []]);
  assert.equal(read.collision.kappa, 20);
  assert.doesNotMatch(writeAddress(state), /scene|step|face|notes/);
  assert.equal(framed(lesson, { ...choices, sliders: [] }).sliders, "none");
});

test("frameText escapes what stands in its attributes", () => {
  const frame = { address: '/?a=1&b="2"', title: 'A "map" <i>', width: 720, height: 480 };
  assert.equal(
    frameText(frame),
    '<iframe src="/?a=1&amp;b=&quot;2&quot;" title="A &quot;map&quot; &lt;i&gt;" width="720" ' +
      'height="480" style="border: 0; max-width: 100%" loading="lazy"></iframe>',
  );
});
