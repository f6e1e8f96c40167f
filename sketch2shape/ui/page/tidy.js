/* What a hand meant: which stroke is a straight line, where its ends belong, what it runs along. A stroke is
     {points: [[x, y, ...], ...], dashed}
   and straight if it has two points. Lengths are those of the sheet; `unit` is how many of them one CSS pixel is. */
import { between, ellipseOf, ellipsePoints, gap, kept, offsets, pathLength, resampled, smoothed, toPath, toSegment, turned, bowOf } from "./geometry.js";
import { evened, touching } from "./round.js";

/* how far a hand misses, CSS pixels and radians: a finger hides what it points at, a mouse slips, a pen is between */
export const REACH = {
  mouse: { snap: 16, angle: 4 * Math.PI / 180 },
  pen: { snap: 14, angle: 4 * Math.PI / 180 },
  touch: { snap: 18, angle: 6 * Math.PI / 180 },
};

/* how much farther an end reaches at which only one stroke ends, or two: corners of solids join three */
const LONELY = [1.75, 1.4, 1];
/* but never farther than this fraction of the line's length */
const OWN = 0.45;
/* shorter strokes are slips, CSS pixels */
const SLIP = 6;
/* most that a straight line bows, and that it wavers about its bow (rms), as fractions of its length; and what any hand
   does, CSS pixels */
const BOW = 0.06, WAVER = 0.04, WOBBLE = 5;
/* most length of a straight line's path over that of the line */
const DETOUR = 1.15;
/* least turn at a corner, radians, and how much of it happens close by */
const TURN = 0.6, SHARP = 0.6;
/* a path whose ends are nearer than this fraction of its length is closed */
const CLOSED = 0.15;
/* most rms distance from an ellipse, as a fraction of its mean half axis */
const ROUND = 0.08;
/* lengths of parallel lines that differ less than this are meant to be equal */
const EQUAL = 0.12;
/* lines nearly level or upright are made so within this part of the angle for parallels */
const AXIS = 0.6;
/* and short ones within this part of the reach of the hand, but never within a larger angle, radians */
const SLIPPED = 0.25, MOST_SLACK = 8 * Math.PI / 180;
/* fewest strokes that can show a solid: of a wedge or a tetrahedron the edges in view; of a cone its base and two sides */
const FEWEST = 5, FEWEST_ROUND = 3;

export const isStraight = stroke => stroke.points.length === 2;

export const endsOf = stroke => [stroke.points[0], stroke.points[stroke.points.length - 1]];

/* can there be a solid in so few strokes? */
export const mayShow = strokes => strokes.length >= (strokes.every(isStraight) ? FEWEST : FEWEST_ROUND);

const isClosed = stroke => stroke.points.length > 2 && gap(...endsOf(stroke)) < 1e-6;

/* does the path go straight from its first point to its last, as far as a hand can? */
export function goesStraight(points, unit) {
  const a = points[0], b = points[points.length - 1], length = gap(a, b);
  if (length < CLOSED * pathLength(points)) return false;
  const even = resampled(points, length / 24), { sagitta, rms } = bowOf(offsets(even, a, b));
  return Math.abs(sagitta) <= Math.max(BOW * length, WOBBLE * unit) && rms <= Math.max(WAVER * length, WOBBLE / 2 * unit)
    && pathLength(resampled(points, Math.max(length / 8, 2 * unit))) < DETOUR * length;
}

/* what a freehand path was meant to be: a list of paths, each straight (two points) or round; none for a slip */
export function meant(path, unit) {
  const points = path.filter((p, k) => k === 0 || gap(p, path[k - 1]) > 0);
  if (points.length < 2 || pathLength(points) < SLIP * unit) return [];
  if (goesStraight(points, unit)) return [[points[0], points[points.length - 1]]];
  const even = resampled(points, 3 * unit), long = pathLength(even);
  const closed = gap(even[0], even[even.length - 1]) < Math.max(CLOSED * long, 2 * SLIP * unit);
  const corners = cornersOf(even, unit, closed);
  const ellipse = closed ? ellipseOf(even) : null;
  const angular = corners && (!ellipse || ellipse.error > ROUND / 3);
  if (angular) return corners.slice(1).map((p, k) => [corners[k], p]);
  if (ellipse && ellipse.error < ROUND) return [ellipsePoints(ellipse, 48)];
  return [thin(smoothed(even, 6), unit, closed)];
}

/* the corners of a path of straight pieces, or null if it bends between them */
function cornersOf(even, unit, closed) {
  const tolerance = Math.max(WOBBLE * 1.5 * unit, 0.03 * pathLength(even));
  const at = kept(even, tolerance);
  if (at.length < 3 || at.length > 24) return null;
  const arm = 5;
  for (let k = 1; k < at.length - 1; k++) {
    const p = even[at[k]], wide = bend(even[at[k - 1]], p, even[at[k + 1]]);
    const near = bend(even[Math.max(0, at[k] - arm)], p, even[Math.min(even.length - 1, at[k] + arm)]);
    if (wide < TURN || near < SHARP * wide) return null;
  }
  for (let k = 1; k < at.length; k++) {
    if (!goesStraight(even.slice(at[k - 1], at[k] + 1), unit)) return null;
  }
  const corners = at.map(k => even[k]);
  if (closed) corners[corners.length - 1] = corners[0];
  return corners;
}

/* by how much a path turns at b on its way from a to c, radians */
function bend(a, b, c) {
  const u = [b[0] - a[0], b[1] - a[1]], v = [c[0] - b[0], c[1] - b[1]];
  return Math.abs(Math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
}

/* a curve with no more points than its shape needs */
function thin(points, unit, closed) {
  const few = kept(points, 0.4 * unit).map(k => points[k]);
  if (closed) few[few.length - 1] = [...few[0]];
  return few;
}

/* the places where strokes end: [{point, count}] */
export function corners(strokes) {
  const out = [];
  for (const end of strokes.filter(s => !isClosed(s)).flatMap(endsOf)) {
    const known = out.find(c => gap(c.point, end) < 1e-6);
    if (known) known.count++; else out.push({ point: end.slice(0, 2), count: 1 });
  }
  return out;
}

/* where a point belongs: {point, kind: "end" | "line" | "grid" | null}. Ends of strokes come first, then strokes, then the
   grid; `spare` are points that it must not go to */
export function snapped(p, strokes, reach, unit, grid = null, spare = []) {
  const most = reach.snap * unit;
  let best = { gap: most, point: null, kind: null };
  for (const { point, count } of corners(strokes)) {
    const wide = Math.min(LONELY[Math.min(count, 3) - 1] * most, reach.most ?? Infinity);
    const d = gap(p, point) * most / wide;
    if (d < best.gap && !spare.some(s => gap(s, point) < 1e-6)) best = { gap: d, point, kind: "end" };
  }
  if (best.kind) return best;
  for (const stroke of strokes) {
    const near = toPath(p, stroke.points);
    if (near.gap < Math.min(best.gap, most / 2)) best = { gap: near.gap, point: near.point, kind: "line" };
  }
  if (best.kind || !grid) return best.kind ? best : { gap: 0, point: p.slice(0, 2), kind: null };
  const node = gridNode(p, grid);
  return gap(p, node) < Math.max(most, grid.cell * 0.3) ? { gap: gap(p, node), point: node, kind: "grid" } : { gap: 0, point: p.slice(0, 2), kind: null };
}

/* the node of a grid nearest to a point; grid: {kind: "square" | "isometric", cell} */
export function gridNode([x, y], { kind, cell }) {
  if (kind === "square") return [Math.round(x / cell) * cell, Math.round(y / cell) * cell];
  const wide = cell * Math.cos(Math.PI / 6), column = Math.round(x / wide);
  const shift = column % 2 ? cell / 2 : 0;
  return [column * wide, Math.round((y - shift) / cell) * cell + shift];
}

/* directions that an axis lock keeps to, radians */
export const axesOf = grid => (grid?.kind === "isometric" ? [30, 90, 150] : [0, 90]).map(d => d * Math.PI / 180);

/* b moved so that a-b runs along the nearest axis */
export function locked(a, b, grid = null) {
  const d = [b[0] - a[0], b[1] - a[1]];
  const along = axesOf(grid).map(t => [Math.cos(t), Math.sin(t)]).map(u => [d[0] * u[0] + d[1] * u[1], u]);
  const [length, u] = along.reduce((best, now) => Math.abs(now[0]) > Math.abs(best[0]) ? now : best);
  return [a[0] + length * u[0], a[1] + length * u[1]];
}

/* b moved a little so that a-b runs along the straight stroke it nearly runs along, and is as long if nearly so; or
   level or upright if it is nearer to that, or no stroke is near */
export function aligned(a, b, strokes, reach, unit = 1) {
  const d = [b[0] - a[0], b[1] - a[1]], length = Math.hypot(...d);
  if (!length) return b;
  const level = Math.round(Math.atan2(d[1], d[0]) / (Math.PI / 2)) * Math.PI / 2, axis = turned([length, 0], level);
  // the ends of a short line are missed by as much as those of a long one
  const slack = Math.min(MOST_SLACK, Math.max(AXIS * reach.angle, SLIPPED * reach.snap * unit / length));
  const off = between(d, axis);
  let best = off < slack ? { cost: off, v: axis, alike: true } : null;
  for (const stroke of strokes.filter(isStraight)) {
    const [p, q] = stroke.points, v = [q[0] - p[0], q[1] - p[1]], angle = between(d, v);
    const alike = Math.abs(Math.hypot(...v) / length - 1) < EQUAL;
    // a line as long is the likelier partner: its angle counts half
    const cost = angle * (alike ? 0.5 : 1);
    if (angle < reach.angle && (!best || cost < best.cost)) best = { cost, v, alike };
  }
  if (!best) return b;
  const sign = d[0] * best.v[0] + d[1] * best.v[1] < 0 ? -1 : 1, long = Math.hypot(...best.v);
  const size = sign * (best.alike ? 1 : length / long);
  return [a[0] + best.v[0] * size, a[1] + best.v[1] * size];
}

/* a straight line settled among the strokes: its ends snapped, else its direction aligned
   options: {reach, unit, grid, lock}; returns {points: [a, b], kinds: [kind, kind]} */
export function settled(line, strokes, { reach: hand, unit, grid = null, lock = false }) {
  const reach = { ...hand, most: Math.max(hand.snap * unit / 2, OWN * gap(...line)) };
  const from = snapped(line[0], strokes, reach, unit, grid);
  const wanted = lock ? locked(from.point, line[1], grid) : line[1];
  // a line that is there already is never meant again: its other end is not for this one
  const taken = strokes.flatMap(s => { const [p, q] = endsOf(s); return gap(p, from.point) < 1e-6 ? [q] : gap(q, from.point) < 1e-6 ? [p] : []; });
  const to = snapped(wanted, strokes, reach, unit, grid, [from.point, ...taken]);
  let [a, b] = [from.point, to.point];
  const rim = lock ? null : onRims(line, strokes, { reach: hand, unit }, [from, to]);
  if (rim) return { points: rim, kinds: [from.kind || "line", to.kind || "line"] };
  if (lock && to.kind !== "end") b = wanted;
  else if (to.kind === "end" && from.kind !== "end" && from.kind !== "grid") a = aligned(b, a, strokes, reach, unit);
  else if (!["end", "grid", "line"].includes(to.kind)) b = aligned(a, b, strokes, reach, unit);
  // what alignment brought near an end belongs to that end
  const near = snapped(b, strokes, { ...reach, snap: reach.snap / 2 }, unit, null, [a, ...taken]);
  if (!lock && near.kind === "end") b = near.point;
  return { points: [a, b], kinds: [from.kind, to.kind] };
}

/* a line that touches ellipses: [a, b], or null. Ends of other strokes and nodes of the grid hold its ends; a free end is aligned first */
function onRims(line, strokes, options, ends) {
  const fixed = e => e.kind === "end" || e.kind === "grid", held = ends.map(e => fixed(e) ? e.point : null);
  const found = touching(line, strokes, options, held), free = ends.findIndex(e => !e.kind);
  if (!found || free < 0) return found;
  const still = found[1 - free], moved = aligned(still, found[free], strokes, options.reach, options.unit);
  return touching(free ? [still, moved] : [moved, still], strokes, options, held);
}

/* a curve settled: its ends moved to where they belong, the rest along with them; a whole ellipse stays */
export function bent(path, strokes, options) {
  const closed = gap(path[0], path[path.length - 1]) < 1e-6;
  if (closed) return evened(path, strokes, options);
  const ends = [path[0], path[path.length - 1]].map(p => snapped(p, strokes, options.reach, options.unit, options.grid));
  const moves = ends.map((e, k) => [e.point[0] - path[k ? path.length - 1 : 0][0], e.point[1] - path[k ? path.length - 1 : 0][1]]);
  return path.map((p, k) => {
    const t = k / (path.length - 1);
    return [p[0] + (1 - t) * moves[0][0] + t * moves[1][0], p[1] + (1 - t) * moves[0][1] + t * moves[1][1]];
  });
}

/* the strokes that a freehand path becomes */
export function tidied(path, strokes, options) {
  const made = [];
  for (const piece of meant(path, options.unit)) {
    const around = [...strokes, ...made];
    const points = piece.length === 2 ? settled(piece, around, options).points : bent(piece, around, options);
    if (pathLength(points) >= SLIP * options.unit) made.push({ points, dashed: Boolean(options.dashed) });
  }
  return made;
}

/* strokes with the time (ms, even along their way) and the mean pressure of the path that they were made of, [x, y, time,
   pressure]; without pressure where the pointer tells none */
export function stamped(strokes, path) {
  const ms = path[path.length - 1][2] ?? 0, pressure = path.reduce((s, p) => s + (p[3] || 0), 0) / path.length;
  const whole = strokes.reduce((s, stroke) => s + pathLength(stroke.points), 0) || 1;
  let way = 0;
  return strokes.map(stroke => ({
    ...stroke,
    points: stroke.points.map(([x, y], k) => {
      if (k) way += gap(stroke.points[k - 1], [x, y]);
      return [x, y, Math.round(ms * way / whole), ...(pressure ? [Math.round(100 * pressure) / 100] : [])];
    }),
  }));
}

/* ends of strokes that meet no other stroke: [{point, other, held}], other being the next such end if it is near, or else the
   next corner of other strokes, which is held where it is: lines that were meant to meet */
export function looseEnds(strokes, near) {
  const loose = [];
  strokes.forEach((stroke, k) => {
    if (isClosed(stroke)) return;
    for (const end of endsOf(stroke)) {
      const meets = strokes.some((other, j) => j !== k && toPath(end, other.points).gap < Math.max(1e-6, near / 12));
      if (!meets) loose.push({ point: end.slice(0, 2), stroke: k });
    }
  });
  return loose.map(l => {
    const nearest = points => points.filter(p => gap(p, l.point) < near).sort((a, b) => gap(a, l.point) - gap(b, l.point))[0] || null;
    const other = nearest(loose.filter(o => o.stroke !== l.stroke).map(o => o.point));
    const own = endsOf(strokes[l.stroke]), others = strokes.filter((_, k) => k !== l.stroke);
    const corner = other ? null : nearest(corners(others).map(c => c.point).filter(p => !own.some(e => gap(e, p) < 1e-6)));
    return { ...l, other: other || corner, held: Boolean(corner) };
  });
}

/* edges [a, b] that no stroke runs along: most of their length is farther from all strokes than `near` */
export function undrawn(edges, strokes, near) {
  return edges.filter(([a, b]) => {
    const places = [0.1, 0.3, 0.5, 0.7, 0.9].map(t => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
    const drawn = places.filter(p => strokes.some(s => toPath(p, s.points).gap < near));
    return drawn.length <= 2;
  });
}

/* strokes moved to where an end was dragged: all ends at `from` go along */
export function dragged(strokes, from, to) {
  return strokes.map(stroke => {
    const hits = endsOf(stroke).map(e => gap(e, from) < 1e-6);
    if (!hits[0] && !hits[1]) return stroke;
    const last = stroke.points.length - 1, d = [to[0] - from[0], to[1] - from[1]];
    const points = stroke.points.map((p, k) => {
      const share = (hits[0] ? 1 - k / last : 0) + (hits[1] ? k / last : 0);
      return [p[0] + share * d[0], p[1] + share * d[1], ...p.slice(2)];
    });
    return { ...stroke, points };
  });
}

/* which stroke a point touches, or -1 */
export function strokeAt(p, strokes, within) {
  const gaps = strokes.map(s => s.points.length === 2 ? toSegment(p, ...s.points).gap : toPath(p, s.points).gap);
  const best = gaps.indexOf(Math.min(...gaps));
  return best >= 0 && gaps[best] <= within ? best : -1;
}
