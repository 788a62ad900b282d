import assert from "node:assert/strict";
import { test } from "node:test";

import {
  advance,
  courseOf,
  createRun,
  placeAt,
  stepOn,
} from "../../../frontend/page/sweeping/course.js";
import { PARAMETERS } from "../../../frontend/state/parameters.js";
import { sweepOf } from "../../../frontend/state/sweep.js";

const HALF = { from: 0.25, to: 0.75, seconds: 8, once: false };

const near = (found, wanted) =>
  assert.ok(Math.abs(found - wanted) < 1e-9, `${found} is not ${wanted}`);

/** A run whose frames come when the test says so, in ms from its first. */
function makeRun(course) {
  const shares = [];
  let ends = 0;
  let waiting = [];
  const run = createRun({
    course: () => course,
    onShare: (share) => shares.push(share),
    onEnd: () => (ends += 1),
    nextFrame: (task) => waiting.push(task),
  });
  const frame = (now) => {
    const due = waiting;
    waiting = [];
    due.forEach((task) => task(5000 + now));
    return shares.at(-1);
  };
  return { run, shares, frame, ends: () => ends, waiting: () => waiting.length };
}

test("a sweep runs as the slider's own scale does", () => {
  const { scale } = PARAMETERS[0];
  const course = courseOf({ ...sweepOf("kappa"), from: 1, to: 100 }, scale);
  near(scale.fromShare(advance(placeAt(course.from, course), 0.25, course).share), 10);
});

test("a sweep goes there and back in its time, from where the value is, until it is stopped", () => {
  const { run, frame, shares, waiting } = makeRun(HALF);
  run.start(0.5);
  frame(0);
  assert.equal(shares.length, 0);
  near(frame(2000), 0.75);
  near(frame(3000), 0.625);
  near(frame(8000), 0.5);
  near(frame(8000 * 5 + 1000), 0.625);
  run.stop();
  frame(8000 * 5 + 2000);
  assert.equal(shares.length, 4);
  assert.equal(waiting(), 0);
  assert.ok(!run.isRunning());
});

test("a range that is given from its upper end is walked down first", () => {
  const { run, frame } = makeRun({ ...HALF, from: 0.75, to: 0.25 });
  run.start(0.5);
  frame(0);
  near(frame(1000), 0.375);
});

test("a value beyond the range comes in at the same pace", () => {
  const { run, frame } = makeRun(HALF);
  run.start(1);
  frame(0);
  near(frame(1000), 0.875);
  near(frame(4000), 0.5);
});

test("once is there and back to where it was, however late the last frame comes", () => {
  for (const [start, end] of [
    [0.5, 0.5],
    [0, 0.25],
  ]) {
    const { run, frame, ends, waiting } = makeRun({ ...HALF, once: true });
    run.start(start);
    frame(0);
    frame(7000);
    assert.equal(ends(), 0);
    near(frame(60_000), end);
    assert.equal(ends(), 1);
    assert.equal(waiting(), 0);
  }
});

test("a range that is changed on the way holds from there on", () => {
  const course = { ...HALF };
  const { run, frame } = makeRun(course);
  run.start(0.25);
  frame(0);
  near(frame(2000), 0.5);
  Object.assign(course, { to: 0.5, seconds: 4 });
  near(frame(3000), 0.375);
});

test("what is started twice runs once", () => {
  const { run, frame, shares } = makeRun(HALF);
  run.start(0.5);
  frame(0);
  run.start(0.5);
  frame(500);
  frame(1500);
  assert.equal(shares.length, 1);
  near(shares[0], 0.625);
});

test("where nothing is to move by itself, steps go to the ends and turn back there", () => {
  let place = placeAt(0.62, HALF);
  const walked = Array.from({ length: 5 }, () => {
    place = stepOn(place, HALF);
    return Number(place.share.toFixed(9));
  });
  assert.deepEqual(walked, [0.67, 0.72, 0.75, 0.7, 0.65]);
  // from an end to the other, in ten steps
  place = placeAt(0.25, HALF);
  for (let i = 0; i < 10; i += 1) {
    place = stepOn(place, HALF);
  }
  assert.equal(place.share, 0.75);
});
