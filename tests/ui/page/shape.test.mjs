import assert from "node:assert/strict";
import test from "node:test";
import { byHand, corrections, deleted, edgePoints, fromCorrections, fronted, inserted, moved, newObject, outline, shifted, swapped, withWishes } from "./shape.js";
import { lengthOf, measure, shown } from "./sizes.js";

const F1 = [[0, 100], [100, 100], [100, 200], [0, 200]], F2 = F1.map(([x, y]) => [x + 60, y - 40]);
const state = () => ({ objects: [newObject(F1, F2)], loose: [] });

test("lengths as people type them", () => {
  assert.deepEqual(lengthOf("40", "mm"), { value: 40, unit: "mm" });
  assert.deepEqual(lengthOf(" 40,5 ", "cm"), { value: 40.5, unit: "cm" });
  assert.deepEqual(lengthOf("1.5in", "mm"), { value: 1.5, unit: "in" });
  assert.equal(lengthOf("", "mm"), null);
  for (const bad of ["-3", "0", "abc", "4 5", "1e3", "40 px", "1,000.5"]) assert.equal(lengthOf(bad, "mm"), undefined, bad);
  assert.equal(shown(12.34567), "12.35");
  assert.equal(measure(180.4, "px"), "180");
});

test("all three sizes go into the corrections", () => {
  const s = state();
  s.objects[0].sizes = { width: "40", height: "25.5", depth: "60" };
  s.objects[0].reading = 2;
  const [o] = corrections(s, 500, 400).objects;
  assert.deepEqual([o.width, o.height, o.depth, o.reading], ["40mm", "25.5mm", "60mm", 2]);
});

test("a side of a box becomes its front, in matching order", () => {
  const next = fronted(state(), [130, 130]).objects[0];  // the side on the right
  assert.deepEqual(new Set(next.f1.map(String)), new Set([F1[1], F1[2], F2[2], F2[1]].map(String)));
  for (const k of [0, 1, 2, 3]) {
    const d = [0, 1].map(c => next.f2[k][c] - next.f1[k][c]);
    assert.deepEqual(d, [-100, 0]);
  }
});

const read = data => fromCorrections(data, state(), "a/b.png", 500, 400);

test("corrections of every documented form are read", () => {
  const points = [...F1, ...F2];
  assert.deepEqual(read({ objects: [{ f1: F1, d: [60, -40] }] }).objects[0].f2, F2);
  assert.deepEqual(read({ objects: [{ vertices: points, f1: [0, 1, 2, 3], f2: [4, 5, 6, 7] }] }).objects[0].f2, F2);
  assert.equal(read({ objects: [{ projection: "axonometric" }] }).objects[0].projection, "axonometric");
  assert.equal(read({ objects: [{ projection: { family: "oblique" }, f1: F1, f2: F2 }] }).objects[0].projection, "oblique");
  assert.deepEqual(read({ pictures: { "b.png": { objects: [{ width: "40mm", depth: 20 }] } } }).objects[0].sizes, { width: "40", height: "", depth: "20" });
  assert.deepEqual(read({ width: 250, height: 200, objects: [{ f1: F1, f2: F2 }] }).objects[0].f1[1], [200, 200]);
  const hole = F1.map(([x, y]) => [x / 2 + 20, y / 2 + 70]);
  assert.deepEqual(read({ objects: [{ f1: F1, f2: F2, holes: [{ f1: hole }] }] }).objects[0].holes[0].f2[0], [hole[0][0] + 60, hole[0][1] - 40]);
});

test("what is no corrections file is refused as a whole", () => {
  for (const bad of [null, {}, { objects: 3 }, { objects: [{ f1: F1 }] }, { objects: [{ f1: F1, f2: F2.slice(1) }] }, { objects: [{}, {}] }, { objects: [{ width: "wide" }] }, { pictures: { "c.png": {} } }, { objects: [null] }]) {
    assert.throws(() => read(bad), Error, JSON.stringify(bad));
  }
});

test("wishes stay with the object at their place, a reading only with the same solid", () => {
  const before = [{ ...newObject(F1, F2), projection: "oblique", unit: "cm", reading: 3 }];
  const [o] = withWishes([{ f1: F2, f2: F1, holes: [], lines: "wire" }], before, [4]);
  assert.deepEqual([o.projection, o.unit, o.reading], ["oblique", "cm", 1]);
  assert.deepEqual(shifted({ objects: [o], loose: [{ x: 1, y: 2, face: 0 }] }, 10, 20).loose, [{ x: 11, y: 22, face: 0 }]);
  const again = { f1: F1.map(([x, y]) => [x + 2, y - 1]), f2: F2, holes: [] }, reading = (found, ways) => withWishes([found], before, ways)[0].reading;
  assert.equal(reading(again, [4]), 3);
  assert.equal(reading({ ...again, f1: [...F1.slice(1), F1[0]] }, [4]), 3, "the ring begins elsewhere");
  assert.equal(reading(again, [2]), 1, "there are only two");
  assert.equal(reading({ ...again, f1: F1.map(([x, y], k) => [x + (k ? 0 : 40), y]) }, [4]), 1, "a corner is elsewhere");
  assert.equal(reading({ ...again, holes: [{ f1: F1, f2: F2 }] }, [4]), 1, "it has a hole");
});

const SLOT = () => {
  const f1 = [[0, 0], [100, 0], [100, 50], [0, 50]], f2 = f1.map(([x, y]) => [x + 30, y - 20]);
  const half = (face, from, points) => ({ face, hole: null, from, to: (from + 1) % 4, points, ellipse: { center: [0, 25], axes: [25, 25], angle: 0 } });
  const arcs = ["f1", "f2"].flatMap((face, k) => [half(face, 1, [[100, 0], [125, 25], [100, 50]]), half(face, 3, [[0, 50], [-25, 25], [0, 0]])]
    .map(arc => ({ ...arc, points: arc.points.map(([x, y]) => [x + 30 * k, y - 20 * k]) })));
  return { objects: [{ ...newObject(f1, f2), arcs }], loose: [] };
};
const places = object => object.arcs.map(a => `${a.face} ${a.from} ${a.to}`);

test("arcs are kept, go into the corrections and come back", () => {
  const s = SLOT(), [said] = corrections(s, 500, 400).objects;
  assert.equal(said.arcs.length, 4);
  const back = fromCorrections({ ...corrections(s, 500, 400) }, state(), "a.png", 500, 400);
  assert.deepEqual(places(back.objects[0]), places(s.objects[0]));
  const half = fromCorrections(corrections(s, 500, 400), state(), "a.png", 250, 200).objects[0].arcs[0];
  assert.deepEqual([half.points[1], half.ellipse.axes], [[62.5, 12.5], [12.5, 12.5]]);
  assert.equal("arcs" in corrections(state(), 500, 400).objects[0], false);
});

test("outlines follow arcs, and arcs follow their vertices", () => {
  const s = SLOT();
  assert.deepEqual(outline(s.objects[0], 0, 1), [[0, 0], [100, 0], [125, 25], [100, 50], [0, 50], [-25, 25]]);
  const next = moved(s, { object: 0, ring: 0, face: 1, index: 2 }, [100, 100], false);
  assert.deepEqual(edgePoints(next.objects[0], 0, 1, 1), [[100, 0], [150, 50], [100, 100]]);
  assert.deepEqual(shifted(s, 10, 5).objects[0].arcs[0].points[1], [135, 30]);
  assert.deepEqual(places(swapped(s, 0).objects[0]), ["f2 1 2", "f2 3 0", "f1 1 2", "f1 3 0"]);
});

test("arcs keep their edges when vertices come and go", () => {
  const s = SLOT(), edge = { object: 0, ring: 0, face: 1, index: 0, part: 0.5 };
  assert.deepEqual(places(inserted(s, edge, [50, 0]).objects[0]), ["f1 2 3", "f1 4 0", "f2 2 3", "f2 4 0"]);
  assert.deepEqual(places(inserted(s, { ...edge, index: 1 }, [125, 25]).objects[0]), ["f1 4 0", "f2 4 0"]);
  assert.deepEqual(places(deleted(s, { object: 0, ring: 0, face: 1, index: 1 }).objects[0]), ["f1 2 0", "f2 2 0"]);
});

test("whole ellipses and points are read", () => {
  const circle = face => ({ face, hole: null, from: null, to: null, points: [[0, 0], [9, 0], [9, 9], [0, 9]] });
  const one = fromCorrections({ objects: [{ f1: [], f2: [], arcs: [circle("f1"), circle("f2")] }] }, state(), "a.png", 9, 9);
  assert.equal(outline(one.objects[0], 0, 2).length, 4);
  const cone = fromCorrections({ objects: [{ f1: [], f2: [[4, 30]], arcs: [circle("f1")] }] }, state(), "a.png", 9, 9);
  assert.equal(swapped(cone, 0), cone);
  const pyramid = fromCorrections({ objects: [{ f1: F1, f2: [[50, 0]] }] }, state(), "a.png", 9, 9);
  assert.deepEqual(pyramid.objects[0].f2, [[50, 0]]);
  assert.equal(deleted(pyramid, { object: 0, ring: 0, face: 2, index: 0 }), pyramid);
});

test("how an object is drawn goes with it, to and fro, until a hand moves its corners", () => {
  const manner = { lines: "removed", noise: 2, f2_drawn: [true, true, true, false] }, objects = withWishes([{ f1: F1, f2: F2, holes: [], page: null, ...manner }], []);
  const sent = corrections({ ...state(), objects }, 500, 400);
  for (const [name, value] of Object.entries(manner)) assert.deepEqual(sent.objects[0][name], value);
  assert.equal("page" in sent.objects[0], false);
  const same = fromCorrections(sent, state(), "a.png", 500, 400).objects[0], double = fromCorrections(sent, state(), "a.png", 1000, 800).objects[0];
  assert.deepEqual([same.lines, same.noise, double.noise], ["removed", 2, 4]);
  const before = { ...state(), objects }, after = byHand(moved(before, { object: 0, ring: 0, face: 2, index: 3 }, [5, 5], false), before);
  assert.deepEqual([after.objects[0].f2_drawn, after.objects[0].noise, byHand(before, before).objects[0].f2_drawn.length], [undefined, 2, 4]);
});
