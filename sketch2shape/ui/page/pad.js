/* The sheet to draw on with mouse, pen, finger and keyboard. It shows strokes and makes new ones; what becomes of them is the
   page's business. Sheet units are CSS pixels at a zoom of one. */
import { gap } from "./geometry.js";
import { paintSheet, trace } from "./painting.js";
import { pulled } from "./round.js";
import { REACH, corners, dragged, endsOf, goesStraight, settled, snapped, stamped, strokeAt, tidied } from "./tidy.js";
import { say } from "./words.js";

/* a contact wider than this is a palm, CSS pixels; a finger does not draw for so long after a pen did, ms */
const PALM = 55, AFTER_PEN = 20000;
/* a second finger within this time and way of the first one zooms, later it locks the axis */
const PINCH_MS = 250, PINCH_WAY = 14;
/* grid cell, sheet units; margin round what is drawn */
const CELL = 24, MARGIN = 28;
/* where the sheet is narrower than this, the buttons at its foot would hide too much of what is drawn, CSS pixels */
const NARROW = 480, BUTTONS = 54;
const LEAST_ZOOM = 0.2, MOST_ZOOM = 8;

export class Pad {
  /* on: {change(strokes): a step was made, say(words), paint(): the view has changed} */
  constructor(canvas, on) {
    Object.assign(this, { canvas, on, tool: "pen", gridKind: "", strokes: [], shown: null, marks: { loose: [], missing: [], left: [] } });
    Object.assign(this, { view: { x: 0, y: 0, s: 1 }, current: null, grip: null, selected: new Set(), cursor: null, penTime: -AFTER_PEN, space: false });
    this.fingers = new Map();
    this.context = canvas.getContext("2d");
    for (const [kind, does] of Object.entries({ pointerdown: "down", pointermove: "move", pointerup: "up", pointercancel: "drop", keydown: "key" })) {
      canvas.addEventListener(kind, e => this[does](e));
    }
    canvas.addEventListener("wheel", e => this.wheel(e), { passive: false });
    canvas.addEventListener("contextmenu", e => e.preventDefault());
    document.addEventListener("keydown", e => { if (e.key === "Escape") this.cancel(); });
    new ResizeObserver(() => this.paint()).observe(canvas);
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.paint());
  }

  get unit() { return 1 / this.view.s; }

  get grid() { return this.gridKind ? { kind: this.gridKind, cell: CELL } : null; }

  show(strokes) {
    this.strokes = strokes;
    this.selected.clear();
    this.current = this.grip = null;
    this.paint();
  }

  /* the outline of what was found: {front: [ring, ...], sure} */
  over(shown) { this.shown = shown; this.paint(); }

  mark(marks) { this.marks = marks; this.paint(); }

  setTool(tool) {
    this.cancel();
    this.tool = tool;
    this.canvas.dataset.tool = tool;
    this.selected.clear();
    this.on.say({ erase: say("hintErase"), select: say("hintSelect"), hand: say("hintHand") }[tool] || say("hintPad"));
    this.paint();
  }

  setGrid(kind) { this.gridKind = kind; this.paint(); }

  /* a step is made: strokes as they are now */
  commit(strokes) {
    this.strokes = strokes;
    this.paint();
    this.on.change(strokes);
  }

  clear() { if (this.strokes.length) { this.selected.clear(); this.commit([]); } }

  addLine(a, b) { if (gap(a, b) > 1) this.commit([...this.strokes, { points: [a, b], dashed: this.tool === "dashed" }]); }

  /* each pair of loose ends that nearly meet is brought together, and each end that nearly meets a corner goes there */
  join() {
    let strokes = this.strokes;
    const done = [];
    for (const { point, other, held } of this.marks.loose) {
      if (!other || done.some(p => gap(p, point) < 1e-6 || gap(p, other) < 1e-6)) continue;
      if (!held) done.push(point, other);
      strokes = held ? dragged(strokes, point, other) : dragged(strokes, other, point);
    }
    this.commit(strokes);
  }

  /* ---- view */
  box() { return this.canvas.getBoundingClientRect(); }

  at(e) {
    const box = this.box();
    return [(e.clientX - box.left) / this.view.s + this.view.x, (e.clientY - box.top) / this.view.s + this.view.y];
  }

  onScreen([x, y]) { return [(x - this.view.x) * this.view.s, (y - this.view.y) * this.view.s]; }

  /* zoom about a place of the sheet */
  zoom(factor, about) {
    const box = this.box(), { x, y, s } = this.view;
    const next = Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, s * factor));
    const [cx, cy] = about || [x + box.width / 2 / s, y + box.height / 2 / s];
    this.view = { x: cx - (cx - x) * s / next, y: cy - (cy - y) * s / next, s: next };
    this.paint();
  }

  pan(dx, dy) { this.view = { ...this.view, x: this.view.x - dx / this.view.s, y: this.view.y - dy / this.view.s }; this.paint(); }

  /* where the strokes are: {x, y, width, height} with a margin, whole units */
  frame() {
    const points = this.strokes.flatMap(s => s.points);
    if (!points.length) return { x: 0, y: 0, width: 400, height: 300 };
    const low = [0, 1].map(c => Math.floor(Math.min(...points.map(p => p[c]))) - MARGIN);
    const high = [0, 1].map(c => Math.ceil(Math.max(...points.map(p => p[c]))) + MARGIN);
    return { x: low[0], y: low[1], width: high[0] - low[0], height: high[1] - low[1] };
  }

  fit() {
    if (!this.strokes.length) this.view = { x: 0, y: 0, s: 1 };
    else {
      const { x, y, width, height } = this.frame(), box = this.box(), tall = box.height - (box.width < NARROW ? BUTTONS : 0);
      const s = Math.min(MOST_ZOOM, Math.max(LEAST_ZOOM, Math.min(box.width / width, tall / height, 2)));
      this.view = { s, x: x - (box.width / s - width) / 2, y: y - (tall / s - height) / 2 };
    }
    this.paint();
  }

  /* the strokes as a PNG of the frame, dark on white, whatever the colours of the page */
  picture() {
    const frame = this.frame(), canvas = Object.assign(document.createElement("canvas"), { width: frame.width, height: frame.height });
    const pen = canvas.getContext("2d");
    pen.fillStyle = "#fff";
    pen.fillRect(0, 0, frame.width, frame.height);
    Object.assign(pen, { strokeStyle: "#1c2028", lineWidth: 2.5, lineCap: "round", lineJoin: "round" });
    for (const stroke of this.strokes) trace(pen, stroke, p => [p[0] - frame.x, p[1] - frame.y]);
    return new Promise(done => canvas.toBlob(done, "image/png"));
  }

  /* ---- pointers */
  reachOf(e) { return REACH[e.pointerType] || REACH.mouse; }

  isPalm(e) {
    return e.pointerType === "touch" && (Math.max(e.width || 0, e.height || 0) > PALM || performance.now() - this.penTime < AFTER_PEN);
  }

  down(e) {
    if (e.button > 1) return;
    if (e.pointerType === "pen") this.penTime = performance.now();
    if (this.isPalm(e)) return;
    e.preventDefault();
    this.canvas.focus({ preventScroll: true });
    this.cursor = null;
    this.fingers.set(e.pointerId, { x: e.clientX, y: e.clientY });
    try { this.canvas.setPointerCapture(e.pointerId); } catch { /* it has gone already */ }
    if (this.fingers.size === 2) { this.second(); return; }
    if (this.fingers.size > 2) return;
    const at = this.at(e);
    if (this.tool === "hand" || e.button === 1 || this.space) this.grip = { pan: true };
    else if (this.tool === "erase") { this.grip = { erase: true, before: this.strokes }; this.rub(e); }
    else if (this.tool === "select") this.take(e, at);
    else this.begin(e, at);
    this.paint();
  }

  begin(e, at) {
    const p = [...at, 0, e.pressure || 0];
    this.current = { id: e.pointerId, time: e.timeStamp, reach: this.reachOf(e), path: [p], lock: e.shiftKey, dashed: this.tool === "dashed", way: 0 };
    this.preview();
  }

  /* a second finger: zoom if the first has hardly moved, else lock the axis */
  second() {
    const c = this.current;
    if (c && (performance.now() - c.time > PINCH_MS || c.way > PINCH_WAY)) { c.lock = true; this.preview(); return; }
    this.cancel(true);
    this.grip = { pinch: this.spread() };
  }

  spread() {
    const [a, b] = [...this.fingers.values()];
    return { gap: Math.hypot(a.x - b.x, a.y - b.y) || 1, x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
  }

  move(e) {
    const finger = this.fingers.get(e.pointerId);
    if (!finger) { if (e.pointerType !== "touch") this.hover(e); return; }
    const before = { ...finger };
    Object.assign(finger, { x: e.clientX, y: e.clientY });
    if (this.grip?.pinch && this.fingers.size === 2) {
      const now = this.spread(), old = this.grip.pinch;
      this.pan(now.x - old.x, now.y - old.y);
      this.zoom(now.gap / old.gap, this.at({ clientX: now.x, clientY: now.y }));
      this.grip.pinch = now;
    } else if (this.grip?.pan) this.pan(e.clientX - before.x, e.clientY - before.y);
    else if (this.grip?.erase) this.rub(e);
    else if (this.grip) this.haul(e);
    else if (this.current?.id === e.pointerId) {
      const c = this.current;
      for (const part of e.getCoalescedEvents?.() || []) c.path.push([...this.at(part), Math.round(part.timeStamp - c.time), part.pressure || 0]);
      c.path.push([...this.at(e), Math.round(e.timeStamp - c.time), e.pressure || 0]);
      c.way += Math.hypot(e.clientX - before.x, e.clientY - before.y);
      c.lock = e.shiftKey || this.fingers.size > 1;
      this.preview();
    }
    this.paint();
  }

  hover(e) {
    if (!["pen", "dashed"].includes(this.tool)) return;
    const near = snapped(this.at(e), this.strokes, this.reachOf(e), this.unit, this.grid);
    this.spot = near.kind ? near.point : null;
    this.paint();
  }

  preview() {
    const c = this.current;
    if (c.path.length < 2) { c.shape = null; return; }
    const options = { reach: c.reach, unit: this.unit, grid: this.grid, lock: c.lock };
    c.straight = c.lock || goesStraight(c.path, this.unit);
    c.shape = c.straight ? settled([c.path[0], c.path[c.path.length - 1]], this.strokes, options) : null;
  }

  up(e) {
    if (!this.fingers.delete(e.pointerId)) return;
    if (e.pointerType === "pen") this.penTime = performance.now();
    const c = this.current, grip = this.grip;
    if (c?.id === e.pointerId) {
      this.current = null;
      const options = { reach: c.reach, unit: this.unit, grid: this.grid, lock: c.lock, dashed: c.dashed };
      const path = c.lock ? [c.path[0], c.path[c.path.length - 1]] : c.path;
      const made = path.length > 1 ? tidied(path, this.strokes, options) : [];
      if (made.length) this.commit([...made.reduce((all, one) => pulled(all, one, options), this.strokes), ...stamped(made, c.path)]);
    } else if (grip && this.fingers.size === 0) {
      this.grip = null;
      this.letGo(grip);
    } else if (grip?.pinch) this.grip = { pan: true };
    this.paint();
  }

  letGo(grip) {
    if (grip.box) this.selectInside(grip.from, grip.to || grip.from);
    if ((grip.erase || grip.moved) && grip.before !== this.strokes) this.commit(this.strokes);
  }

  drop(e) { this.fingers.delete(e.pointerId); this.cancel(); }

  /* what is going on is not to be; true if there was something */
  cancel(quiet = false) {
    const busy = Boolean(this.current || this.grip || this.cursor?.from);
    if (this.grip?.before) this.strokes = this.grip.before;
    this.current = this.grip = null;
    if (this.cursor) this.cursor.from = null;
    if (!quiet && !busy) this.selected.clear();
    this.paint();
    return busy;
  }

  /* ---- erase and select */
  /* all that the way from the last place to this one touches: a fast hand is told of few places */
  rub(e) {
    const near = this.reachOf(e).snap * 0.7 * this.unit, to = this.at(e), from = this.grip.at || to, steps = Math.ceil(gap(from, to) / near) || 1;
    for (let t = 1; t <= steps; t++) {
      const k = strokeAt([0, 1].map(c => from[c] + (to[c] - from[c]) * t / steps), this.strokes, near);
      if (k >= 0) this.strokes = this.strokes.filter((_, j) => j !== k);
    }
    this.grip.at = to;
  }

  take(e, at) {
    const reach = this.reachOf(e).snap * this.unit, corner = corners(this.strokes).find(c => gap(c.point, at) < reach * 0.8);
    const k = strokeAt(at, this.strokes, reach * 0.7);
    if (corner) { this.grip = { corner: corner.point, before: this.strokes }; this.selected.clear(); return; }
    if (k < 0) { if (!e.shiftKey) this.selected.clear(); this.grip = { box: true, from: at }; return; }
    if (e.shiftKey && this.selected.has(k)) this.selected.delete(k);
    else { if (!e.shiftKey && !this.selected.has(k)) this.selected.clear(); this.selected.add(k); }
    this.grip = { from: at, before: this.strokes };
  }

  haul(e) {
    const at = this.at(e), grip = this.grip;
    if (grip.box) { grip.to = at; return; }
    grip.moved = true;
    if (grip.corner) {
      const others = grip.before.filter(s => !endsOf(s).some(p => gap(p, grip.corner) < 1e-6));
      this.strokes = dragged(grip.before, grip.corner, snapped(at, others, this.reachOf(e), this.unit / 2, this.grid).point);
    } else this.strokes = this.shifted(grip.before, at[0] - grip.from[0], at[1] - grip.from[1]);
  }

  shifted(strokes, dx, dy) {
    return strokes.map((s, k) => this.selected.has(k) ? { ...s, points: s.points.map(p => [p[0] + dx, p[1] + dy, ...p.slice(2)]) } : s);
  }

  selectInside(a, b) {
    const within = p => [0, 1].every(c => p[c] >= Math.min(a[c], b[c]) && p[c] <= Math.max(a[c], b[c]));
    this.strokes.forEach((s, k) => { if (s.points.every(within)) this.selected.add(k); });
  }

  /* ---- keyboard */
  key(e) {
    if (e.ctrlKey || e.metaKey || e.altKey) return;
    const step = e.shiftKey ? 1 : 10, moves = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] };
    if (moves[e.key] && this.selected.size) this.commit(this.shifted(this.strokes, ...moves[e.key]));
    else if (moves[e.key]) this.steer(moves[e.key]);
    else if (e.key === "n" || e.key === "b") this.choose(e.key === "n" ? 1 : -1);
    else if (e.key === "Enter") this.put();
    else if ((e.key === "Delete" || e.key === "Backspace") && this.selected.size) {
      const left = this.strokes.filter((_, k) => !this.selected.has(k));
      this.selected.clear();
      this.commit(left);
    } else if (e.key === "Escape" && this.cancel()) { /* it was cancelled */ }
    else return;
    e.preventDefault();
  }

  /* the next line, or the one before, is selected */
  choose(way) {
    const n = this.strokes.length, [last = way > 0 ? -1 : 0] = this.selected, k = (last + way + n) % n;
    if (!n) return;
    this.selected = new Set([k]);
    this.cursor = null;
    const [[x1, y1], [x2, y2]] = endsOf(this.strokes[k]).map(p => p.map(Math.round));
    this.on.say(say("lineChosen", { n: k + 1, of: n, x1, y1, x2, y2 }));
    this.paint();
  }

  steer([dx, dy]) {
    const box = this.box(), middle = [Math.round((this.view.x + box.width / 2 / this.view.s) / 10) * 10, Math.round((this.view.y + box.height / 2 / this.view.s) / 10) * 10];
    this.cursor = this.cursor || { at: middle, from: null };
    this.cursor.at = [this.cursor.at[0] + dx, this.cursor.at[1] + dy];
    this.on.say(say("penAt", { x: this.cursor.at[0], y: this.cursor.at[1] }));
    this.paint();
  }

  put() {
    if (!this.cursor) { this.steer([0, 0]); return; }
    const { at, from } = this.cursor, near = snapped(at, this.strokes, { snap: 5 }, this.unit).point;
    if (!from) { this.cursor.from = near; this.on.say(say("penDown", { x: near[0], y: near[1] })); }
    else { this.cursor.from = null; this.addLine(from, near); this.on.say(say("lineDrawn", { x: near[0], y: near[1] })); }
    this.paint();
  }

  /* the wheel scrolls the page unless it is meant for the sheet */
  wheel(e) {
    if (!e.ctrlKey && !e.metaKey) return;
    e.preventDefault();
    this.zoom(Math.exp(-e.deltaY / 400), this.at(e));
  }

  paint() {
    if (this.pending) return;
    this.pending = true;
    requestAnimationFrame(() => { this.pending = false; if (paintSheet(this)) this.on.paint(); });
  }
}
