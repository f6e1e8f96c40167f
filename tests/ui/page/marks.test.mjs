import assert from "node:assert/strict";
import test from "node:test";
import { faults, told } from "./marks.js";

const FRONT = [[0, 0], [200, 0], [200, 150], [0, 150]], BACK = FRONT.map(([x, y]) => [x + 80, y - 60]);
const ring = f => f.map((p, k) => [p, f[(k + 1) % 4]]);
const BOX = [...ring(FRONT), ...ring(BACK), ...FRONT.map((p, k) => [p, BACK[k]])].map(points => ({ points }));
const FOUND = { f1: FRONT, f2: BACK, holes: [], lines: "wire" };

test("a whole drawing has no faults", () => {
  const marks = faults(BOX, FOUND, 1, [], true);
  assert.deepEqual([marks.loose, marks.missing, marks.left], [[], [], []]);
  assert.equal(told(marks), "");
});

test("an edge that is missing is told where it is, unless hidden ones are left out", () => {
  const some = BOX.filter((_, k) => k !== 5);
  assert.deepEqual(faults(some, FOUND, 1).missing, [[BACK[1], BACK[2]]]);
  assert.deepEqual(faults(some, { ...FOUND, lines: "removed" }, 1).missing, []);
});

test("an end that stops short of a corner is told once a solid was found", () => {
  const short = BOX.map((s, k) => k === 0 ? { points: [[30, 0], [200, 0]] } : s);
  assert.equal(told(faults(short, null, 1, [], true)), "1 place where two lines do not meet");
  assert.equal(told(faults(short, null, 1, [], false)), "1 loose end");
});

test("lines that fit nothing are told once no end waits for its line", () => {
  const left = [[[10, 10], [90, 90]]];
  assert.equal(told(faults(BOX, FOUND, 1, left)), "the red line fits no solid");
  assert.deepEqual(faults([...BOX, { points: [[-200, 300], [-100, 300]] }], FOUND, 1, left).left, []);
});
