import assert from "node:assert/strict";
import test from "node:test";
import { ellipseOf, gap, kept, resampled } from "./geometry.js";
import { REACH, aligned, dragged, gridNode, locked, looseEnds, mayShow, meant, settled, snapped, stamped, tidied, undrawn } from "./tidy.js";

/* a small generator of numbers, the same each time */
function numbers(seed) {
  let state = seed;
  return () => { state = (state * 1103515245 + 12345) % 2147483648; return state / 2147483648 - 0.5; };
}

function path(a, b, wobble, random, count = 40) {
  return Array.from({ length: count + 1 }, (_, k) => [0, 1].map(c => a[c] + (b[c] - a[c]) * k / count + wobble * random()));
}

const arc = (from, to, rx, ry, count = 60) => Array.from({ length: count + 1 }, (_, k) => {
  const t = from + (to - from) * k / count;
  return [200 + rx * Math.cos(t), 200 + ry * Math.sin(t)];
});

test("a wobbly line is straight, whatever its direction", () => {
  const random = numbers(1);
  for (let angle = 0; angle < 6; angle += 0.3) {
    const made = meant(path([200, 200], [200 + 150 * Math.cos(angle), 200 + 150 * Math.sin(angle)], 6, random), 1);
    assert.equal(made.length, 1);
    assert.equal(made[0].length, 2);
  }
});

test("arcs and circles stay round", () => {
  const half = meant(arc(0, Math.PI, 100, 35), 1);
  assert.equal(half.length, 1);
  assert.ok(half[0].length > 6);
  const random = numbers(2);
  const whole = meant(arc(0.3, 6.4, 90, 40).map(p => p.map(c => c + 3 * random())), 1);
  assert.equal(whole.length, 1);
  assert.ok(gap(whole[0][0], whole[0][whole[0].length - 1]) < 1e-9);
  const found = ellipseOf(whole[0]);
  assert.ok(Math.abs(found.axes[0] - 90) < 4 && Math.abs(found.axes[1] - 40) < 4);
});

test("a face drawn in one go becomes its edges", () => {
  const random = numbers(3), corners = [[100, 100], [260, 100], [260, 220], [100, 220], [102, 104]];
  const made = tidied(corners.slice(1).flatMap((p, k) => path(corners[k], p, 3, random)), [], { reach: REACH.mouse, unit: 1 });
  assert.equal(made.length, 4);
  assert.ok(made.every((s, k) => gap(s.points[1], made[(k + 1) % 4].points[0]) < 1e-6));
});

test("a slip is nothing", () => {
  assert.deepEqual(meant([[10, 10], [12, 11]], 1), []);
  assert.deepEqual(meant([[10, 10]], 1), []);
});

test("ends go to ends within reach, a finger's being the longest", () => {
  const strokes = [{ points: [[0, 0], [100, 0]] }];
  assert.deepEqual(snapped([120, 23], strokes, REACH.touch, 1).point, [100, 0]);
  assert.notEqual(snapped([120, 23], strokes, REACH.mouse, 1).kind, "end");
  assert.deepEqual(snapped([120, 23], strokes, REACH.mouse, 2).point, [100, 0]);  // zoomed out
  assert.equal(snapped([50, 3], strokes, REACH.mouse, 1).kind, "line");
});

test("no line is drawn over one that is there", () => {
  const strokes = [{ points: [[0, 0], [60, -50]] }];
  const { points } = settled([[2, 1], [68, -42]], strokes, { reach: REACH.touch, unit: 1 });
  assert.deepEqual(points[0], [0, 0]);
  assert.notDeepEqual(points[1], [60, -50]);
});

test("a line nearly along another runs along it, one far from it does not", () => {
  const strokes = [{ points: [[0, 0], [120, 50]] }];
  const to = aligned([10, 100], [128, 156], strokes, REACH.mouse);
  assert.ok(Math.abs(to[0] - 130) < 1e-9 && Math.abs(to[1] - 150) < 1e-9);
  assert.deepEqual(aligned([10, 100], [128, 180], strokes, REACH.mouse), [128, 180]);
});

test("the lock keeps to the axes of the grid", () => {
  assert.deepEqual(locked([0, 0], [50, 9]).map(Math.round), [50, 0]);
  const [x, y] = locked([0, 0], [80, 40], { kind: "isometric", cell: 20 });
  assert.ok(Math.abs(y / x - Math.tan(Math.PI / 6)) < 1e-9);
});

test("the grid's nodes", () => {
  assert.deepEqual(gridNode([33, 8], { kind: "square", cell: 20 }), [40, 0]);
  const [x, y] = gridNode([17, 11], { kind: "isometric", cell: 20 });
  assert.ok(Math.abs(x - 20 * Math.cos(Math.PI / 6)) < 1e-9 && y === 10);
});

test("a hand-drawn box is closed at all eight corners", () => {
  const front = [[100, 160], [240, 160], [240, 280], [100, 280]], d = [60, -45];
  for (let seed = 1; seed <= 20; seed++) {
    const random = numbers(seed), miss = p => p.map(c => c + 12 * random());
    let strokes = [];
    const draw = (a, b) => { strokes = [...strokes, ...tidied(path(miss(a), miss(b), 4, random), strokes, { reach: REACH.mouse, unit: 1 })]; };
    front.forEach((p, k) => draw(p, front[(k + 1) % 4]));
    front.forEach(p => draw(p, p.map((c, j) => c + d[j])));
    front.forEach((p, k) => draw(p.map((c, j) => c + d[j]), front[(k + 1) % 4].map((c, j) => c + d[j])));
    assert.equal(strokes.length, 12, `seed ${seed}`);
    const places = [];
    for (const s of strokes) for (const e of s.points) if (!places.some(q => gap(q, e) < 1e-6)) places.push(e);
    assert.equal(places.length, 8, `seed ${seed}`);
    assert.deepEqual(looseEnds(strokes, 40), []);
  }
});

test("loose ends are told, and which two were meant to meet", () => {
  const strokes = [{ points: [[0, 0], [100, 0]] }, { points: [[115, 8], [120, 90]] }];
  const ends = looseEnds(strokes, 40);
  assert.equal(ends.length, 4);
  assert.equal(ends.filter(e => e.other).length, 2);
});

test("an end that nearly meets a corner of others is told, but not of its own", () => {
  const corner = [{ points: [[0, 0], [100, 0]] }, { points: [[100, 0], [100, 90]] }];
  const [short] = looseEnds([...corner, { points: [[120, 12], [300, 200]] }], 40).filter(e => e.point[0] === 120);
  assert.deepEqual([short.other, short.held], [[100, 0], true]);
  const [own] = looseEnds([...corner, { points: [[100, 0], [120, 12]] }], 40).filter(e => e.point[0] === 120);
  assert.deepEqual([own.other, own.held], [null, false]);
});

test("edges that nobody drew", () => {
  const strokes = [{ points: [[0, 0], [100, 0]] }];
  assert.deepEqual(undrawn([[[0, 1], [100, 1]], [[0, 0], [0, 80]]], strokes, 5), [[[0, 0], [0, 80]]]);
});

test("a corner that is dragged takes all its strokes along", () => {
  const strokes = [{ points: [[0, 0], [100, 0]] }, { points: [[100, 0], [100, 90]] }, { points: [[0, 0], [0, 90]] }];
  const next = dragged(strokes, [100, 0], [120, -10]);
  assert.deepEqual(next.map(s => s.points), [[[0, 0], [120, -10]], [[120, -10], [100, 90]], [[0, 0], [0, 90]]]);
});

test("a locked line ends on its axis unless an end is there", () => {
  const { points } = settled([[0, 0], [100, 30]], [], { reach: REACH.mouse, unit: 1, lock: true });
  assert.deepEqual(points.map(p => p.map(Math.round)), [[0, 0], [100, 0]]);
});

test("simplifying and resampling keep the ends", () => {
  const line = path([0, 0], [90, 40], 0, numbers(1));
  assert.deepEqual(kept(line, 1), [0, 40]);
  const even = resampled(line, 10);
  assert.deepEqual(even[even.length - 1], [90, 40]);
  assert.ok(even.slice(1, -1).every((p, k) => Math.abs(gap(p, even[k]) - 10) < 1e-6));
});

test("strokes keep the time and the pressure of the pen", () => {
  const drawn = [[0, 0, 0, 0.5], [50, 0, 100, 0.7], [100, 0, 300, 0.6]];
  assert.deepEqual(stamped([{ points: [[0, 0], [100, 0]], dashed: true }], drawn), [{ points: [[0, 0, 0, 0.6], [100, 0, 300, 0.6]], dashed: true }]);
  const two = stamped([{ points: [[0, 0], [50, 0]] }, { points: [[50, 0], [50, 50]] }], drawn.map(p => p.slice(0, 3)));
  assert.deepEqual(two.map(s => s.points.map(p => p[2])), [[0, 150], [150, 300]]);
});

test("a cylinder or a cone needs fewer strokes than a box", () => {
  const line = { points: [[0, 0], [10, 0]] }, round = { points: [[0, 0], [5, 5], [10, 0]] };
  assert.ok(!mayShow([]) && !mayShow(Array(4).fill(line)) && mayShow(Array(5).fill(line)));
  assert.ok(!mayShow([round, line]) && mayShow([round, line, line]));
});
