/* A sheet to draw on with mouse, pen or finger: freehand, or straight lines whose ends snap to earlier ends. */
const SNAP = 16, PEN = 4;

export class Sketchpad {
  constructor(canvas) {
    this.canvas = canvas;
    this.context = canvas.getContext("2d");
    this.straight = true;
    this.dashed = false;
    this.strokes = [];
    this.undone = [];
    this.current = null;
    canvas.addEventListener("pointerdown", e => this.down(e));
    canvas.addEventListener("pointermove", e => this.move(e));
    canvas.addEventListener("pointerup", e => this.up(e));
    canvas.addEventListener("pointercancel", () => { this.current = null; this.paint(); });
    this.paint();
  }

  /* where an event lies on the sheet, whatever the size it is shown at */
  at(e) {
    const box = this.canvas.getBoundingClientRect(), { width, height } = this.canvas;
    const scale = Math.min(box.width / width, box.height / height);
    return [(e.clientX - box.left - (box.width - width * scale) / 2) / scale, (e.clientY - box.top - (box.height - height * scale) / 2) / scale];
  }

  snapped(p) {
    const ends = this.strokes.flatMap(s => [s.points[0], s.points[s.points.length - 1]]);
    const near = ends.map(q => [Math.hypot(q[0] - p[0], q[1] - p[1]), q]).sort((a, b) => a[0] - b[0])[0];
    return near && near[0] < SNAP ? [...near[1]] : p;
  }

  down(e) {
    if (e.button > 0 || this.current) return;
    e.preventDefault();
    this.canvas.setPointerCapture(e.pointerId);
    const p = this.at(e);
    this.current = { id: e.pointerId, straight: this.straight, dashed: this.dashed, points: [this.straight ? this.snapped(p) : p] };
    this.paint();
  }

  move(e) {
    if (!this.current || e.pointerId !== this.current.id) return;
    const points = this.current.points;
    if (this.current.straight) points[1] = this.snapped(this.at(e));
    else points.push(...(e.getCoalescedEvents ? e.getCoalescedEvents() : [e]).map(c => this.at(c)));
    this.paint();
  }

  up(e) {
    if (!this.current || e.pointerId !== this.current.id) return;
    const { points, dashed } = this.current, [a, b] = [points[0], points[points.length - 1]];
    const long = points.some(p => Math.hypot(p[0] - a[0], p[1] - a[1]) > 4);
    this.current = null;
    if (long && b) { this.strokes.push({ points, dashed }); this.undone = []; }
    this.paint();
    this.canvas.dispatchEvent(new Event("change"));
  }

  undo() { if (this.strokes.length) this.undone.push(this.strokes.pop()); this.paint(); }

  redo() { if (this.undone.length) this.strokes.push(this.undone.pop()); this.paint(); }

  clear() { this.strokes = []; this.undone = []; this.paint(); }

  paint() {
    const pen = this.context;
    pen.fillStyle = "#fff";
    pen.fillRect(0, 0, this.canvas.width, this.canvas.height);
    pen.strokeStyle = "#1c2028";
    pen.lineWidth = PEN;
    pen.lineCap = pen.lineJoin = "round";
    for (const stroke of [...this.strokes, ...(this.current ? [this.current] : [])]) {
      pen.setLineDash(stroke.dashed ? [14, 12] : []);
      pen.beginPath();
      stroke.points.forEach((p, k) => k ? pen.lineTo(...p) : pen.moveTo(...p));
      pen.stroke();
    }
    pen.setLineDash([]);
  }

  picture() { return new Promise(done => this.canvas.toBlob(done, "image/png")); }
}
