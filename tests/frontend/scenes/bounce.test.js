import assert from "node:assert/strict";
import { test } from "node:test";

import { learn } from "../../../frontend/format/words.js";
import { createBallLoad } from "../../../frontend/state/loading/collision-load.js";
import { isEnoughBall } from "../../../frontend/scenes/explorer/wishes.js";
import { cameraAt, closenessAt, timeOf } from "../../../frontend/scenes/explorer/bounce/clock.js";
import { clockOf, phaseAt, shareAt } from "../../../frontend/scenes/explorer/bounce/clock.js";
import { courseOf } from "../../../frontend/scenes/explorer/bounce/course.js";
import { marksOf } from "../../../frontend/scenes/explorer/bounce/marks.js";
import { angleOf, motionsOf, speedOf } from "../../../frontend/scenes/explorer/bounce/motions.js";
import { bounceInWords } from "../../../frontend/scenes/explorer/bounce/motions.js";
import { wordsOf } from "../locales.js";

learn(wordsOf("en"));

const SIZE = { width: 600, height: 200 };
const WALL = { mass_share: 1, centre_change: -2 / 7, spin_change: 5 / 7 };
const SPHERE = { mass_share: 0.5, centre_change: -1 / 7, spin_change: 5 / 14 };
const ONCE = { isWall: true, times: 1, floor: 14 };
const TWICE = { ...ONCE, times: 2 };

const bounced = (factors, spinShare, ...collided) =>
  motionsOf(
    factors,
    spinShare,
    collided.map(([gtOverGn, epsilonT, epsilonN = 1]) => ({ gtOverGn, epsilonT, epsilonN })),
  );
const near = (a, b, tolerance = 1e-9) => assert.ok(Math.abs(a - b) < tolerance, `${a} and ${b}`);

test("motionsOf leaves a smooth ball as it came, and lets one roll whose surfaces are stopped", () => {
  const [before, after] = bounced(WALL, 0.25, [1.2, 1]);
  assert.deepEqual(after, { ...before, normal: 1 });
  const [, rolls] = bounced(WALL, 0, [1.2, 0]);
  near(rolls.centre, rolls.spin);
});

test("motionsOf shares a velocity of the surfaces between travel and spin", () => {
  for (const share of [0, 0.3, 1]) {
    const [before] = bounced(SPHERE, share, [0.8, -0.5]);
    near(before.centre - before.spin, 0.5 * 0.8);
    near(before.spin, -share * 0.5 * 0.8);
    assert.equal(before.normal, -0.5);
  }
});

test("motionsOf goes on with what a bounce has left, in units of the first approach", () => {
  const [, after, again] = bounced(WALL, 0, [1, -0.5, 0.8], [-0.5 / 0.8, 0, 0.9]);
  near(again.normal, 0.72);
  near(again.centre - again.spin, 0);
  near(again.centre - after.centre, (-2 / 7) * -0.5);
});

test("angleOf counts from the normal, and back where it leads back", () => {
  near(angleOf({ normal: -1, centre: 1, spin: 0 }), 45);
  near(angleOf({ normal: 1, centre: -1, spin: 0 }), -45);
  near(speedOf({ normal: -3, centre: 4, spin: 9 }), 5);
});

test("clockOf gives the contact the larger half, once and twice", () => {
  for (const times of [1, 2]) {
    const { stretches } = clockOf(times);
    assert.deepEqual(
      stretches.map(({ kind }) => kind),
      times === 1
        ? ["flight", "contact", "flight"]
        : ["flight", "contact", "flight", "contact", "flight"],
    );
    near(stretches.at(-1).to, 1);
    const contact = stretches
      .filter(({ kind }) => kind === "contact")
      .reduce((sum, { from, to }) => sum + to - from, 0);
    assert.ok(contact > 0.5);
  }
});

test("phaseAt and shareAt are inverse in every contact, and the ends belong to flights", () => {
  const { stretches } = clockOf(2);
  for (const index of [0, 1]) {
    const phase = phaseAt(stretches, shareAt(stretches, index, 0.3));
    assert.deepEqual([phase.kind, phase.index], ["contact", index]);
    near(phase.progress, 0.3);
  }
  assert.deepEqual([phaseAt(stretches, 0).progress, phaseAt(stretches, 0).index], [0, 0]);
  near(phaseAt(stretches, 1).progress, 1);
  assert.equal(phaseAt(stretches, 1).index, 2);
});

test("courseOf lets the ball touch the wall at the angles of its motions, within the picture", () => {
  for (const [gt, epsilon, share] of [
    [1.1, -0.3, 0],
    [4, 0.3, 0],
    [0, 1, 0],
    [1000, 0.99, 1],
    [0.01, -1, 0.5],
    [1.7e308, -1, 0],
  ]) {
    const motions = bounced(WALL, share, [gt, epsilon]);
    const course = courseOf(motions, ONCE, SIZE);
    const { radius, ground, touches } = course;
    const [start, touch, left, end] = [
      [0, 0],
      [0, 1],
      [1, 0],
      [1, 1],
    ].map(([flight, progress]) => course.at(flight, progress));
    assert.equal(ground, SIZE.height - ONCE.floor);
    near(touch.y, ground - radius);
    near(touch.x, touches[0], 1e-6);
    assert.deepEqual([left.x, left.y], [touch.x, touch.y]);
    for (const { x, y } of [start, end, ...course.ghosts]) {
      assert.ok(x >= radius && x <= SIZE.width - radius && y >= radius && y <= ground - radius);
    }
    if (gt < 1e100) {
      near(
        Math.atan2(end.x - touch.x, touch.y - end.y),
        (Math.PI / 180) * angleOf(motions[1]),
        1e-6,
      );
      near(
        Math.atan2(touch.x - start.x, touch.y - start.y),
        (Math.PI / 180) * angleOf(motions[0]),
        1e-6,
      );
    }
  }
});

test("courseOf turns a ball that rolls by what it goes", () => {
  const motions = bounced(WALL, 0, [1, 0]);
  const course = courseOf(motions, ONCE, SIZE);
  const [from, to] = [0, 0.5].map((progress) => course.at(1, progress));
  near((Math.PI / 180) * (to.turn - from.turn) * course.radius, to.x - from.x, 1e-6);
});

test("courseOf bends the way between two bounces, and comes back to the wall", () => {
  const motions = bounced(WALL, 0, [1, -0.5, 0.9], [-0.5 / 0.9, 0.2, 0.9]);
  const course = courseOf(motions, TWICE, SIZE);
  const [begin, top, end] = [0, 0.5, 1].map((progress) => course.at(1, progress));
  near(begin.y, course.ground - course.radius);
  near(end.y, begin.y);
  assert.ok(top.y < begin.y - course.radius);
  near(end.x, course.touches[1], 1e-6);
  near(course.at(2, 0).x, end.x, 1e-6);
  near(course.at(2, 0).turn, end.turn, 1e-6);
});

test("courseOf shows what is known while the second bounce is on its way", () => {
  const motions = bounced(WALL, 0, [1, -0.5]);
  const course = courseOf(motions, TWICE, SIZE);
  assert.equal(course.marked.length, 2);
  assert.equal(course.touches.length, 1);
});

test("courseOf has the other ball mirror it about the touch, in the middle", () => {
  const { ground, touches } = courseOf(
    bounced(SPHERE, 0, [1, 0]),
    { ...ONCE, isWall: false },
    SIZE,
  );
  assert.deepEqual([touches[0], ground], [300, 100]);
});

test("marksOf bends the arrow of a spin, and has none where there is none", () => {
  const course = courseOf(bounced(WALL, 0, [1, 0]), ONCE, SIZE);
  const [comes, leaves] = marksOf(course).map(({ lines }) =>
    Object.fromEntries(lines.map(({ name, path }) => [name, path])),
  );
  assert.equal(comes.spin, "");
  assert.match(leaves.spin, /^M.*A/);
  assert.match(comes.velocity, new RegExp(`L${course.touches[0].toFixed(0)}`));
});

test("marksOf tells both angles apart where the ball goes back beside its way", () => {
  const course = courseOf(bounced(WALL, 5 / 7, [1, -0.9]), ONCE, SIZE);
  const [comes, leaves] = marksOf(course).map(({ label }) => label);
  assert.ok(Math.hypot(comes.x - leaves.x, comes.y - leaves.y) > 12);
  assert.notEqual(comes.isLeft, leaves.isLeft);
});

test("closenessAt goes into the contact as the ball touches, and out of it", () => {
  const at = (share, times = 1) => closenessAt(phaseAt(clockOf(times).stretches, share), times);
  assert.deepEqual(
    [0, 0.5, 1].map((share) => at(share).closeness),
    [0, 1, 0],
  );
  const [before, after] = [0.199, 0.801].map((share) => at(share));
  assert.ok(before.closeness > 0.99 && !before.isEnd);
  assert.ok(after.closeness > 0.99 && after.isEnd);
  const { stretches } = clockOf(2);
  const between = stretches[2];
  assert.equal(at(between.from + 0.001, 2).touch, 0);
  assert.equal(at(between.to - 0.001, 2).touch, 1);
  assert.equal(at((between.from + between.to) / 2, 2).closeness, 0);
});

test("timeOf slows down towards every touch and goes through a flight once", () => {
  for (const [index, times] of [
    [0, 1],
    [1, 1],
    [1, 2],
  ]) {
    assert.deepEqual([timeOf(0, index, times), timeOf(1, index, times)], [0, 1]);
  }
  assert.ok(1 - timeOf(0.9, 0, 1) < 0.05);
  assert.ok(timeOf(0.1, 1, 1) < 0.05);
});

test("cameraAt ends where the contact's own ball lies on the one that flew", () => {
  const course = courseOf(bounced(WALL, 0, [1, 0]), ONCE, SIZE);
  const close = { x: 250, y: 156, radius: 150 };
  const [, x, y, scale, fromX, fromY] = cameraAt(course, 0, close, 1)
    .transform.match(/translate\((.*),(.*)\)scale\((.*)\)translate\((.*),(.*)\)/)
    .map(Number);
  near(scale * course.radius, close.radius, 0.02);
  near(x + scale * (course.touches[0] + fromX), close.x, 0.05);
  near(y + scale * (course.ground + fromY), close.y, 0.05);
  assert.equal(cameraAt(course, 0, close, 0).contact, 0);
  assert.equal(cameraAt(course, 0, close, 1).contact, 1);
});

test("bounceInWords says how it comes and leaves", () => {
  assert.equal(
    bounceInWords(bounced(WALL, 0, [1.4, -0.3])),
    "A ball comes in at 54° without spin, leaves at 41° turning forward.",
  );
  assert.match(
    bounceInWords(bounced(WALL, 1, [1.1, -0.3])),
    /at 0° turning backward, goes back at 22°/,
  );
  assert.match(bounceInWords(bounced(WALL, 0, [1, 0], [0, 1])), /The second time it leaves at 36°/);
});

test("createBallLoad asks for the next collision and its trace where the ball falls back", async () => {
  const asked = [];
  const second = { kappa: 5, mu_over_alpha: 1.4, gt_over_gn: 0.3, damping: 0, direction: -1 };
  const server = {
    bounce: async () => ({ ...WALL, second }),
    trace: async (collision) => {
      asked.push(collision);
      return { kappa: collision.kappa };
    },
  };
  const load = createBallLoad({ of: () => server });
  const wish = { collision: { kappa: 4.5 }, alpha: 2 / 7, partner: "wall", spinShare: 0 };
  assert.equal((await load({ ...wish, times: 1 })).trace, null);
  assert.deepEqual((await load({ ...wish, times: 2 })).trace, { kappa: 5 });
  assert.deepEqual(asked, [second]);
});

test("isEnoughBall: the factors hold for all collisions of a body, the next collision does not", () => {
  const ball = {
    collision: { kappa: 1, mu_over_alpha: 1, gt_over_gn: 1, damping: 0 },
    alpha: 2 / 7,
    partner: "wall",
    spinShare: 0,
    times: 1,
  };
  const moved = { ...ball, collision: { ...ball.collision, kappa: 2 }, spinShare: 0.5 };
  assert.ok(isEnoughBall(ball, moved));
  assert.ok(!isEnoughBall(ball, { ...moved, alpha: 0.4 }));
  assert.ok(!isEnoughBall(ball, { ...moved, partner: "sphere" }));
  assert.ok(!isEnoughBall(ball, { ...ball, times: 2 }));
  const twice = { ...ball, times: 2 };
  assert.ok(isEnoughBall(twice, { ...twice, spinShare: 0.5 }));
  assert.ok(!isEnoughBall(twice, { ...moved, times: 2 }));
});
