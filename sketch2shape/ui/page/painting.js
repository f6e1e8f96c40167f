/* The sheet of the pad painted: its grid, the strokes, what is being done, and what is wrong. */
const DASH = [9, 7];
/* round the middle of a place, CSS pixels: ends that snap, ends that are loose, the pen that keys move */
const SPOT = 7, RING = 9, CROSS = 12;

/* all of a pad; false if it is not in view */
export function paintSheet(pad) {
  const box = pad.box(), ratio = window.devicePixelRatio || 1;
  if (!box.width) return false;
  const w = Math.round(box.width * ratio), h = Math.round(box.height * ratio);
  if (pad.canvas.width !== w || pad.canvas.height !== h) Object.assign(pad.canvas, { width: w, height: h });
  const pen = pad.context, style = getComputedStyle(pad.canvas), colour = name => style.getPropertyValue(`--${name}`).trim();
  const place = p => pad.onScreen(p);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, box.width, box.height);
  if (pad.grid) paintGrid(pad, pen, box, colour("line"));
  Object.assign(pen, { lineCap: "round", lineJoin: "round" });
  paintFound(pad.shown, pen, colour, place);
  pad.strokes.forEach((stroke, k) => {
    const chosen = pad.selected.has(k);
    Object.assign(pen, { strokeStyle: colour(chosen ? "front" : "pen"), lineWidth: chosen ? 3.4 : 2.4 });
    trace(pen, stroke, place);
  });
  paintStroke(pad, pen, colour, place);
  paintCursor(pad.cursor, pen, colour, place);
  paintMarks(pad.marks, pen, colour, place);
  return true;
}

/* a stroke, its points put where `place` says */
export function trace(pen, stroke, place) {
  pen.setLineDash(stroke.dashed ? DASH : []);
  pen.beginPath();
  stroke.points.forEach((p, k) => k ? pen.lineTo(...place(p)) : pen.moveTo(...place(p)));
  pen.stroke();
  pen.setLineDash([]);
}

function paintGrid(pad, pen, box, colour) {
  Object.assign(pen, { strokeStyle: colour, lineWidth: 1 });
  pen.beginPath();
  const cell = pad.grid.cell * pad.view.s, [ox, oy] = pad.onScreen([0, 0]);
  const upright = step => { for (let x = ox % step; x < box.width; x += step) { pen.moveTo(x, 0); pen.lineTo(x, box.height); } };
  const sloping = (slope, step) => {  // lines y = slope * x + k * step
    const reach = Math.abs(slope) * box.width, from = oy - slope * ox;
    for (let y = ((from % step) + step) % step - step - reach; y < box.height + reach + step; y += step) { pen.moveTo(0, y); pen.lineTo(box.width, y + slope * box.width); }
  };
  if (pad.gridKind === "square") { upright(cell); sloping(0, cell); }
  else { upright(cell * Math.cos(Math.PI / 6)); for (const side of [-1, 1]) sloping(side * Math.tan(Math.PI / 6), cell); }
  pen.stroke();
}

function paintFound(shown, pen, colour, place) {
  if (!shown) return;
  pen.globalAlpha = shown.sure ? 0.13 : 0.06;
  pen.fillStyle = colour("front");
  pen.beginPath();
  for (const ring of shown.front) { ring.forEach((p, k) => k ? pen.lineTo(...place(p)) : pen.moveTo(...place(p))); pen.closePath(); }
  pen.fill("evenodd");
  pen.globalAlpha = 1;
}

/* the stroke that is being drawn, or where one would begin; the box that selects */
function paintStroke({ current, spot, cursor, grip }, pen, colour, place) {
  const ring = p => { pen.beginPath(); pen.arc(...place(p), SPOT, 0, 7); Object.assign(pen, { strokeStyle: colour("front"), lineWidth: 2 }); pen.stroke(); };
  if (current) {
    Object.assign(pen, { strokeStyle: colour("front"), lineWidth: 2.6 });
    trace(pen, { points: current.shape ? current.shape.points : current.path, dashed: current.dashed }, place);
    current.shape?.kinds.forEach((kind, k) => { if (kind) ring(current.shape.points[k]); });
  } else if (spot && !cursor) ring(spot);
  if (grip?.to && grip.box) {
    const [a, b] = [place(grip.from), place(grip.to)];
    Object.assign(pen, { strokeStyle: colour("front"), lineWidth: 1 });
    pen.strokeRect(a[0], a[1], b[0] - a[0], b[1] - a[1]);
  }
}

function paintCursor(cursor, pen, colour, place) {
  if (!cursor) return;
  const [x, y] = place(cursor.at);
  Object.assign(pen, { strokeStyle: colour("front"), lineWidth: 1.5 });
  pen.beginPath();
  for (const [dx, dy] of [[1, 0], [0, 1]]) { pen.moveTo(x - CROSS * dx, y - CROSS * dy); pen.lineTo(x + CROSS * dx, y + CROSS * dy); }
  pen.stroke();
  if (cursor.from) trace(pen, { points: [cursor.from, cursor.at] }, place);
}

function paintMarks({ loose, left, missing }, pen, colour, place) {
  const lines = (list, width, dash) => {
    Object.assign(pen, { lineWidth: width });
    pen.setLineDash(dash);
    for (const [a, b] of list) { pen.beginPath(); pen.moveTo(...place(a)); pen.lineTo(...place(b)); pen.stroke(); }
  };
  Object.assign(pen, { strokeStyle: colour("bad"), lineWidth: 2 });
  for (const { point } of loose) { pen.beginPath(); pen.arc(...place(point), RING, 0, 7); pen.stroke(); }
  lines(left, 4, [9, 6]);
  lines(missing, 2, [3, 6]);
  pen.setLineDash([]);
}
