/* The solid that a drawing on its way is likely to become: a face that is closed, pushed along the edges that leave it. */
import { gap } from "./geometry.js";
import { areEdges } from "./marks.js";
import { isStraight } from "./tidy.js";

/* edges that leave a face may differ by this fraction of their mean; ends nearer than this are one, sheet units */
const ALIKE = 0.25, SAME = 1e-6;
/* shortest way from face to face, CSS pixels */
const LEAST_WAY = 12;

const isAt = (a, b) => gap(a, b) < SAME;

/* {f1, f2, lines} that all strokes fit, or null */
export function begun(strokes, unit) {
  if (!strokes.every(isStraight)) return null;
  const lines = strokes.map(s => s.points.map(p => p.slice(0, 2)));
  const f1 = firstRing(lines);
  if (!f1) return null;
  const on = p => f1.findIndex(q => isAt(p, q)), leaving = new Map();
  for (const [p, q] of lines) {
    const [i, j] = [on(p), on(q)];
    if (i >= 0 && j < 0) leaving.set(i, q);
    if (j >= 0 && i < 0) leaving.set(j, p);
  }
  const ways = [...leaving].map(([k, p]) => [p[0] - f1[k][0], p[1] - f1[k][1]]);
  if (!ways.length) return null;
  const way = [0, 1].map(c => ways.reduce((s, w) => s + w[c], 0) / ways.length), long = Math.hypot(...way);
  if (long < LEAST_WAY * unit || ways.some(w => gap(w, way) > ALIKE * long)) return null;
  const found = { f1, f2: f1.map((p, k) => leaving.get(k) || [p[0] + way[0], p[1] + way[1]]), holes: [], lines: "removed" };
  return areEdges(strokes, found, unit) ? found : null;
}

/* the corners of the first closed ring, in order: each line joins what hangs together until one joins two ends of the same */
function firstRing(lines) {
  const ways = [];  // [point, neighbours]
  const node = p => { let n = ways.find(([q]) => isAt(p, q)); if (!n) ways.push(n = [p, []]); return n; };
  for (const [p, q] of lines) {
    const [a, b] = [node(p), node(q)], path = pathTo(a, b, [a]);
    if (path) return path.length > 2 ? path.map(n => n[0]) : null;
    a[1].push(b);
    b[1].push(a);
  }
  return null;
}

/* the only path of lines from one node to another, or null */
function pathTo(from, to, path) {
  if (from === to) return path;
  for (const next of from[1]) {
    const found = path.includes(next) ? null : pathTo(next, to, [...path, next]);
    if (found) return found;
  }
  return null;
}
