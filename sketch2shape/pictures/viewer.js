"use strict";
/* A turning view of a solid on a plain 2-D canvas: needs no WebGL, no library and no network.
   Strategy: each triangle is filled into a depth buffer point by point, so that concave solids come out right; edges are then
   walked in small steps and stroked where nothing is nearer. The solids here have tens of triangles, round ones
   hundreds, so this is fast. */
class SolidView {
  /* canvas: the element; shape: {vertices: [[x, y, z]], triangles: [[i, j, k]], edges: [[i, j]], view: [yaw, pitch]}, x right,
     y down, z away; contours: [[i, j, s, t]] edges within curved sides, drawn where one of the triangles s and t faces the viewer
     and the other does not.
     What may be set, with `draw()` after it: hidden (are hidden edges dashed?), lines (edges only), ground (does it stand on
     one?), bed (side of a square print bed, units of the shape, or 0), section ({axis, at 0..1, keep: 1 or -1} or null),
     ruler ([point, point] or null), colours, still (no wheel, keys or fingers) */
  constructor(canvas, shape, options = {}) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.sheet = document.createElement("canvas");
    this.colours = { dark: [85, 111, 141], pale: [206, 222, 239], edge: "#1c2028", hidden: "rgba(40, 70, 110, .65)", cut: [232, 160, 96], floor: "rgba(30, 50, 80, .10)", rule: "#b34a00" };
    this.shape = shape || { vertices: [], triangles: [], edges: [] };
    Object.assign(this, { hidden: true, lines: false, ground: true, bed: 0, section: null, ruler: null, painted: null, pending: false }, options);
    this.home();
    this.show(this.shape);
    if (!options.still) this.listen();
    if (window.ResizeObserver) new ResizeObserver(() => this.draw()).observe(canvas);
  }

  home() { [this.yaw, this.pitch] = this.shape.view || [28, 22]; this.zoom = 1; }

  show(shape) {
    this.shape = shape;
    const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
    for (const v of shape.vertices) for (let k = 0; k < 3; k++) {
      low[k] = Math.min(low[k], v[k]);
      high[k] = Math.max(high[k], v[k]);
    }
    Object.assign(this, { low, high });
    this.centre = low.map((a, k) => (a + high[k]) / 2);
    this.radius = Math.max(1e-9, ...shape.vertices.map(v => Math.hypot(...v.map((x, k) => x - this.centre[k]))));
    this.draw();
  }

  draw() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => { this.pending = false; this.paint(); });
  }

  paint() {
    const box = this.canvas.getBoundingClientRect();
    const ratio = Math.min(window.devicePixelRatio || 1, Math.sqrt(1.6e6 / Math.max(1, box.width * box.height)));
    const w = Math.max(1, Math.round(box.width * ratio)), h = Math.max(1, Math.round(box.height * ratio));
    for (const c of [this.canvas, this.sheet]) if (c.width !== w || c.height !== h) { c.width = w; c.height = h; }
    this.scale = ratio;
    this.context.clearRect(0, 0, w, h);
    if (!this.shape.vertices.length) { this.painted?.(); return; }
    if (this.ground && this.pitch > 1) this.paintGround(w, h, ratio);
    const points = this.project(w, h);
    const depth = new Float32Array(w * h);
    if (!this.lines) {
      const pen = this.sheet.getContext("2d"), image = pen.createImageData(w, h), colours = new Uint32Array(image.data.buffer);
      for (const t of this.shape.triangles) this.fill(colours, depth, w, h, points[t[0]], points[t[1]], points[t[2]]);
      pen.putImageData(image, 0, 0);
      this.context.drawImage(this.sheet, 0, 0);
    }
    this.strokeEdges(points, depth, w, h, ratio);
    if (this.ruler) this.paintRuler(w, h, ratio);
    this.painted?.();
  }

  /* each vertex as {x, y, near, turned, cut}: screen pixels, 1/distance, its place before the eye, and how far it lies on the
     side of the section that is kept */
  project(w, h) { return this.shape.vertices.map(v => this.place(v, w, h)); }

  place(v, w, h) {
    const a = -this.yaw * Math.PI / 180, b = -this.pitch * Math.PI / 180;
    const size = 2.05 * Math.min(w, h) * this.zoom;
    const [x, y, z] = v.map((c, k) => (c - this.centre[k]) / this.radius);
    const tx = Math.cos(a) * x - Math.sin(a) * z, away = Math.sin(a) * x + Math.cos(a) * z;
    const ty = Math.cos(b) * y + Math.sin(b) * away, tz = -Math.sin(b) * y + Math.cos(b) * away;
    const near = 1 / (tz + 4.8), s = this.section;
    const cut = s ? s.keep * (v[s.axis] - this.low[s.axis] - s.at * (this.high[s.axis] - this.low[s.axis])) / this.radius : 1;
    return { x: w / 2 + tx * near * size, y: h / 2 + ty * near * size, near, turned: [tx, ty, tz], cut };
  }

  /* where a point of the shape is seen, CSS pixels of the canvas */
  seenAt(v) {
    const p = this.place(v, this.canvas.width, this.canvas.height);
    return [p.x / this.scale, p.y / this.scale];
  }

  /* the vertex seen nearest to a place of the canvas, CSS pixels, or -1 if none is within reach */
  nearest(x, y, reach = 24) {
    const gaps = this.shape.vertices.map(v => { const [a, b] = this.seenAt(v); return Math.hypot(a - x, b - y); });
    const best = gaps.indexOf(Math.min(...gaps));
    return best >= 0 && gaps[best] <= reach ? best : -1;
  }

  /* the ground, the print bed on it, and the shadow of a light from above on the left */
  paintGround(w, h, ratio) {
    const pen = this.context, floor = this.high[1], at = (x, z) => this.place([x, floor, z], w, h);
    const path = corners => { pen.beginPath(); corners.forEach((p, k) => k ? pen.lineTo(p.x, p.y) : pen.moveTo(p.x, p.y)); pen.closePath(); };
    if (this.bed) {
      const half = this.bed / 2, [cx, , cz] = this.centre;
      path([[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([i, j]) => at(cx + i * half, cz + j * half)));
      pen.fillStyle = this.colours.floor;
      pen.fill();
      pen.strokeStyle = this.colours.hidden;
      pen.lineWidth = ratio;
      pen.stroke();
      pen.globalAlpha = 0.35;
      pen.beginPath();
      for (let k = -half; k <= half + 1e-9; k += this.bed / 22) for (const [a, b] of [[at(cx + k, cz - half), at(cx + k, cz + half)], [at(cx - half, cz + k), at(cx + half, cz + k)]]) { pen.moveTo(a.x, a.y); pen.lineTo(b.x, b.y); }
      pen.stroke();
      pen.globalAlpha = 1;
    }
    pen.save();
    pen.filter = `blur(${Math.round(7 * ratio)}px)`;
    pen.globalAlpha = 0.16;
    pen.fillStyle = "#000";
    pen.beginPath();
    for (const t of this.shape.triangles) {
      const [a, b, c] = t.map(k => { const [x, y, z] = this.shape.vertices[k], up = floor - y; return at(x + 0.28 * up, z + 0.18 * up); });
      // all turn the same way round, or the near and the far side would cancel each other
      const turns = (b.x - a.x) * (c.y - a.y) > (b.y - a.y) * (c.x - a.x) ? [a, b, c] : [a, c, b];
      turns.forEach((p, j) => j ? pen.lineTo(p.x, p.y) : pen.moveTo(p.x, p.y));
      pen.closePath();
    }
    pen.fill();
    pen.restore();
  }

  paintRuler(w, h, ratio) {
    const pen = this.context, ends = this.ruler.map(v => this.place(v, w, h));
    Object.assign(pen, { strokeStyle: this.colours.rule, fillStyle: this.colours.rule, lineWidth: 2.5 * ratio });
    pen.setLineDash([]);
    pen.beginPath();
    ends.forEach((p, k) => k ? pen.lineTo(p.x, p.y) : pen.moveTo(p.x, p.y));
    pen.stroke();
    for (const p of ends) { pen.beginPath(); pen.arc(p.x, p.y, 5 * ratio, 0, 7); pen.fill(); }
  }

  shade(p, q, r) {
    const u = q.turned.map((c, k) => c - p.turned[k]), v = r.turned.map((c, k) => c - p.turned[k]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n) || 1, eye = [p.turned[0], p.turned[1], p.turned[2] + 4.8];
    const away = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2] > 0 ? -1 : 1;
    n = n.map(c => away * c / length);
    const light = 0.5 + 0.5 * (n[0] * -0.432 + n[1] * -0.768 + n[2] * -0.528);
    const { dark, pale, cut } = this.colours;
    // the inside of a solid that is cut open shows where its surface is seen from behind: it is painted as if cut there
    const [red, green, blue] = this.section && away < 0 ? cut : dark.map((c, k) => Math.round(c + (pale[k] - c) * light));
    return (255 << 24) | (blue << 16) | (green << 8) | red;
  }

  fill(colours, depth, w, h, a, b, c) {
    const area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (Math.abs(area) < 1e-6) return;
    const colour = this.shade(a, b, c);
    const x0 = Math.max(0, Math.floor(Math.min(a.x, b.x, c.x))), x1 = Math.min(w - 1, Math.ceil(Math.max(a.x, b.x, c.x)));
    const y0 = Math.max(0, Math.floor(Math.min(a.y, b.y, c.y))), y1 = Math.min(h - 1, Math.ceil(Math.max(a.y, b.y, c.y)));
    const ux = (c.y - a.y) / area, vx = -(b.y - a.y) / area;
    for (let y = y0; y <= y1; y++) {
      let u = ((x0 - a.x) * (c.y - a.y) - (y - a.y) * (c.x - a.x)) / area;
      let v = ((b.x - a.x) * (y - a.y) - (b.y - a.y) * (x0 - a.x)) / area;
      for (let x = x0, k = y * w + x0; x <= x1; x++, k++, u += ux, v += vx) {
        if (u < -1e-6 || v < -1e-6 || u + v > 1.000001) continue;
        const near = a.near + u * (b.near - a.near) + v * (c.near - a.near);
        // the place along the section is even along the surface, not on the screen
        if (a.cut * a.near * (1 - u - v) + b.cut * b.near * u + c.cut * c.near * v < 0) continue;
        if (near > depth[k]) { depth[k] = near; colours[k] = colour; }
      }
    }
  }

  strokeEdges(points, depth, w, h, ratio) {
    const toward = t => {
      const [a, b, c] = this.shape.triangles[t].map(i => points[i]);
      return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    };
    const outline = (this.shape.contours || []).filter(([, , s, t]) => toward(s) !== toward(t));
    const lines = [...[...this.shape.edges, ...outline].map(([i, j]) => [points[i], points[j]]), ...this.cutLines(w, h)];
    const runs = lines.flatMap(([a, b]) => this.runs(a, b, depth, w, h));
    const pen = this.context;
    pen.lineCap = "round";
    for (const seen of [false, true]) {
      if (!seen && !this.hidden) continue;
      pen.beginPath();
      let end = [NaN, NaN]; /* chords of one curve are one line, so that its dashes run on */
      for (const run of runs) if (run.seen === seen) {
        if (Math.hypot(run.from[0] - end[0], run.from[1] - end[1]) > 0.01 || isNaN(end[0])) pen.moveTo(...run.from);
        pen.lineTo(...run.to);
        end = run.to;
      }
      pen.strokeStyle = seen ? this.colours.edge : this.colours.hidden;
      pen.lineWidth = (seen ? 2 : 1) * ratio;
      pen.setLineDash(seen ? [] : [4 * ratio, 4 * ratio]);
      pen.stroke();
    }
  }

  /* the two ends of the line in which the section cuts each triangle */
  cutLines(w, h) {
    if (!this.section) return [];
    const { axis, at } = this.section, level = this.low[axis] + at * (this.high[axis] - this.low[axis]), { vertices, triangles } = this.shape;
    return triangles.map(t => t.flatMap((i, k) => {
      const p = vertices[i], q = vertices[t[(k + 1) % 3]], from = p[axis] - level, to = q[axis] - level;
      return (from < 0) === (to < 0) ? [] : [{ ...this.place(p.map((c, j) => c + (q[j] - c) * from / (from - to)), w, h), cut: 0 }];
    })).filter(ends => ends.length === 2);
  }

  runs(a, b, depth, w, h) {
    const count = Math.max(2, Math.min(3000, Math.round(Math.hypot(b.x - a.x, b.y - a.y) / 2)));
    const at = t => [a.x + t * (b.x - a.x) + 0.5, a.y + t * (b.y - a.y) + 0.5];
    const out = [];
    let start = 0, before = null;
    for (let k = 0; k <= count; k++) {
      const seen = k < count ? this.seen(a, b, (k + 0.5) / count, depth, w, h) : null;
      if (seen !== before) {
        if (before !== null) out.push({ from: at(start / count), to: at(k / count), seen: before });
        start = k;
      }
      before = seen;
    }
    return out;
  }

  /* true or false; null where the section has taken it away */
  seen(a, b, t, depth, w, h) {
    if (a.cut * a.near * (1 - t) + b.cut * b.near * t < -1e-9) return null;
    const x = Math.round(a.x + t * (b.x - a.x)), y = Math.round(a.y + t * (b.y - a.y));
    const near = a.near + t * (b.near - a.near) + 2e-4;
    for (let dy = -1; dy <= 1; dy++) for (let dx = -1; dx <= 1; dx++) {
      const px = Math.min(w - 1, Math.max(0, x + dx)), py = Math.min(h - 1, Math.max(0, y + dy));
      if (near >= depth[py * w + px]) return true;
    }
    return false;
  }

  turn(yaw, pitch) {
    this.yaw = (this.yaw + yaw) % 360;
    this.pitch = Math.max(-90, Math.min(90, this.pitch + pitch));
    this.draw();
  }

  /* turn to a view, at once for those who asked for less motion */
  glide(yaw, pitch) {
    const from = [this.yaw, this.pitch], still = matchMedia("(prefers-reduced-motion: reduce)").matches, begin = performance.now();
    const way = ((yaw - from[0]) % 360 + 540) % 360 - 180;
    const step = () => {
      const t = still ? 1 : Math.min(1, (performance.now() - begin) / 350), ease = t * t * (3 - 2 * t);
      [this.yaw, this.pitch] = [from[0] + way * ease, from[1] + (pitch - from[1]) * ease];
      this.draw();
      if (t < 1 && this.gliding === step) requestAnimationFrame(step);
    };
    this.gliding = step;
    step();
  }

  magnify(factor) { this.zoom = Math.max(0.2, Math.min(8, this.zoom * factor)); this.draw(); }

  listen() {
    const canvas = this.canvas, fingers = new Map();
    canvas.style.touchAction = "none";
    canvas.addEventListener("pointerdown", e => { this.gliding = null; canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, e); });
    for (const end of ["pointerup", "pointercancel"]) canvas.addEventListener(end, e => fingers.delete(e.pointerId));
    canvas.addEventListener("pointermove", e => {
      const before = fingers.get(e.pointerId);
      if (!before) return;
      if (fingers.size === 2) {
        const other = [...fingers.values()].find(f => f.pointerId !== e.pointerId);
        const gap = f => Math.hypot(f.clientX - other.clientX, f.clientY - other.clientY) || 1;
        this.magnify(gap(e) / gap(before));
      } else {
        this.turn((before.clientX - e.clientX) * 0.5, (e.clientY - before.clientY) * 0.5);
      }
      fingers.set(e.pointerId, e);
    });
    canvas.addEventListener("wheel", e => {
      if (document.activeElement !== canvas && !e.ctrlKey) return;  // the page scrolls until the solid was clicked
      e.preventDefault();
      this.magnify(Math.exp(-e.deltaY / 600));
    }, { passive: false });
    canvas.addEventListener("dblclick", () => { this.home(); this.draw(); });
    canvas.addEventListener("keydown", e => this.key(e));
  }

  key(e) {
    const moves = { ArrowLeft: [8, 0], ArrowRight: [-8, 0], ArrowUp: [0, -8], ArrowDown: [0, 8] };
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    if (moves[e.key]) this.turn(...moves[e.key]);
    else if (e.key === "+" || e.key === "=") this.magnify(1.15);
    else if (e.key === "-") this.magnify(1 / 1.15);
    else if (e.key === "0") { this.home(); this.draw(); }
    else if (e.key === "h") { this.hidden = !this.hidden; this.draw(); }
    else if (e.key === "w") { this.lines = !this.lines; this.draw(); }
    else return;
    e.preventDefault();
    e.stopPropagation();
  }
}
