import assert from "node:assert/strict";
import test from "node:test";
import { ellipsePoints, gap } from "./geometry.js";
import { ellipseIn, evened, overMiddle, pulled, touching } from "./round.js";
import { REACH, settled, tidied } from "./tidy.js";

const hand = { reach: REACH.touch, unit: 1 };
const rim = (x, y, a, b, degrees = 0) => ellipsePoints({ centre: [x, y], axes: [a, b], angle: degrees * Math.PI / 180 }, 60);
const stroke = points => ({ points });
const near = (p, q, most = 0.6) => assert.ok(gap(p, q) < most, `${p} is not near ${q}`);

test("a stroke is known for an ellipse, and a line and a square for none", () => {
  const found = ellipseIn(stroke(rim(200, 100, 90, 30, 20)));
  near(found.centre, [200, 100]);
  assert.ok(Math.abs(found.axes[0] - 90) < 0.5 && Math.abs(found.axes[1] - 30) < 0.5);
  assert.equal(ellipseIn(stroke([[0, 0], [9, 9]])), null);
  const square = [[0, 0], [50, 0], [100, 0], [100, 50], [100, 100], [50, 100], [0, 100], [0, 50], [0, 0]];
  assert.equal(ellipseIn(stroke(square)), null);
});

test("an ellipse nearly level is made level, and one nearly a circle a circle", () => {
  const level = ellipseIn(stroke(evened(rim(200, 100, 90, 30, 3), [], hand)));
  assert.ok(Math.abs(Math.sin(level.angle)) < 1e-3);
  const round = ellipseIn(stroke(evened(rim(200, 100, 90, 85, 40), [], hand)));
  assert.ok(Math.abs(round.axes[0] - round.axes[1]) < 0.1);
  const leaning = ellipseIn(stroke(evened(rim(200, 100, 90, 30, 25), [], hand)));
  assert.ok(Math.abs(leaning.angle % Math.PI - 25 * Math.PI / 180) < 0.01);
});

test("a second ellipse nearly like the first becomes its equal, straight across", () => {
  const first = stroke(rim(200, 300, 90, 30)), second = ellipseIn(stroke(evened(rim(206, 100, 86, 33, 2), [first], hand)));
  near(second.centre, [200, 100], 1);
  assert.ok(Math.abs(second.axes[0] - 90) < 0.3 && Math.abs(second.axes[1] - 30) < 0.3);
});

test("an ellipse of another size, or within another, keeps its size", () => {
  const first = stroke(rim(200, 300, 90, 30));
  assert.ok(Math.abs(ellipseIn(stroke(evened(rim(200, 100, 50, 17), [first], hand))).axes[0] - 50) < 0.3);
  assert.ok(Math.abs(ellipseIn(stroke(evened(rim(200, 302, 82, 28), [first], hand))).axes[0] - 82) < 0.3);
});

test("a line beside two ellipses touches both", () => {
  const rims = [stroke(rim(200, 300, 90, 30)), stroke(rim(200, 100, 90, 30))];
  const { points: [a, b] } = settled([[284, 96], [296, 305]], rims, hand);
  near(a, [290, 100]);
  near(b, [290, 300]);
});

test("a line from a point touches the ellipse where its tangent does", () => {
  const base = stroke(rim(200, 300, 80, 40)), [a, b] = touching([[275, 290], [200, 100]], [base], hand, [null, [200, 100]]);
  near(b, [200, 100], 1e-6);
  // the tangent from (0, 200) above the middle: x = a cos t, y = b sin t with sin t = b / 200
  near(a, [200 + 80 * Math.cos(Math.asin(0.2)), 300 - 40 * 0.2]);
});

test("a line that crosses an ellipse is left alone", () => {
  assert.equal(touching([[290, 300], [110, 300]], [stroke(rim(200, 300, 90, 30))], hand, [null, null]), null);
});

test("the point of a cone stands over the middle if it nearly does", () => {
  const base = ellipseIn(stroke(rim(200, 300, 80, 30)));
  near(overMiddle([206, 100], base, 0.1), [200, 100]);
  assert.deepEqual(overMiddle([260, 100], base, 0.1), [260, 100]);
  const { points: [, top] } = settled([[281, 298], [207, 100]], [stroke(rim(200, 300, 80, 30))], hand);
  assert.ok(Math.abs(top[0] - 200) < 0.5);
});

test("ellipses that come after the sides fit between them, and the sides touch them", () => {
  let strokes = [stroke([[110, 300], [110, 100]]), stroke([[290, 304], [290, 104]])];
  for (const y of [305, 98]) {
    const [made] = tidied(rim(204, y, 87, 28, 2), strokes, { ...hand, grid: null });
    strokes = [...pulled(strokes, made, hand), made];
  }
  const rims = strokes.slice(2).map(ellipseIn);
  for (const r of rims) assert.ok(Math.abs(r.axes[0] - 90) < 0.5 && Math.abs(r.centre[0] - 200) < 0.5);
  for (const { points } of strokes.slice(0, 2)) for (const p of points) assert.ok(Math.min(...rims.map(r => Math.abs(Math.hypot((p[0] - r.centre[0]) / r.axes[0], (p[1] - r.centre[1]) / r.axes[1]) - 1))) < 0.02);
});
