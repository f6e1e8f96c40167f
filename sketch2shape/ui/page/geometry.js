/* Plane geometry of strokes: points are [x, y, ...], whatever follows is carried along by nobody. */

export const gap = (a, b) => Math.hypot(a[0] - b[0], a[1] - b[1]);

export const middle = (a, b) => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];

/* the nearest point of the segment a-b to p: {gap, part, point}, part 0..1 along it */
export function toSegment(p, a, b) {
  const dx = b[0] - a[0], dy = b[1] - a[1];
  const part = Math.max(0, Math.min(1, ((p[0] - a[0]) * dx + (p[1] - a[1]) * dy) / (dx * dx + dy * dy || 1)));
  const point = [a[0] + part * dx, a[1] + part * dy];
  return { gap: gap(p, point), part, point };
}

/* the nearest point of a path to p */
export function toPath(p, points) {
  let best = { gap: Infinity, part: 0, point: points[0] };
  for (let k = 1; k < points.length; k++) {
    const near = toSegment(p, points[k - 1], points[k]);
    if (near.gap < best.gap) best = near;
  }
  return best;
}

export function pathLength(points) {
  let sum = 0;
  for (let k = 1; k < points.length; k++) sum += gap(points[k - 1], points[k]);
  return sum;
}

/* signed distances of points from the line through a and b, positive to the left of it on the screen */
export function offsets(points, a, b) {
  const length = gap(a, b) || 1;
  return points.map(p => ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / length);
}

/* points at equal steps along a path, its ends included */
export function resampled(points, step) {
  const out = [points[0].slice(0, 2)];
  let left = step;
  for (let k = 1; k < points.length; k++) {
    let a = points[k - 1];
    const b = points[k];
    for (let d = gap(a, b); d >= left; d = gap(a, b)) {
      a = [a[0] + (b[0] - a[0]) * left / d, a[1] + (b[1] - a[1]) * left / d];
      out.push(a);
      left = step;
    }
    left -= gap(a, b);
  }
  const end = points[points.length - 1].slice(0, 2);
  if (gap(out[out.length - 1], end) > step / 4) out.push(end); else out[out.length - 1] = end;
  return out;
}

/* Douglas-Peucker: indices of the points that a path keeps within a tolerance */
export function kept(points, tolerance, from = 0, to = points.length - 1) {
  if (to - from < 2) return [from, to];
  const away = offsets(points.slice(from, to + 1), points[from], points[to]);
  const closed = gap(points[from], points[to]) < tolerance;
  const far = closed ? points.slice(from, to + 1).map(p => gap(p, points[from])) : away.map(Math.abs);
  const k = far.indexOf(Math.max(...far));
  if (far[k] <= tolerance || k === 0 || k === to - from) return [from, to];
  return [...kept(points, tolerance, from, from + k).slice(0, -1), ...kept(points, tolerance, from + k, to)];
}

/* angle between two directions as lines, 0..pi/2 */
export function between(u, v) {
  const angle = Math.abs(Math.atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]));
  return Math.min(angle, Math.PI - angle);
}

export function turned([x, y], angle) {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [c * x - s * y, s * x + c * y];
}

/* each inner point moved towards the mean of its neighbours, a few times; ends stay */
export function smoothed(points, times) {
  let now = points.map(p => p.slice(0, 2));
  for (let t = 0; t < times; t++) {
    now = now.map((p, k) => k === 0 || k === now.length - 1 ? p
      : [0, 1].map(c => 0.25 * now[k - 1][c] + 0.5 * p[c] + 0.25 * now[k + 1][c]));
  }
  return now;
}

/* a linear system by elimination with pivots; null if it has no one solution */
function solved(matrix, right) {
  const n = right.length, rows = matrix.map((r, k) => [...r, right[k]]);
  for (let c = 0; c < n; c++) {
    const best = rows.slice(c).reduce((b, r, k) => Math.abs(r[c]) > Math.abs(rows[b][c]) ? c + k : b, c);
    if (Math.abs(rows[best][c]) < 1e-9) return null;
    [rows[c], rows[best]] = [rows[best], rows[c]];
    for (let k = 0; k < n; k++) {
      if (k === c) continue;
      const f = rows[k][c] / rows[c][c];
      rows[k] = rows[k].map((v, j) => v - f * rows[c][j]);
    }
  }
  return rows.map((r, k) => r[n] / r[k]);
}

/* the parabola nearest to offsets at equal steps: {sagitta: how far it bows from its chord, rms: what it leaves} */
export function bowOf(offs) {
  const n = offs.length, rows = offs.map((_, k) => { const t = k / (n - 1); return [1, t, t * t]; });
  const normal = [0, 1, 2].map(i => [0, 1, 2].map(j => rows.reduce((s, r) => s + r[i] * r[j], 0)));
  const found = solved(normal, [0, 1, 2].map(i => rows.reduce((s, r, k) => s + r[i] * offs[k], 0))) || [0, 0, 0];
  const left = offs.map((o, k) => o - rows[k].reduce((s, r, i) => s + r * found[i], 0));
  return { sagitta: found[2] / 4, rms: Math.sqrt(left.reduce((s, o) => s + o * o, 0) / n) };
}

/* the ellipse of a closed path: the conic A x2 + B xy + C y2 + D x + E y = 1 with the least squares, points scaled to
   one; {centre, axes: [long, short], angle, error: rms distance as a fraction of the mean half axis}, or null */
export function ellipseOf(points) {
  const centre = [0, 1].map(c => points.reduce((s, p) => s + p[c], 0) / points.length);
  const size = Math.sqrt(points.reduce((s, p) => s + gap(p, centre) ** 2, 0) / points.length) || 1;
  const terms = points.map(p => { const x = (p[0] - centre[0]) / size, y = (p[1] - centre[1]) / size; return [x * x, x * y, y * y, x, y]; });
  const normal = [0, 1, 2, 3, 4].map(i => [0, 1, 2, 3, 4].map(j => terms.reduce((s, t) => s + t[i] * t[j], 0)));
  const found = solved(normal, [0, 1, 2, 3, 4].map(i => terms.reduce((s, t) => s + t[i], 0)));
  if (!found) return null;
  const [a, b, c, d, e] = found, det = 4 * a * c - b * b;
  if (det <= 1e-9) return null;
  const x0 = (b * e - 2 * c * d) / det, y0 = (b * d - 2 * a * e) / det;
  const level = 1 + a * x0 * x0 + b * x0 * y0 + c * y0 * y0;
  const mean = (a + c) / 2, half = Math.hypot((a - c) / 2, b / 2);
  if (level / (mean + half) <= 0 || mean - half <= 0) return null;
  const axes = [Math.sqrt(level / (mean - half)) * size, Math.sqrt(level / (mean + half)) * size];
  const angle = Math.atan2(b, a - c) / 2 + Math.PI / 2;
  const ellipse = { centre: [centre[0] + x0 * size, centre[1] + y0 * size], axes, angle };
  const path = ellipsePoints(ellipse, 96);
  const rms = Math.sqrt(points.reduce((s, p) => s + toPath(p, path).gap ** 2, 0) / points.length);
  return { ...ellipse, error: rms / ((axes[0] + axes[1]) / 2) };
}

/* points once round an ellipse, the first repeated at the end */
export function ellipsePoints({ centre, axes, angle }, count) {
  return Array.from({ length: count + 1 }, (_, k) => {
    const t = (k % count) * 2 * Math.PI / count;
    const [x, y] = turned([axes[0] * Math.cos(t), axes[1] * Math.sin(t)], angle);
    return [centre[0] + x, centre[1] + y];
  });
}
