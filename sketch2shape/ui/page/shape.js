/* Changes to what was found, as functions of a state that return a new one. Of a state they use
     {objects: [{f1, f2, holes: [{f1, f2}], arcs, projection, reading, sizes: {width, height, depth}, unit}],
      loose: [{x, y, face}]}
   and keep whatever else it has. f1[i] joins f2[i], or the one point of f2; arcs are the curved edges, in the words of a
   report; points are [x, y] in picture pixels; a size is the text of a number, ""
   if it is not given. A vertex is named by {object, ring, face, index}: ring 0 is the outer one, the others are holes, face
   is 1 or 2; or by {loose: index}. */
import { given, lengthOf } from "./sizes.js";

const SIZES = ["width", "height", "depth"];
/* how an object is drawn, in a report's words: the proportions depend on it */
const MANNERS = ["lines", "noise", "f2_drawn", "page"];

const mannerOf = data => Object.fromEntries(MANNERS.filter(name => data[name] !== undefined && data[name] !== null).map(name => [name, data[name]]));

export const copy = state => JSON.parse(JSON.stringify(state));

export const rings = object => [object, ...object.holes];

export function where(state, name) {
  if ("loose" in name) { const v = state.loose[name.loose]; return v && [v.x, v.y]; }
  const ring = state.objects[name.object] && rings(state.objects[name.object])[name.ring];
  return ring && ring[`f${name.face}`][name.index];
}

export const same = (a, b) => !!a && !!b && JSON.stringify(a) === JSON.stringify(b);

export function newObject(f1, f2) {
  return { f1, f2, holes: [], arcs: [], projection: "auto", reading: 1, sizes: { width: "", height: "", depth: "" }, unit: "mm" };
}

/* objects as found, with what was wished for those at the same places before; ways: how many readings each has. A reading is
   taken over only by an object with its vertices where they were, since it counts what these may be of */
export function withWishes(found, before, ways = []) {
  return found.map((o, k) => {
    const was = before[k], { projection, sizes, unit } = was || newObject();
    const reading = was && was.reading <= ways[k] && isStill(o, was) ? was.reading : 1;
    return { ...newObject(o.f1, o.f2), holes: o.holes, arcs: o.arcs || [], ...mannerOf(o), projection, reading, sizes, unit };
  });
}

/* share of a drawing's diagonal that a vertex may be found off its place */
const OFF = 0.05;
/* has the object the rings of the other, whichever vertex these begin with? */
function isStill(o, was) {
  const [now, before] = [o, was].map(of => rings(of).flatMap(r => [r.f1, r.f2])), all = before.flat();
  const [w, h] = [0, 1].map(k => Math.max(...all.map(p => p[k])) - Math.min(...all.map(p => p[k]))), most = OFF * Math.hypot(w, h);
  const stays = (ring, other) => ring.length === other.length && ring.every(p => other.some(q => Math.hypot(p[0] - q[0], p[1] - q[1]) <= most));
  return now.length === before.length && now.every((ring, k) => stays(ring, before[k]));
}

/* the vertex moved to a point; its partner on the other face along with it if `together` */
export function moved(state, name, [x, y], together) {
  const next = copy(state), from = where(state, name);
  if ("loose" in name) { Object.assign(next.loose[name.loose], { x, y }); return next; }
  const ring = rings(next.objects[name.object])[name.ring];
  ring[`f${name.face}`][name.index] = [x, y];
  if (together && ring.f1.length === ring.f2.length) {
    const partner = ring[`f${3 - name.face}`][name.index];
    partner[0] += x - from[0];
    partner[1] += y - from[1];
  }
  return next;
}

const isOf = (arc, face, r) => arc.face === `f${face}` && (arc.hole ?? -1) === r - 1;

/* the points along an arc, turned and scaled so that they run between its vertices, wherever these are now */
function along({ points }, a, b) {
  const [p] = points, q = points[points.length - 1], [u, v] = [q[0] - p[0], q[1] - p[1]], size = u * u + v * v || 1;
  const [x, y] = [b[0] - a[0], b[1] - a[1]], c = (u * x + v * y) / size, s = (u * y - v * x) / size;
  return points.map(([m, n]) => [a[0] + c * (m - p[0]) - s * (n - p[1]), a[1] + s * (m - p[0]) + c * (n - p[1])]);
}

/* the points along edge i of a ring of a face: its two vertices, or those of its arc */
export function edgePoints(object, r, face, i) {
  const ring = rings(object)[r][`f${face}`], a = ring[i], b = ring[(i + 1) % ring.length];
  const arc = object.arcs.find(arc => isOf(arc, face, r) && arc.from === i);
  return arc ? along(arc, a, b) : [a, b];
}

/* the points round a ring of a face, with those along its arcs */
export function outline(object, r, face) {
  const whole = object.arcs.find(arc => isOf(arc, face, r) && arc.from === null);
  if (whole) return whole.points;
  return rings(object)[r][`f${face}`].flatMap((_, i) => edgePoints(object, r, face, i).slice(0, -1));
}

/* the arcs of an object once the vertices of a ring have other numbers: `renamed` tells the new one, null if it is gone or no
   longer starts the same edge */
function renumber(object, r, renamed) {
  const n = rings(object)[r].f1.length;
  object.arcs = object.arcs.flatMap(arc => {
    if (arc.from === null || (arc.hole ?? -1) !== r - 1) return [arc];
    const from = renamed(arc.from);
    return from === null ? [] : [{ ...arc, from, to: (from + 1) % n }];
  });
}

/* the nearest edge of a face to a point: {object, ring, face, index, part, gap}, part 0..1 along it from vertex `index` */
export function nearestEdge(state, [x, y]) {
  let best = null;
  state.objects.forEach((object, k) => rings(object).forEach((ring, r) => [1, 2].forEach(face => {
    const points = ring[`f${face}`];
    points.forEach(([ax, ay], i) => {
      const [bx, by] = points[(i + 1) % points.length], dx = bx - ax, dy = by - ay;
      const part = Math.max(0, Math.min(1, ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy || 1)));
      const gap = Math.hypot(ax + part * dx - x, ay + part * dy - y);
      if (!best || gap < best.gap) best = { object: k, ring: r, face, index: i, part, gap };
    });
  })));
  return best;
}

/* a vertex put into an edge at a point, and its partner into the matching edge of the other face */
export function inserted(state, edge, point) {
  const next = copy(state), ring = rings(next.objects[edge.object])[edge.ring];
  const mine = ring[`f${edge.face}`], other = ring[`f${3 - edge.face}`], j = (edge.index + 1) % mine.length;
  if (mine.length !== other.length) {
    if (edge.face !== 1) return state;  // a point has no edges
    mine.splice(edge.index + 1, 0, [...point]);
    return next;
  }
  const joins = k => [other[k][0] - mine[k][0], other[k][1] - mine[k][1]];
  const [a, b] = [joins(edge.index), joins(j)];
  const partner = point.map((c, k) => c + a[k] * (1 - edge.part) + b[k] * edge.part);
  mine.splice(edge.index + 1, 0, [...point]);
  other.splice(edge.index + 1, 0, partner);
  renumber(next.objects[edge.object], edge.ring, from => from === edge.index ? null : from + (from > edge.index));
  return next;
}

/* without the vertex and its partner; a hole of three vertices goes as a whole, an object of three as well */
export function deleted(state, name) {
  const next = copy(state);
  if ("loose" in name) { next.loose.splice(name.loose, 1); return next; }
  const object = next.objects[name.object], ring = rings(object)[name.ring];
  if (ring.f1.length > 3 && name.face === 2 && ring.f2.length === 1) return state;  // a point is all there is of its face
  if (ring.f1.length > 3) {
    const n = ring.f1.length;
    ring.f1.splice(name.index, 1);
    if (ring.f2.length > 1) ring.f2.splice(name.index, 1);
    renumber(object, name.ring, from => from === name.index || (from + 1) % n === name.index ? null : from - (from > name.index));
  } else if (name.ring > 0) object.holes.splice(name.ring - 1, 1);
  else next.objects.splice(name.object, 1);
  return next;
}

/* the vertex told to be of the other face: it changes places with its partner; a loose one goes none, front, back, none */
export function reassigned(state, name) {
  const next = copy(state);
  if ("loose" in name) { next.loose[name.loose].face = (next.loose[name.loose].face + 1) % 3; return next; }
  const ring = rings(next.objects[name.object])[name.ring], i = name.index;
  if (ring.f1.length !== ring.f2.length) return state;
  [ring.f1[i], ring.f2[i]] = [ring.f2[i], ring.f1[i]];
  return next;
}

export function swapped(state, k) {
  const next = copy(state), object = next.objects[k];
  if (object.f1.length !== object.f2.length) return state;  // a point is never in front
  for (const ring of rings(object)) [ring.f1, ring.f2] = [ring.f2, ring.f1];
  for (const arc of object.arcs) arc.face = arc.face === "f1" ? "f2" : "f1";
  return next;
}

export function inside([x, y], ring) {
  let odd = false;
  ring.forEach(([ax, ay], i) => {
    const [bx, by] = ring[(i + 1) % ring.length];
    if ((ay <= y) !== (by <= y) && ax + (y - ay) * (bx - ax) / (by - ay) > x) odd = !odd;
  });
  return odd;
}

/* which object a ring would be a hole of, or -1 */
export function hostOf(state, ring) {
  return state.objects.findIndex(o => o.f1.length === o.f2.length && ring.every(p => inside(p, outline(o, 0, 1))));
}

export function withHole(state, k, ring) {
  const next = copy(state), object = next.objects[k];
  const middle = face => { const o = outline(object, 0, face); return [0, 1].map(c => o.reduce((s, p) => s + p[c], 0) / o.length); };
  const [a, b] = [middle(1), middle(2)], d = [b[0] - a[0], b[1] - a[1]];
  object.holes.push({ f1: ring, f2: ring.map(p => [p[0] + d[0], p[1] + d[1]]) });
  return next;
}

export function withObject(state, f1, f2) {
  const next = copy(state);
  next.objects.push(newObject(f1, f2));
  return next;
}

/* the faces of an object as rings: front, back, then the sides of a box */
function facesOf(object) {
  const { f1, f2, arcs } = object, side = (i, j) => [f1[i], f1[j], f2[j], f2[i]];
  return [outline(object, 0, 1), outline(object, 0, 2), ...(f1.length === 4 && f2.length === 4 && !arcs.length ? [0, 1, 2, 3].map(i => side(i, (i + 1) % 4)) : [])];
}

/* the object with the face around a point as its front; the same state if there is no such face. Of faces that lie over each
   other the one whose middle is nearest is meant */
export function fronted(state, point) {
  let best = null;
  state.objects.forEach((object, k) => facesOf(object).forEach((ring, face) => {
    if (!inside(point, ring)) return;
    const centre = [0, 1].map(c => ring.reduce((s, p) => s + p[c], 0) / ring.length);
    const away = Math.hypot(centre[0] - point[0], centre[1] - point[1]);
    if (!best || away < best.away) best = { away, k, face };
  }));
  if (!best || best.face === 0) return state;
  if (best.face === 1) return swapped(state, best.k);
  const next = copy(state), object = next.objects[best.k];
  if (object.holes.length) return state;  // they go through the other pair of faces
  const { f1, f2 } = object, at = n => (best.face - 2 + n) % 4;
  object.f1 = [f1[at(0)], f1[at(1)], f2[at(1)], f2[at(0)]];
  object.f2 = [f1[at(3)], f1[at(2)], f2[at(2)], f2[at(3)]];
  return next;
}

/* the corrections file of a state; `families` are the projections told last, kept for objects whose projection is to be told
   from the drawing, as while a vertex is on its way and the drawing is not what it will be */
export function corrections(state, width, height, families = []) {
  const objects = state.objects.map((o, k) => {
    const projection = o.projection === "auto" && families[k] || o.projection;
    const said = { f1: o.f1, f2: o.f2, holes: o.holes, projection, ...mannerOf(o) };
    if (o.arcs.length) said.arcs = o.arcs;
    if (o.reading > 1) said.reading = o.reading;
    for (const name of SIZES) {
      const size = lengthOf(o.sizes[name], o.unit);
      if (size) said[name] = `${size.value}${size.unit}`;
    }
    return said;
  });
  return { schema: "sketch2shape-corrections/1", width: Math.round(width), height: Math.round(height), objects };
}

/* objects that a hand has changed since `before`: all their corners are seen there */
export function byHand(state, before) {
  const shape = o => JSON.stringify(o && [o.f1, o.f2, o.holes]);
  return { ...state, objects: state.objects.map((o, k) => shape(o) === shape(before.objects[k]) ? o : { ...o, f2_drawn: undefined }) };
}

/* all points of a state moved */
export function shifted(state, dx, dy) {
  const next = copy(state), move = ring => ring.forEach(p => { p[0] += dx; p[1] += dy; });
  next.objects.forEach(o => {
    rings(o).forEach(r => { move(r.f1); move(r.f2); });
    o.arcs.forEach(arc => { move(arc.points); if (arc.ellipse) move([arc.ellipse.center]); });
  });
  next.loose.forEach(v => { v.x += dx; v.y += dy; });
  return next;
}

const isPoint = p => Array.isArray(p) && p.length === 2 && p.every(Number.isFinite);

function ringOf(data, points) {
  if (!Array.isArray(data)) throw new Error("a ring is no list");
  const ring = points && data.every(Number.isInteger) ? data.map(k => points[k]) : data;
  if (!ring.every(isPoint)) throw new Error("a ring is no list of points [x, y]");
  return ring.map(p => [...p]);
}

function pairOf(data, points, shift, arcs) {
  const f1 = ringOf(data.f1, points), d = data.d || shift;
  if (!data.f2 && !isPoint(d)) throw new Error("f2 or d is missing");
  const f2 = data.f2 ? ringOf(data.f2, points) : f1.map(p => [p[0] + d[0], p[1] + d[1]]);
  if (![f1.length, 1].includes(f2.length) || f1.length < (arcs ? 0 : 3)) throw new Error("f1 and f2 do not match");
  return { f1, f2 };
}

/* the entry for a picture: of the file itself, or of its "pictures" the one whose name the picture's name ends with */
function entryFor(data, name) {
  if (!data || typeof data !== "object") throw new Error("it holds no object");
  if (!data.pictures) return data;
  const ends = Object.keys(data.pictures).filter(k => `/${name}`.endsWith(`/${k}`) || `/${k}`.endsWith(`/${name}`));
  if (!ends.length) throw new Error(`it says nothing of ${name}`);
  return data.pictures[ends.sort((a, b) => b.length - a.length)[0]];
}

/* the state that a corrections file or a report makes of the present one, for the picture of this name and size. Raises an
   Error with the reason, and then nothing has changed */
export function fromCorrections(data, state, name, width, height) {
  const entry = entryFor(data, name);
  if (!Array.isArray(entry?.objects)) throw new Error('it has no "objects"');
  const scale = entry.width > 0 && entry.height > 0 ? [width / entry.width, height / entry.height] : [1, 1];
  const objects = entry.objects.map((o, k) => corrected(o, k, state.objects[k], scale));
  const rest = entry.objects.some(o => o.f1) ? [] : state.objects.slice(objects.length);
  return { ...state, objects: [...objects, ...rest], loose: [] };
}

/* an arc on a picture of another size; its ellipse is told anew from its points where the sides differ */
function fitted(arc, fit, [a, b]) {
  const { ellipse, ...rest } = arc, points = fit(ringOf(arc.points));
  if (!ellipse || Math.abs(a - b) > 1e-9) return { ...rest, points };
  return { ...rest, points, ellipse: { ...ellipse, center: fit([ellipse.center])[0], axes: ellipse.axes.map(x => x * a) } };
}

/* one object: its faces as the file gives them, or the old ones, with what the file says of it */
function corrected(data, k, old, scale) {
  if (!data || typeof data !== "object") throw new Error(`its object ${k + 1} is none`);
  if (!data.f1 && !old) throw new Error(`nothing was found for its object ${k + 1}`);
  const fit = ring => ring.map(p => [p[0] * scale[0], p[1] * scale[1]]);
  let object = old && JSON.parse(JSON.stringify(old));
  if (data.f1) {
    const arcs = (data.arcs || []).map(arc => ({ ...arc, hole: arc.hole ?? null, from: arc.from ?? null, to: arc.to ?? null }));
    const points = data.vertices && ringOf(data.vertices), outer = pairOf(data, points, null, arcs.length);
    const shift = outer.f1.length ? [0, 1].map(c => outer.f2[0][c] - outer.f1[0][c]) : null;
    const holes = (data.holes || []).map(h => pairOf(h, points, shift, arcs.length));
    object = { ...newObject(fit(outer.f1), fit(outer.f2)), holes: holes.map(h => ({ f1: fit(h.f1), f2: fit(h.f2) })) };
    object.arcs = arcs.map(arc => fitted(arc, fit, scale));
    Object.assign(object, mannerOf(data), scale.every(s => s === 1) ? {} : { page: undefined, noise: data.noise && data.noise * Math.sqrt(scale[0] * scale[1]) });
  }
  const family = typeof data.projection === "object" ? data.projection?.family : data.projection;
  if (family) object.projection = family;
  if (Number.isInteger(data.reading)) object.reading = data.reading;
  for (const size of SIZES) {
    if (data[size] === undefined || data[size] === null) continue;
    const length = lengthOf(String(data[size]), object.unit);
    if (!length) throw new Error(`its ${size} is no length`);
    given(object, size, length);
  }
  return object;
}
