"use strict";
/* A turning view of a solid on a plain 2-D canvas: needs no WebGL, no library and no network.
   Strategy: each triangle is filled into a depth buffer point by point, so that concave solids come out right; edges are then
   walked in small steps and stroked where nothing is nearer. The solids here have tens of triangles, round ones
   hundreds, so this is fast. */
class SolidView {
  /* canvas: the element; shape: {vertices: [[x, y, z]], triangles: [[i, j, k]], edges: [[i, j]], view: [yaw, pitch]}, x right,
     y down, z away; contours: [[i, j, s, t]] edges within curved sides, drawn where one of the triangles s and t faces the viewer
     and the other does not */
  constructor(canvas, shape) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.shape = shape || { vertices: [], triangles: [], edges: [] };
    this.home();
    this.hidden = true;
    this.pending = false;
    this.show(this.shape);
    this.listen();
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
    if (this.canvas.width !== w || this.canvas.height !== h) { this.canvas.width = w; this.canvas.height = h; }
    this.context.clearRect(0, 0, w, h);
    if (!this.shape.vertices.length) return;
    const points = this.project(w, h);
    const image = this.context.createImageData(w, h);
    const colours = new Uint32Array(image.data.buffer), depth = new Float32Array(w * h);
    for (const t of this.shape.triangles) this.fill(colours, depth, w, h, points[t[0]], points[t[1]], points[t[2]]);
    this.context.putImageData(image, 0, 0);
    this.strokeEdges(points, depth, w, h, ratio);
  }

  /* each vertex as {x, y, near, turned}: screen pixels, 1/distance, and its place before the eye */
  project(w, h) {
    const a = -this.yaw * Math.PI / 180, b = -this.pitch * Math.PI / 180;
    const size = 2.05 * Math.min(w, h) * this.zoom;
    return this.shape.vertices.map(v => {
      const [x, y, z] = v.map((c, k) => (c - this.centre[k]) / this.radius);
      const tx = Math.cos(a) * x - Math.sin(a) * z, away = Math.sin(a) * x + Math.cos(a) * z;
      const ty = Math.cos(b) * y + Math.sin(b) * away, tz = -Math.sin(b) * y + Math.cos(b) * away;
      const near = 1 / (tz + 4.8);
      return { x: w / 2 + tx * near * size, y: h / 2 + ty * near * size, near, turned: [tx, ty, tz] };
    });
  }

  shade(p, q, r) {
    const u = q.turned.map((c, k) => c - p.turned[k]), v = r.turned.map((c, k) => c - p.turned[k]);
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    const length = Math.hypot(...n) || 1, eye = [p.turned[0], p.turned[1], p.turned[2] + 4.8];
    const away = n[0] * eye[0] + n[1] * eye[1] + n[2] * eye[2] > 0 ? -1 : 1;
    n = n.map(c => away * c / length);
    const light = 0.5 + 0.5 * (n[0] * -0.432 + n[1] * -0.768 + n[2] * -0.528);
    const dark = [85, 111, 141], pale = [206, 222, 239];
    const [red, green, blue] = dark.map((c, k) => Math.round(c + (pale[k] - c) * light));
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
    const runs = [...this.shape.edges, ...outline].flatMap(([i, j]) => this.runs(points[i], points[j], depth, w, h));
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
      pen.strokeStyle = seen ? "#1c2028" : "rgba(40, 70, 110, .65)";
      pen.lineWidth = (seen ? 2 : 1) * ratio;
      pen.setLineDash(seen ? [] : [4 * ratio, 4 * ratio]);
      pen.stroke();
    }
  }

  runs(a, b, depth, w, h) {
    const count = Math.max(2, Math.min(3000, Math.round(Math.hypot(b.x - a.x, b.y - a.y) / 2)));
    const at = t => [a.x + t * (b.x - a.x) + 0.5, a.y + t * (b.y - a.y) + 0.5];
    const out = [];
    let start = 0, before = null;
    for (let k = 0; k <= count; k++) {
      const seen = k < count ? this.seen(a, b, (k + 0.5) / count, depth, w, h) : null;
      if (before !== null && seen !== before) {
        out.push({ from: at(start / count), to: at(k / count), seen: before });
        start = k;
      }
      before = seen;
    }
    return out;
  }

  seen(a, b, t, depth, w, h) {
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
    this.pitch = Math.max(-89, Math.min(89, this.pitch + pitch));
    this.draw();
  }

  magnify(factor) { this.zoom = Math.max(0.2, Math.min(8, this.zoom * factor)); this.draw(); }

  listen() {
    const canvas = this.canvas, fingers = new Map();
    canvas.style.touchAction = "none";
    canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); fingers.set(e.pointerId, e); });
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
    canvas.addEventListener("wheel", e => { e.preventDefault(); this.magnify(Math.exp(-e.deltaY / 600)); }, { passive: false });
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
    else return;
    e.preventDefault();
    e.stopPropagation();
  }
}
