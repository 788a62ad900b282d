import assert from "node:assert/strict";
import { test } from "node:test";

import { createPlayback } from "../../../frontend/scenes/explorer/bounce/playback.js";

/** A playback whose frames come when the test says so. */
function makePlayback() {
  const shares = [];
  const playing = [];
  let waiting = [];
  const playback = createPlayback({
    onShare: (share) => shares.push(share),
    onPlaying: (is) => playing.push(is),
    nextFrame: (task) => waiting.push(task),
    duration: () => 4000,
    initial: 0.25,
  });
  const frame = (now) => {
    const due = waiting;
    waiting = [];
    due.forEach((task) => task(now));
  };
  return { playback, playing, shares, frame };
}

test("createPlayback runs from where it is to the end and stops there", () => {
  const { playback, playing, frame } = makePlayback();
  playback.play();
  frame(1000);
  assert.equal(playback.share(), 0.25);
  frame(2000);
  assert.equal(playback.share(), 0.5);
  frame(9000);
  assert.equal(playback.share(), 1);
  assert.deepEqual(playing, [true, false]);
});

test("createPlayback begins anew when it is played at the end", () => {
  const { playback, frame } = makePlayback();
  playback.seek(1);
  playback.play();
  frame(0);
  assert.equal(playback.share(), 0);
});

test("createPlayback runs at the speed that is wished for", () => {
  const { playback, frame } = makePlayback();
  playback.setSpeed(0.25);
  playback.play();
  frame(0);
  frame(1000);
  assert.equal(playback.share(), 0.3125);
});

test("createPlayback pauses for a hand and never runs twice", () => {
  const { playback, shares, frame } = makePlayback();
  playback.play();
  playback.seek(0.75);
  assert.equal(playback.isPlaying(), false);
  playback.play();
  frame(0);
  const before = shares.length;
  frame(400);
  assert.equal(shares.length, before + 1);
  assert.ok(Math.abs(playback.share() - 0.85) < 1e-12);
});
