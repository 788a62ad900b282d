import assert from "node:assert/strict";
import { beforeEach, mock, test } from "node:test";

import { createLatest } from "../../../../frontend/state/loading/latest.js";

/** A load that ends when the test says so. */
function slowLoad() {
  const calls = [];
  const load = (wish, signal) =>
    new Promise((resolve, reject) => {
      calls.push({ wish, signal, resolve, reject });
      signal.addEventListener("abort", () => reject(signal.reason));
    });
  return { calls, load };
}

/** Lets the promises that are settled be heard. */
const settled = () => new Promise((resolve) => setImmediate(resolve));

let slow;
let answers;
let errors;
let options;

beforeEach(() => {
  slow = slowLoad();
  answers = [];
  errors = [];
  options = {
    load: slow.load,
    onAnswer: (answer, wish) => answers.push([answer, wish]),
    onError: (error, wish) => errors.push([error.message, wish]),
  };
});

test("createLatest has one request under way and then asks for the newest wish alone", async () => {
  const { request } = createLatest(options);
  [1, 2, 3, 4].forEach(request);
  assert.deepEqual(
    slow.calls.map(({ wish }) => wish),
    [1],
  );
  slow.calls[0].resolve("one");
  await settled();
  assert.deepEqual(
    slow.calls.map(({ wish }) => wish),
    [1, 4],
  );
  slow.calls[1].resolve("four");
  await settled();
  assert.deepEqual(answers, [
    ["one", 1],
    ["four", 4],
  ]);
  assert.equal(slow.calls.length, 2);
});

test("createLatest goes on after an error", async () => {
  const { request } = createLatest(options);
  request(1);
  request(2);
  slow.calls[0].reject(new Error("broken"));
  await settled();
  slow.calls[1].resolve("two");
  await settled();
  assert.deepEqual(errors, [["broken", 1]]);
  assert.deepEqual(answers, [["two", 2]]);
});

test("createLatest gives up what takes too long once there is a newer wish, and drops its late answer", async () => {
  const { request } = createLatest({ ...options, patience: -1 });
  request(1);
  request(2);
  assert.ok(slow.calls[0].signal.aborted);
  slow.calls[0].resolve("late");
  slow.calls[1].resolve("two");
  await settled();
  assert.deepEqual(answers, [["two", 2]]);
  assert.deepEqual(errors, []);
});

test("createLatest keeps its pause between two starts, by what the first one took", async (context) => {
  context.after(() => mock.timers.reset());
  mock.timers.enable({ apis: ["setTimeout"] });
  let now = 1000;
  context.mock.method(performance, "now", () => now);
  const { request } = createLatest({ ...options, pause: (took, wish) => 8 * took * wish });
  request(1);
  now += 10;
  slow.calls[0].resolve("one");
  await settled();
  request(2);
  request(3);
  assert.equal(slow.calls.length, 1);
  now += 70;
  mock.timers.tick(70);
  assert.deepEqual(
    slow.calls.map(({ wish }) => wish),
    [1, 3],
  );
});

test("what is urgent overtakes what is not, and waits for what is", async () => {
  const begun = [];
  const answered = [];
  const waiting = [];
  const latest = createLatest({
    load(wish, signal) {
      begun.push(wish);
      return new Promise((resolve) => waiting.push({ resolve: () => resolve(wish), signal }));
    },
    onAnswer: (answer) => answered.push(answer),
    onError: assert.fail,
    isUrgent: (wish) => wish.startsWith("drag"),
  });
  latest.request("rest");
  latest.request("drag 1");
  latest.request("drag 2");
  assert.deepEqual(begun, ["rest", "drag 1"]);
  assert.ok(waiting[0].signal.aborted && !waiting[1].signal.aborted);
  waiting[0].resolve();
  waiting[1].resolve();
  await new Promise((resolve) => setTimeout(resolve));
  assert.deepEqual(begun, ["rest", "drag 1", "drag 2"]);
  assert.deepEqual(answered, ["drag 1"]);
});
