import assert from "node:assert/strict";
import test from "node:test";
import { begun } from "./begun.js";

const line = (...points) => ({ points });
const SQUARE = [line([0, 0], [100, 0]), line([0, 80], [0, 0]), line([100, 0], [100, 80]), line([100, 80], [0, 80])];

test("a closed face and one edge that leaves it are a solid", () => {
  assert.equal(begun(SQUARE, 1), null);
  const { f1, f2 } = begun([...SQUARE, line([160, -40], [100, 0])], 1);
  assert.equal(f1.length, 4);
  f1.forEach((p, k) => assert.deepEqual(f2[k], [p[0] + 60, p[1] - 40]));
});

test("edges may come before the face, stray a little, and the other face may have begun", () => {
  const edges = [line([0, 0], [60, -40]), line([100, 0], [166, -38])];
  const found = begun([...edges, ...SQUARE, line([60, -40], [166, -38])], 1);
  const at = p => found.f2[found.f1.findIndex(q => q[0] === p[0] && q[1] === p[1])];
  assert.deepEqual([at([0, 0]), at([100, 0]), at([0, 80])], [[60, -40], [166, -38], [63, 41]]);
});

test("edges that run together, lines elsewhere and curves are no such beginning", () => {
  const apex = [line([0, 0], [50, -60]), line([100, 0], [50, -60])];
  assert.equal(begun([...SQUARE, ...apex], 1), null);
  assert.equal(begun([...SQUARE, line([0, 0], [60, -40]), line([300, 0], [300, 90])], 1), null);
  assert.equal(begun([...SQUARE, line([0, 0], [60, -40]), { points: [[0, 0], [4, 9], [9, 9]] }], 1), null);
  assert.equal(begun([...SQUARE, line([0, 0], [5, -5])], 1), null);
});
