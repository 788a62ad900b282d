import assert from "node:assert/strict";
import { test } from "node:test";

import {
  contactMotion,
  mirrored,
  stateAt,
} from "../../../frontend/scenes/explorer/bounce/contact-motion.js";
import { contactScene } from "../../../frontend/scenes/explorer/bounce/contact-drawing.js";
import { makeTrace } from "../fixtures.js";

const SIZE = { width: 560, height: 150 };
/** Slides, sticks while the spring takes up all of the motion, and slides back. */
const TRACE = makeTrace({
  compression: Float64Array.of(0, 1, 1, 0),
  tangential_velocity: Float64Array.of(1, 1, -1, -1),
  spring_elongation: Float64Array.of(0, 0.1, 0.1, 0),
});
const motion = contactMotion(TRACE);
const numbers = (path) => path.match(/-?[\d.]+/g).map(Number);

test("contactMotion takes for slip what the spring has not taken up", () => {
  assert.deepEqual([...motion.slip], [0, 0.9, 0.9, 0]);
  assert.deepEqual(motion.slipRange, { min: 0, max: 0.9 });
  assert.equal(motion.largestElongation, 0.1);
});

test("stateAt reads between the samples, and at both ends", () => {
  assert.equal(stateAt(motion, 0.5).compression, 0.5);
  assert.equal(stateAt(motion, 0).compression, 0);
  assert.equal(stateAt(motion, 3).velocity, -1);
  assert.deepEqual(
    [0, 1, 1.5, 2, 3].map((instant) => stateAt(motion, instant).regime),
    ["forward", "sticking", "sticking", "backward", "backward"],
  );
});

test("contactScene keeps the foot where it is while it sticks", () => {
  const [a, b] = [1.05 / 3, 1.95 / 3].map((share) => contactScene(motion, share, SIZE));
  assert.ok(Math.abs(a.shoe.x - b.shoe.x) < 1e-9);
});

test("contactScene holds the ball ahead of its foot by the elongation, and flattens it", () => {
  const { anchor, shoe, ball, ground } = contactScene(motion, 1 / 3, SIZE);
  assert.ok(anchor.x > shoe.x + 20);
  const [left, at, , , , , , right] = numbers(ball);
  assert.ok(right - left > 50);
  assert.equal(at, ground);
  const [first, , , , , , , last] = numbers(contactScene(motion, 0, SIZE).ball);
  assert.equal(Number((last - first).toFixed(2)), 1);
});

test("contactScene leaves a track for each episode so far", () => {
  const tracksAt = (share) =>
    contactScene(motion, share, SIZE).tracks.map(({ regime, from, to }) => [
      regime,
      Math.sign(to - from),
    ]);
  assert.deepEqual(tracksAt(0.1), [["forward", 1]]);
  assert.deepEqual(tracksAt(1), [
    ["forward", 1],
    ["sticking", 0],
    ["backward", -1],
  ]);
});

test("contactScene stays in the picture, on a phone as well, and finite where nothing moves", () => {
  const still = makeTrace({
    compression: Float64Array.of(0, 1, 1, 0),
    tangential_velocity: new Float64Array(4),
    spring_elongation: new Float64Array(4),
  });
  const extreme = (factor) =>
    makeTrace({
      compression: Float64Array.of(0, 1, 1, 0),
      tangential_velocity: TRACE.tangential_velocity.map((value) => factor * value),
      spring_elongation: TRACE.spring_elongation.map((value) => factor * value),
    });
  for (const trace of [TRACE, still, extreme(1e-322), extreme(1.7e308)]) {
    for (const size of [SIZE, { width: 320, height: 176 }, { width: 800, height: 90 }]) {
      for (const share of [0, 0.3, 0.5, 1]) {
        const scene = contactScene(contactMotion(trace), share, size);
        assert.ok(scene.anchor.x > 0 && scene.anchor.x < size.width);
        assert.ok(scene.shoe.x > 0 && scene.shoe.x < size.width);
        assert.doesNotMatch(`${scene.ball}${scene.spring}${scene.normalArrow.path}`, /NaN|Inf/);
        assert.ok(scene.normalArrow.tip.y > 0);
      }
    }
  }
});

test("mirrored is the same contact of a ball that comes from the other side", () => {
  const back = contactMotion(mirrored(TRACE));
  assert.deepEqual(
    [0, 1.5, 3].map((instant) => stateAt(back, instant).regime),
    ["backward", "sticking", "forward"],
  );
  const [there, here] = [motion, back].map((each) => contactScene(each, 1 / 3, SIZE));
  assert.ok(Math.abs(there.anchor.x + here.anchor.x - SIZE.width) < 1e-9);
  assert.equal(there.normalForce, here.normalForce);
});

test("contactScene has another ball below, flat as far as the foot comes, in place of a wall", () => {
  assert.equal(contactScene(motion, 0.5, SIZE).other, "");
  const [left, at, ...rest] = numbers(contactScene(motion, 0.5, SIZE, false).other);
  const feet = [0, 1].map((share) => contactScene(motion, share, SIZE, false).shoe.x);
  assert.ok(left < Math.min(...feet) && rest.at(-2) > Math.max(...feet));
  assert.equal(at, contactScene(motion, 0.5, SIZE, false).ground);
});
