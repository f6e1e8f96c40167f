/* Whole ellipses among the strokes: those that are meant to be alike, and lines that are meant to touch them, as the sides of
   cylinders and cones do. */
import { between, ellipseOf, ellipsePoints, gap, toPath } from "./geometry.js";

/* most rms distance from its ellipse of a stroke that is one, as a fraction of the mean half axis */
const WHOLE = 0.02;
/* ellipses whose half widths differ by less than this fraction of their mean are meant to be equal, in every direction */
const ALIKE = 0.15, DIRECTIONS = 8;
/* a line may miss the place where it touches by this many times the reach of the hand, and its direction by so much, radians;
   steps in which the direction is looked for */
const FAR = 1.5, LEAN = 0.3, STEPS = 24;
/* an end is on an ellipse if it is nearer than this, CSS pixels: strokes hold corners, not arcs */
const ON = 1;
/* an ellipse whose short axis is more than this part of its long one is meant to be a circle; of one that is flatter than the
   second number its direction is to be seen */
const CIRCLE = 0.9, FLAT = 0.8;
/* the ends of two sides may lie askew by this many times the angle that a hand misses */
const SKEW = 3;
const POINTS = 48;

/* the ellipse that a stroke is, or null */
export function ellipseIn({ points }) {
  if (points.length < DIRECTIONS || gap(points[0], points[points.length - 1]) > 1e-6) return null;
  const found = ellipseOf(points);
  return found && found.error < WHOLE ? found : null;
}

const ellipsesIn = strokes => strokes.map(ellipseIn).filter(Boolean);

/* how far an ellipse, or a point [x, y], reaches in a direction, and the place where it does: {reach, point} */
function farthest(form, [x, y]) {
  if (Array.isArray(form)) return { reach: 0, centre: form, point: form };
  const { centre, axes: [a, b], angle } = form, c = Math.cos(angle), s = Math.sin(angle);
  const u = x * c + y * s, v = y * c - x * s, reach = Math.hypot(a * u, b * v) || 1e-9;
  const [p, q] = [a * a * u / reach, b * b * v / reach];
  return { reach, centre, point: [centre[0] + c * p - s * q, centre[1] + s * p + c * q] };
}

const towards = t => [Math.cos(t), Math.sin(t)];

/* are two ellipses meant to be the same but for their places? One within another is not */
function alike(e, f) {
  const mean = (e.axes[0] + e.axes[1] + f.axes[0] + f.axes[1]) / 4;
  if (gap(e.centre, f.centre) < Math.min(...e.axes, ...f.axes)) return false;
  return Array.from({ length: DIRECTIONS }, (_, k) => towards(k * Math.PI / DIRECTIONS))
    .every(n => Math.abs(farthest(e, n).reach - farthest(f, n).reach) < ALIKE * mean);
}

/* a closed path that is an ellipse, as it was meant: equal to one that is there already if nearly the same, and then straight
   across from it or where the sides end that lead from that one to it; else between two sides that wait for it; else a circle if
   nearly one, level if nearly so */
export function evened(path, strokes, options) {
  const drawn = ellipseIn({ points: path });
  if (!drawn) return path;
  const model = ellipsesIn(strokes).reverse().find(e => alike(e, drawn));
  if (model) return ellipsePoints({ ...model, centre: opposite(model, drawn, path, strokes, options) }, POINTS);
  const level = upright(drawn, options.reach.angle);
  return ellipsePoints(amid(drawn, path, strokes, options) || below(level, path, strokes, options) || level, POINTS);
}

/* straight strokes with one end near a closed path: [{end, other}] */
function sidesAt(path, strokes, far) {
  const near = p => toPath(p, path).gap < far;
  return strokes.filter(s => s.points.length === 2).flatMap(({ points: [p, q] }) => near(p) === near(q) ? [] : [near(p) ? { end: p, other: q } : { end: q, other: p }]);
}

/* an ellipse between two parallel sides that end at it, across from each other, or null */
function amid(drawn, path, strokes, { reach, unit }) {
  const sides = sidesAt(path, strokes, FAR * reach.snap * unit);
  if (sides.length !== 2) return null;
  const [d, e] = sides.map(({ end, other }) => [other[0] - end[0], other[1] - end[1]]), [p, q] = sides.map(s => s.end);
  const along = Math.atan2(d[1], d[0]), across = towards(along + Math.PI / 2), width = (q[0] - p[0]) * across[0] + (q[1] - p[1]) * across[1];
  const half = Math.abs(width) / 2, tall = farthest(drawn, towards(along)).reach;
  if (between(d, e) > reach.angle || between([q[0] - p[0], q[1] - p[1]], across) > SKEW * reach.angle || Math.abs(half - farthest(drawn, across).reach) > FAR * reach.snap * unit) return null;
  const round = Math.min(half, tall) > CIRCLE * Math.max(half, tall), axes = [half, round ? half : tall];
  const form = axes[0] >= axes[1] ? { axes, angle: along + Math.PI / 2 } : { axes: axes.reverse(), angle: along };
  return { ...form, centre: [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2] };
}

/* a point moved to the axis of an ellipse that it nearly lies on: points of cones stand over the middle */
export function overMiddle(p, { centre, axes: [a, b], angle }, most) {
  const d = [p[0] - centre[0], p[1] - centre[1]], short = towards(angle + Math.PI / 2), way = d[0] * short[0] + d[1] * short[1];
  if (b > FLAT * a || Math.abs(way) < a / 2 || between(d, short) > most) return p;
  return [centre[0] + way * short[0], centre[1] + way * short[1]];
}

/* an ellipse whose middle is moved below the point in which its two sides meet, or null */
function below(level, path, strokes, { reach, unit }) {
  const sides = sidesAt(path, strokes, FAR * reach.snap * unit);
  if (sides.length !== 2 || gap(sides[0].other, sides[1].other) > ON * unit) return null;
  const top = sides[0].other, on = overMiddle(top, level, reach.angle);
  return { ...level, centre: [level.centre[0] + top[0] - on[0], level.centre[1] + top[1] - on[1]] };
}

/* strokes whose ends nearly reach an ellipse that has come, made to touch it; their other ends stay */
export function pulled(strokes, ellipse, { reach, unit }) {
  const rim = ellipseIn(ellipse);
  if (!rim) return strokes;
  return strokes.map(stroke => {
    const [side] = sidesAt(ellipse.points, [stroke], FAR * reach.snap * unit);
    const ends = side && touching([side.end, side.other], [ellipse], { reach, unit }, [null, side.other]);
    return !ends ? stroke : { ...stroke, points: stroke.points.map(p => p === side.end ? [...ends[0], ...p.slice(2)] : p) };
  });
}

function upright(ellipse, most) {
  const { axes: [a, b], angle } = ellipse, level = Math.round(angle / (Math.PI / 2)) * Math.PI / 2;
  if (b > CIRCLE * a) return { ...ellipse, axes: [(a + b) / 2, (a + b) / 2] };
  return b < FLAT * a && Math.abs(angle - level) < most ? { ...ellipse, angle: level } : ellipse;
}

/* where the middle of an ellipse belongs that is equal to another */
function opposite(model, drawn, path, strokes, { reach, unit }) {
  const there = ellipsePoints(model, POINTS), far = FAR * reach.snap * unit, ways = [];
  for (const { points: [p, q] } of strokes.filter(s => s.points.length === 2)) {
    for (const [a, b] of [[p, q], [q, p]]) {
      if (toPath(a, there).gap < ON * unit && toPath(b, path).gap < far) ways.push([b[0] - a[0], b[1] - a[1]]);
    }
  }
  const mean = c => ways.reduce((sum, w) => sum + w[c], 0) / ways.length;
  const led = ways.length ? [model.centre[0] + mean(0), model.centre[1] + mean(1)] : null;
  if (led && gap(led, drawn.centre) < far) return led;
  const d = [drawn.centre[0] - model.centre[0], drawn.centre[1] - model.centre[1]], short = towards(model.angle + Math.PI / 2);
  if (model.axes[1] > FLAT * model.axes[0] || between(d, short) > reach.angle) return drawn.centre;
  const way = d[0] * short[0] + d[1] * short[1];
  return [model.centre[0] + way * short[0], model.centre[1] + way * short[1]];
}

/* the line that touches two forms, each an ellipse or a point, and whose normal is nearest to an angle: its two ends, or
   null */
function tangent(from, to, angle) {
  const miss = t => { const n = towards(t), a = farthest(from, n), b = farthest(to, n); return n[0] * (a.centre[0] - b.centre[0]) + n[1] * (a.centre[1] - b.centre[1]) + a.reach - b.reach; };
  const at = Array.from({ length: 2 * STEPS + 1 }, (_, k) => angle + LEAN * (k - STEPS) / STEPS);
  const crossed = at.slice(1).map((t, k) => [at[k], t]).filter(([s, t]) => miss(s) * miss(t) <= 0);
  if (!crossed.length) return null;
  let [low, high] = crossed.sort((a, b) => Math.abs(a[0] - angle) - Math.abs(b[0] - angle))[0];
  const sign = miss(low) > 0 ? 1 : -1;
  for (let k = 0; k < 40; k++) {
    const t = (low + high) / 2;
    if (sign * miss(t) > 0) low = t; else high = t;
  }
  const n = towards((low + high) / 2);
  return [farthest(from, n).point, farthest(to, n).point];
}

/* a line that ends near ellipses, moved so that it touches them: [a, b], or null if it is meant for none. `held` are the places
   of its ends that are settled already, null for an end that is free; a free end keeps the line's direction, unless it stands over
   the middle of its ellipse */
export function touching(line, strokes, { reach, unit }, held) {
  const rims = ellipsesIn(strokes), far = FAR * reach.snap * unit, forms = rimsOf(line, rims, far, held);
  if (!forms.some((f, k) => f && !held[k]) || forms[0] === forms[1]) return null;
  const free = forms.findIndex(f => !f), top = free >= 0 ? overMiddle(line[free], forms[1 - free], reach.angle) : null;
  if (top && top !== line[free]) forms[free] = top;
  const d = [line[1][0] - line[0][0], line[1][1] - line[0][1]], along = Math.atan2(d[1], d[0]);
  const found = [along + Math.PI / 2, along - Math.PI / 2].map(t => forms.every(Boolean) ? tangent(...forms, t) : moved(line, free, forms[1 - free], t))
    .filter(ends => ends && ends.every((p, k) => gap(p, line[k]) < far) && between(d, [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]]) < LEAN);
  const miss = ends => ends.reduce((sum, p, k) => sum + gap(p, line[k]), 0);
  return found.sort((p, q) => miss(p) - miss(q))[0] || null;
}

/* what holds each end of a line: the place where it is settled, the nearest ellipse, or nothing */
function rimsOf(line, rims, far, held) {
  const near = p => rims.map(e => ({ e, away: toPath(p, ellipsePoints(e, POINTS)).gap })).filter(r => r.away < far).sort((a, b) => a.away - b.away)[0]?.e;
  return line.map((p, k) => held[k] || near(p) || null);
}

/* a line moved along with its end that comes to touch an ellipse where its normal is at this angle */
function moved(line, free, rim, angle) {
  const place = farthest(rim, towards(angle)).point, end = line[1 - free], d = [place[0] - end[0], place[1] - end[1]];
  return line.map((p, j) => j === free ? [p[0] + d[0], p[1] + d[1]] : place);
}
