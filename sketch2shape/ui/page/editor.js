/* The drawing with its vertices as an SVG that can be edited with mouse, pen, finger and keyboard. */
import * as shape from "./shape.js";
import { say } from "./words.js";

const SVG = "http://www.w3.org/2000/svg";
const SPOT = 6, HALO = 15, SNAP = 10;  // screen pixels
/* where the sheet is narrower than this, the buttons at its foot would hide too much of it, screen pixels */
const NARROW = 480, BUTTONS = 54;

function element(kind, attributes, parent) {
  const made = document.createElementNS(SVG, kind);
  for (const [k, v] of Object.entries(attributes)) made.setAttribute(k, v);
  if (parent) parent.append(made);
  return made;
}

export class Editor {
  /* on: {change(state, done), hint(words)}; `done` is false while something is being dragged */
  constructor(svg, on) {
    this.svg = svg;
    this.on = on;
    this.tool = "move";
    this.together = false;
    this.chosen = null;
    this.drag = null;
    this.trace = null;
    this.fingers = new Map();
    this.open({ width: 640, height: 480 }, { objects: [], loose: [] }, []);
    svg.addEventListener("pointerdown", e => this.down(e));
    svg.addEventListener("pointermove", e => this.move(e));
    svg.addEventListener("pointerup", e => this.up(e));
    svg.addEventListener("pointercancel", e => { this.fingers.delete(e.pointerId); this.cancel(); });
    svg.addEventListener("dblclick", () => this.closeTrace());
    svg.addEventListener("wheel", e => { if (!e.ctrlKey && !e.metaKey) return; e.preventDefault(); this.zoom(Math.exp(e.deltaY / 500), this.at(e)); }, { passive: false });
    svg.addEventListener("keydown", e => this.key(e));
    // painted once the focus is where it goes: it would be lost with what is painted anew
    svg.addEventListener("blur", () => { setTimeout(() => { if (this.cursor && document.activeElement !== svg) { this.cursor = null; this.paint(); } }); });
    svg.addEventListener("focusin", e => this.choose(this.nameOf(e.target)));
    new ResizeObserver(() => this.paint()).observe(svg);
  }

  /* sheet: {picture: address, strokes, x, y, width, height}: what lies under the vertices, and where; left: lines that fit
     nothing, to be marked */
  open(sheet, state, corners) {
    Object.assign(this, { picture: "", strokes: [], left: [], x: 0, y: 0, ...sheet, state, corners, chosen: null, trace: null, drag: null, cursor: null });
    this.fit();
  }

  show(state) { this.state = state; this.trace = null; this.paint(); }

  setTool(tool) { this.tool = tool; this.trace = null; this.svg.dataset.tool = tool; this.paint(); this.say(); }

  say() {
    const words = { move: "hintMove", add: "hintAdd", delete: "hintRemove", face: "hintExchange", front: "hintFront", trace: "hintTrace" };
    this.on.hint(say(this.trace?.closed ? "hintTraceBack" : words[this.tool]));
  }

  /* ---- view */
  /* all of the sheet, above the buttons where there is little room */
  fit() {
    const { width, height } = this.svg.getBoundingClientRect(), [w, h] = [this.width * 1.06, this.height * 1.06];
    const low = width && width < NARROW ? BUTTONS / Math.max(height - BUTTONS, 1) * Math.max(h, w * (height - BUTTONS) / width) : 0;
    this.box = [this.x - 0.5 - this.width * 0.03, this.y - 0.5 - this.height * 0.03, w, h + low];
    this.paint();
  }

  zoom(factor, at) {
    const [x, y, w, h] = this.box;
    const f = Math.min(2 * this.width / w, Math.max(this.width / 60 / w, factor));
    const [cx, cy] = at || [x + w / 2, y + h / 2];
    this.box = [cx + (x - cx) * f, cy + (y - cy) * f, w * f, h * f];
    this.paint();
  }

  /* picture pixels of one screen pixel */
  get unit() {
    const { width, height } = this.svg.getBoundingClientRect();
    return width && height ? Math.max(this.box[2] / width, this.box[3] / height) : 1;
  }

  at(e) {
    const matrix = this.svg.getScreenCTM();
    if (!matrix) return [0, 0];
    const p = new DOMPoint(e.clientX, e.clientY).matrixTransform(matrix.inverse());
    return [p.x, p.y];
  }

  snapped(p) {
    const near = this.corners.map(c => [Math.hypot(c[0] - p[0], c[1] - p[1]), c]).sort((a, b) => a[0] - b[0])[0];
    return near && near[0] < SNAP * this.unit ? [...near[1]] : p.map(c => Math.round(c * 100) / 100);
  }

  paint() {
    const focused = this.nameOf(document.activeElement);
    this.svg.setAttribute("viewBox", this.box.join(" "));
    const page = document.createDocumentFragment();
    if (this.picture) element("image", { href: this.picture, x: this.x - 0.5, y: this.y - 0.5, width: this.width, height: this.height, preserveAspectRatio: "none" }, page);
    for (const stroke of this.strokes) element("polyline", { points: stroke.points.map(p => `${p[0]},${p[1]}`).join(" "), class: "stroke" }, page);
    for (const object of this.state.objects) this.paintObject(object, page);
    for (const [[x1, y1], [x2, y2]] of this.left) element("line", { x1, y1, x2, y2, class: "left" }, page);
    if (["trace", "face", "add"].includes(this.tool)) {
      for (const [x, y] of this.corners) element("circle", { cx: x, cy: y, r: 2.5 * this.unit, class: "corner-dot" }, page);
    }
    this.state.objects.forEach((object, k) => shape.rings(object).forEach((ring, r) => [2, 1].forEach(face =>
      ring[`f${face}`].forEach((_, index) => this.paintVertex({ object: k, ring: r, face, index }, page)))));
    this.state.loose.forEach((_, k) => this.paintVertex({ loose: k }, page));
    this.paintTrace(page);
    if (this.cursor) {
      const [x, y] = this.cursor, far = HALO * this.unit;
      element("path", { d: `M${x - far} ${y}h${2 * far}M${x} ${y - far}v${2 * far}`, class: "cursor" }, page);
    }
    this.svg.replaceChildren(page);
    if (focused) this.svg.querySelector(`[data-name='${JSON.stringify(focused)}']`)?.focus({ preventScroll: true });
  }

  paintObject(object, page) {
    const path = shape.rings(object).map((_, r) => `M${shape.outline(object, r, 1).map(p => p.join(" ")).join("L")}Z`).join("");
    element("path", { d: path, class: "fill" }, page);
    const line = (points, kind) => element("polyline", { points: points.map(p => p.join(",")).join(" "), class: kind }, page);
    const around = (r, face, kind) => {
      const ring = shape.rings(object)[r][`f${face}`], whole = ring.length ? [] : shape.outline(object, r, face);
      if (whole.length) line([...whole, whole[0]], kind);
      if (ring.length > 1) ring.forEach((_, i) => line(shape.edgePoints(object, r, face, i), kind));
    };
    shape.rings(object).forEach(({ f1, f2 }, r) => {
      around(r, 2, "back");
      f1.forEach((p, i) => line([p, f2[f2.length > 1 ? i : 0]], "join"));
      around(r, 1, "front");
    });
  }

  paintVertex(name, page) {
    const [x, y] = shape.where(this.state, name);
    const face = "loose" in name ? this.state.loose[name.loose].face : name.face;
    const words = say(["vertexLoose", "vertexFront", "vertexBack"][face], { n: ("loose" in name ? name.loose : name.index) + 1 }) + (name.ring ? ` ${say("ofHole", { n: name.ring })}` : "");
    const spot = element("g", {
      class: `vertex f${face}${shape.same(name, this.chosen) ? " chosen" : ""}`, tabindex: 0, role: "button", "data-name": JSON.stringify(name),
      "aria-label": `${words}, ${say("at", { x: Math.round(x), y: Math.round(y) })}`,
    }, page);
    element("circle", { cx: x, cy: y, r: HALO * this.unit, class: "halo" }, spot);
    element("circle", { cx: x, cy: y, r: SPOT * this.unit, class: "spot" }, spot);
  }

  paintTrace(page) {
    if (!this.trace) return;
    const { points, closed, pointer } = this.trace;
    element(closed ? "polygon" : "polyline", { points: [...points, ...(closed || !pointer ? [] : [pointer])].map(p => p.join(",")).join(" "), class: "trace" }, page);
    points.forEach((p, k) => element("circle", { cx: p[0], cy: p[1], r: (k ? 4 : 7) * this.unit, class: "dot" }, page));
    if (closed && pointer) element("line", { x1: points[0][0], y1: points[0][1], x2: pointer[0], y2: pointer[1], class: "join" }, page);
  }

  /* ---- pointer */
  nameOf(target) {
    const vertex = target?.closest?.("g.vertex");
    return vertex && this.svg.contains(vertex) ? JSON.parse(vertex.dataset.name) : null;
  }

  /* the vertex nearest to a place, within reach */
  reach(p) {
    const names = [...this.svg.querySelectorAll("g.vertex")].map(v => JSON.parse(v.dataset.name));
    const gaps = names.map(n => { const q = shape.where(this.state, n); return [Math.hypot(q[0] - p[0], q[1] - p[1]), n]; });
    const best = gaps.sort((a, b) => a[0] - b[0])[0];
    return best && best[0] <= HALO * this.unit ? best[1] : null;
  }

  choose(name) {
    if (!name || shape.same(name, this.chosen)) return;
    this.chosen = name;
    this.on.choose?.(name);
  }

  commit(state) { this.state = state; this.paint(); this.on.change(state, true); }

  down(e) {
    if (e.button > 0) return;
    this.fingers.set(e.pointerId, [e.clientX, e.clientY]);
    this.svg.setPointerCapture(e.pointerId);
    if (this.fingers.size > 1) { this.drag = null; this.pinch = null; return; }
    const at = this.at(e), name = this.reach(at);
    if (name) { e.preventDefault(); this.focus(name); }
    if (!this.act(at, name)) this.drag = name ? { name, start: this.state, grip: shape.where(this.state, name).map((c, k) => c - at[k]) } : { pan: at };
  }

  /* what the tool does at a place, where there may be a vertex; false if it does nothing there */
  act(at, name) {
    if (this.tool === "front") { const next = shape.fronted(this.state, at); if (next !== this.state) this.commit(next); }
    else if (this.tool === "trace") this.traceClick(at);
    else if (this.tool === "add" && !name) this.addAt(at);
    else if (this.tool === "delete" && name) this.remove(name);
    else if (this.tool === "face" && name) this.commit(shape.reassigned(this.state, name));
    else return false;
    return true;
  }

  move(e) {
    if (this.trace) { this.trace.pointer = this.snapped(this.at(e)); this.paint(); }
    if (!this.fingers.has(e.pointerId)) return;
    this.fingers.set(e.pointerId, [e.clientX, e.clientY]);
    if (this.fingers.size === 2) this.pinchMove();
    else if (this.drag?.pan) this.pan(this.drag.pan, this.at(e));
    else if (this.drag) {
      const at = this.at(e), to = this.snapped(at.map((c, k) => c + this.drag.grip[k]));
      this.drag.moved = true;
      this.state = shape.moved(this.drag.start, this.drag.name, to, this.together !== e.shiftKey);
      this.paint();
      this.on.change(this.state, false);
    }
  }

  up(e) {
    this.fingers.delete(e.pointerId);
    this.pinch = null;
    if (this.drag?.moved) this.on.change(this.state, true);
    this.drag = null;
  }

  /* Escape: what is being dragged goes back */
  cancel() {
    if (this.drag?.start && this.drag.moved) { this.state = this.drag.start; this.on.change(this.state, true); }
    this.drag = this.trace = null;
    this.paint();
    this.say();
  }

  pan(from, to) { this.box[0] += from[0] - to[0]; this.box[1] += from[1] - to[1]; this.paint(); }

  pinchMove() {
    const [a, b] = [...this.fingers.values()], gap = Math.hypot(a[0] - b[0], a[1] - b[1]) || 1;
    const middle = this.at({ clientX: (a[0] + b[0]) / 2, clientY: (a[1] + b[1]) / 2 });
    if (this.pinch) { this.pan(this.pinch.middle, middle); this.zoom(this.pinch.gap / gap, this.pinch.middle); }
    this.pinch = { gap, middle: this.at({ clientX: (a[0] + b[0]) / 2, clientY: (a[1] + b[1]) / 2 }) };
  }

  /* ---- tools */
  addAt(at) {
    const edge = shape.nearestEdge(this.state, at), point = this.snapped(at);
    if (edge && edge.gap < 60 * this.unit) {
      this.commit(shape.inserted(this.state, edge, point));
      this.focus({ object: edge.object, ring: edge.ring, face: edge.face, index: edge.index + 1 });
    } else {
      const next = shape.copy(this.state);
      next.loose.push({ x: point[0], y: point[1], face: 0 });
      this.commit(next);
    }
  }

  remove(name) { this.chosen = null; this.commit(shape.deleted(this.state, name)); }

  focus(name) {
    this.choose(name);
    this.paint();
    this.svg.querySelector(`[data-name='${JSON.stringify(name)}']`)?.focus({ preventScroll: true });
  }

  traceClick(at) {
    const p = this.snapped(at);
    if (!this.trace) this.trace = { points: [p], closed: false, pointer: null };
    else if (this.trace.closed) return this.finishTrace(p);
    else if (Math.hypot(p[0] - this.trace.points[0][0], p[1] - this.trace.points[0][1]) < HALO * this.unit) return this.closeTrace();
    else if (Math.hypot(...p.map((c, k) => c - this.trace.points[this.trace.points.length - 1][k])) > 2 * this.unit) this.trace.points.push(p);
    this.paint();
    return null;
  }

  closeTrace() {
    if (!this.trace || this.trace.closed || this.trace.points.length < 3) return;
    const host = shape.hostOf(this.state, this.trace.points);
    if (host >= 0) {
      const ring = this.trace.points;
      this.trace = null;
      this.commit(shape.withHole(this.state, host, ring));
    } else {
      this.trace.closed = true;
      this.trace.pointer = null;
      this.paint();
    }
    this.say();
  }

  finishTrace(p) {
    const ring = this.trace.points, d = p.map((c, k) => c - ring[0][k]);
    if (Math.hypot(...d) < 3 * this.unit) return;
    this.trace = null;
    this.commit(shape.withObject(this.state, ring, ring.map(q => [q[0] + d[0], q[1] + d[1]])));
    this.say();
  }

  /* ---- keyboard */
  key(e) {
    if (e.key === "Escape") { this.cancel(); return; }
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const name = this.nameOf(e.target), step = e.shiftKey === Boolean(name) ? 10 : 1;
    const moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    if (!name) { this.steer(e, moves[e.key]); return; }
    if (moves[e.key]) {
      const to = shape.where(this.state, name).map((c, k) => c + moves[e.key][k]);
      this.commit(shape.moved(this.state, name, to, this.together));
    } else if (e.key === "Delete" || e.key === "Backspace") this.remove(name);
    else if (e.key === "f") this.commit(shape.reassigned(this.state, name));
    else return;
    e.preventDefault();
    e.stopPropagation();
  }

  /* a place is moved by the arrow keys where no vertex has the focus; Enter does there what a click would */
  steer(e, move) {
    if (move) {
      const from = this.cursor || [0, 1].map(c => Math.round(this.box[c] + this.box[c + 2] / 2));
      this.cursor = [from[0] + move[0], from[1] + move[1]];
      if (this.trace) this.trace.pointer = this.snapped(this.cursor);
      this.paint();
      this.on.hint(say("pointAt", { x: this.cursor[0], y: this.cursor[1] }));
    } else if (e.key === "Enter" && this.cursor) this.act(this.cursor, this.reach(this.cursor));
    else if (e.key === "Enter" && this.trace) this.closeTrace();
    else return;
    if (this.cursor) this.svg.focus({ preventScroll: true });
    e.preventDefault();
  }
}
