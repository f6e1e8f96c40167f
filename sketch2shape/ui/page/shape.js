/* Changes to what was found, as functions of a state that return a new one. A state is
     {objects: [{f1, f2, holes: [{f1, f2}], projection, size: {name, value, unit}}], loose: [{x, y, face}]}
   f1[i] joins f2[i]; points are [x, y] in picture pixels. A vertex is named by {object, ring, face, index}: ring 0 is the outer one,
   the others are holes, face is 1 or 2; or by {loose: index}. */

export const copy = state => JSON.parse(JSON.stringify(state));

export const rings = object => [object, ...object.holes];

export function where(state, name) {
  if ("loose" in name) { const v = state.loose[name.loose]; return v && [v.x, v.y]; }
  const ring = state.objects[name.object] && rings(state.objects[name.object])[name.ring];
  return ring && ring[`f${name.face}`][name.index];
}

export const same = (a, b) => !!a && !!b && JSON.stringify(a) === JSON.stringify(b);

export function newObject(f1, f2) {
  return { f1, f2, holes: [], projection: "auto", size: { name: "width", value: "", unit: "mm" } };
}

/* the vertex moved to a point; its partner on the other face along with it if `together` */
export function moved(state, name, [x, y], together) {
  const next = copy(state), from = where(state, name);
  if ("loose" in name) { Object.assign(next.loose[name.loose], { x, y }); return next; }
  const ring = rings(next.objects[name.object])[name.ring];
  ring[`f${name.face}`][name.index] = [x, y];
  if (together) {
    const partner = ring[`f${3 - name.face}`][name.index];
    partner[0] += x - from[0];
    partner[1] += y - from[1];
  }
  return next;
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
  const joins = k => [other[k][0] - mine[k][0], other[k][1] - mine[k][1]];
  const [a, b] = [joins(edge.index), joins(j)];
  const partner = point.map((c, k) => c + a[k] * (1 - edge.part) + b[k] * edge.part);
  mine.splice(edge.index + 1, 0, [...point]);
  other.splice(edge.index + 1, 0, partner);
  return next;
}

/* without the vertex and its partner; a hole of three vertices goes as a whole, an object of three as well */
export function deleted(state, name) {
  const next = copy(state);
  if ("loose" in name) { next.loose.splice(name.loose, 1); return next; }
  const object = next.objects[name.object], ring = rings(object)[name.ring];
  if (ring.f1.length > 3) { ring.f1.splice(name.index, 1); ring.f2.splice(name.index, 1); }
  else if (name.ring > 0) object.holes.splice(name.ring - 1, 1);
  else next.objects.splice(name.object, 1);
  return next;
}

/* the vertex told to be of the other face: it changes places with its partner; a loose one goes none, front, back, none */
export function reassigned(state, name) {
  const next = copy(state);
  if ("loose" in name) { next.loose[name.loose].face = (next.loose[name.loose].face + 1) % 3; return next; }
  const ring = rings(next.objects[name.object])[name.ring], i = name.index;
  [ring.f1[i], ring.f2[i]] = [ring.f2[i], ring.f1[i]];
  return next;
}

export function swapped(state, k) {
  const next = copy(state);
  for (const ring of rings(next.objects[k])) [ring.f1, ring.f2] = [ring.f2, ring.f1];
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
  return state.objects.findIndex(o => ring.every(p => inside(p, o.f1)));
}

export function withHole(state, k, ring) {
  const next = copy(state), object = next.objects[k];
  const d = [0, 1].map(c => object.f2.reduce((s, p, i) => s + p[c] - object.f1[i][c], 0) / object.f1.length);
  object.holes.push({ f1: ring, f2: ring.map(p => [p[0] + d[0], p[1] + d[1]]) });
  return next;
}

export function withObject(state, f1, f2) {
  const next = copy(state);
  next.objects.push(newObject(f1, f2));
  return next;
}

/* what the server and the command take: the corrections file; `families` are kept where the projection is to be told
   from the drawing, as while a vertex is on its way and the drawing is not what it will be */
export function corrections(state, width, height, families = []) {
  const objects = state.objects.map((o, k) => {
    const projection = o.projection === "auto" && families[k] || o.projection;
    const said = { f1: o.f1, f2: o.f2, holes: o.holes, projection };
    if (Number(o.size.value) > 0) said[o.size.name] = `${Number(o.size.value)}${o.size.unit}`;
    return said;
  });
  return { schema: "sketch2shape-corrections/1", width, height, objects };
}

/* the state that a corrections file or a report describes */
export function fromCorrections(data) {
  const ring = r => ({ f1: r.f1, f2: r.f2 || r.f1.map(p => [p[0] + r.d[0], p[1] + r.d[1]]) });
  const objects = data.objects.map(o => {
    const name = ["width", "height", "depth"].find(n => o[n] !== undefined);
    const [, value, unit] = name ? /^([\d.]+)\s*(mm|cm|m|in)?$/.exec(String(o[name])) || [] : [];
    const family = typeof o.projection === "object" ? o.projection.family : o.projection;
    return { ...ring(o), holes: (o.holes || []).map(ring), projection: family || "auto", size: { name: name || "width", value: value || "", unit: unit || "mm" } };
  });
  return { objects, loose: [] };
}
