import assert from "node:assert/strict";
import test from "node:test";
import { Live } from "./live.js";
import { areEdges } from "./marks.js";

const lines = n => Array.from({ length: n }, (_, k) => ({ points: [[k, 0], [k, 9]] }));

/* a search whose answers come when they are told to */
function setting(early = null) {
  const asked = [], shown = [], failed = [], signs = [];
  const live = new Live({
    ask: (strokes, signal) => new Promise((answer, fail) => asked.push({ strokes, signal, fail, answer: () => answer({ objects: [{}], of: strokes.length }) })),
    early: async () => early, show: async found => { shown.push(found.of); }, none: strokes => shown.push(-strokes.length), failed: e => failed.push(e), busy: is => signs.push(is),
  });
  return { live, asked, shown, failed, signs };
}
const settle = ms => new Promise(done => setTimeout(done, ms));

test("the newest strokes are asked for at once, and only their answer is shown", async () => {
  const { live, asked, shown, failed } = setting();
  live.follow(lines(6));
  live.follow(lines(7));
  await settle(1);
  assert.deepEqual(asked.map(a => [a.strokes.length, a.signal.aborted]), [[6, true], [7, false]]);
  asked[1].answer();
  asked[0].fail(new Error("aborted"));
  await settle(1);
  assert.deepEqual([shown, failed.length, live.busy, live.waits.length], [[7], 0, false, 1]);
});

test("an answer on its way when the last strokes are rubbed out is not shown", async () => {
  const { live, asked, shown } = setting();
  live.follow(lines(6));
  live.follow(lines(2));
  asked[0].answer();
  await settle(1);
  assert.deepEqual(shown, [-2]);
});

test("strokes that the solid has already are searched once the pen rests", async () => {
  const { live, asked, shown } = setting();
  live.follow(lines(6), true);
  await settle(50);
  assert.deepEqual([asked.length, live.waits.length, live.busy, live.searching()], [0, 1, true, false]);
  await settle(450);
  asked[0].answer();
  await settle(1);
  assert.deepEqual([shown, live.waits.length, live.busy], [[6], 1, false]);
});

test("what is begun is shown at once, and the search's answer after it", async () => {
  const { live, asked, shown } = setting({ objects: [{}], of: "begun" });
  live.follow(lines(6));
  await settle(1);
  assert.deepEqual([shown, live.waits.length, live.searching(), live.busy], [["begun"], 1, false, true]);
  asked[0].answer();
  await settle(1);
  assert.deepEqual([shown, live.waits.length, live.busy], [["begun", 6], 1, false]);
});

test("what is begun is not shown once newer strokes are there", async () => {
  const { live, asked, shown } = setting({ objects: [{}], of: "begun" });
  live.follow(lines(6));
  live.follow(lines(2));
  asked[0].answer();
  await settle(1);
  assert.deepEqual(shown, [-2]);
});

test("what goes wrong is told, and a long wait shows a sign", async () => {
  const { live, asked, failed, signs } = setting();
  live.follow(lines(6));
  await settle(350);
  assert.deepEqual(signs, [true]);
  asked[0].fail(new Error("no answer"));
  await settle(1);
  assert.deepEqual([failed.length, signs], [1, [true, false]]);
  live.follow(lines(6));
  live.stop();
  asked[1].answer();
  await settle(1);
  assert.ok(!live.busy);
});

test("strokes along edges of the solid that were not drawn are told from others", () => {
  const box = { f1: [[0, 0], [100, 0], [100, 80], [0, 80]], f2: [[60, -40], [160, -40], [160, 40], [60, 40]], holes: [] };
  const line = (...points) => ({ points });
  assert.ok(areEdges([line([58, 43], [63, -38]), line([159, 42], [61, 38])], box, 1));
  assert.ok(!areEdges([line([60, 40], [60, -40]), line([60, -40], [60, 40])], box, 1));
  assert.ok(!areEdges([line([0, 0], [100, 80])], box, 1));
  assert.ok(!areEdges([line([0, 0], [50, 0])], box, 1));
  assert.ok(!areEdges([line([0, 0], [50, 30], [100, 0])], box, 1));
});
