/* The solid on its stage: dimensions that can be changed where they stand, a view cube, standard views, a section, a ruler, a
   print bed, and the drawing that folds up into it. */
import { MILLIMETRES, measure, shown } from "./sizes.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);
const NOTHING = { vertices: [], triangles: [], edges: [] };
const AXES = { width: 0, height: 1, depth: 2 };
/* a print bed as most printers have it, mm */
const BED = 220;
const FOLD_MS = 1600;
/* yaw and pitch of the standard views, and of the cube's faces: name -> [yaw, pitch, normal, right] */
const FACES = {
  front: [0, 0, [0, 0, -1], [1, 0, 0]], back: [180, 0, [0, 0, 1], [-1, 0, 0]], side: [90, 0, [1, 0, 0], [0, 0, 1]], left: [-90, 0, [-1, 0, 0], [0, 0, -1]],
  top: [0, 90, [0, -1, 0], [1, 0, 0]], bottom: [0, -90, [0, 1, 0], [1, 0, 0]],
};

/* the colours of the page, for a renderer that knows no CSS */
export function colours(element) {
  const style = getComputedStyle(element), get = name => style.getPropertyValue(`--${name}`).trim();
  const rgb = name => (/^#(..)(..)(..)$/.exec(get(name)) || []).slice(1).map(h => parseInt(h, 16));
  return { dark: rgb("face-dark"), pale: rgb("face-pale"), edge: get("edges"), hidden: get("hidden"), cut: rgb("back"), floor: "rgba(127, 140, 160, .16)", rule: get("back") };
}

export class Stage {
  /* on: {size(name, text): a dimension was typed; gives false if it is no length; left(name): what was typed is not meant} */
  constructor(on) {
    this.on = on;
    this.view = new SolidView($("solid"), NOTHING);
    this.view.painted = () => this.painted();
    this.fact = null;
    Object.assign(this, { picked: [], next: -1 });
    this.cube = document.createElement("canvas");
    Object.assign(this.cube, { id: "cube", title: say("cube") });
    this.cube.setAttribute("role", "img");
    this.cube.setAttribute("aria-label", say("cube"));
    $("solid-stage").append(this.cube);
    this.recolour();
    matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => this.recolour());
    this.wire();
  }

  recolour() { this.view.colours = colours(document.body); this.view.draw(); }

  /* the solid of an answer: form for the renderer, facts of each object, the drawing for folding; `turn` shows it from where
     it was drawn */
  show(form, facts, chosen, { turn = false, guess = false, drawing = null } = {}) {
    this.form = form;
    this.fact = facts[chosen] || facts[0] || null;
    this.many = facts.length > 1;
    this.drawing = drawing;
    this.folding = null;
    this.rule(null);
    this.view.show(form);
    if (turn) this.byHand = false;
    if (!this.byHand) this.view.home();
    $("bed").disabled = !MILLIMETRES[this.fact?.unit];
    this.view.bed = this.bedSide();
    $("solid-empty").hidden = Boolean(this.fact);
    $("solid-stage").classList.toggle("pale", guess);
    $("guess").hidden = !guess;
    for (const id of ["dimensions", "cube", "solid-tools"]) $(id).hidden = !this.fact;
    this.labels();
  }

  /* ---- dimensions */
  labels() {
    const box = $("dimensions");
    if (box.querySelector("input")) return;
    const fact = this.fact && !this.many ? this.fact : null;
    box.replaceChildren(...(fact ? Object.keys(AXES) : []).map((name, k) => {
      const words = measure(fact.size[k], fact.unit), free = fact.free === name;
      const button = Object.assign(document.createElement("button"), { type: "button", textContent: free ? `${words} ?` : words, title: free ? say("freeTip") : "" });
      button.dataset.size = name;
      button.classList.toggle("free", free);
      button.setAttribute("aria-label", say("editSize", { name: say(name), value: shown(fact.size[k]), unit: fact.unit }));
      button.addEventListener("click", () => this.edit(button, name, shown(fact.size[k])));
      return button;
    }));
    this.view.draw();
  }

  edit(button, name, value) {
    const input = Object.assign(document.createElement("input"), { type: "text", inputMode: "decimal", value });
    input.dataset.size = name;
    input.setAttribute("aria-label", say(name));
    const why = Object.assign(document.createElement("small"), { id: "why-not" });
    why.setAttribute("role", "alert");
    input.setAttribute("aria-describedby", why.id);
    for (const e of [input, why]) Object.assign(e.style, { left: button.style.left, top: button.style.top });
    let over = false;  // what is taken off the page loses the focus, which is an end as well
    const end = keep => {
      if (over) return;
      if (keep && input.value !== value && this.on.size(name, input.value) === false) {
        input.setAttribute("aria-invalid", "true");
        why.textContent = say("badNumber");
        return;
      }
      over = true;
      input.remove();
      why.remove();
      if (!keep) this.on.left(name);
      this.labels();
      $("dimensions").querySelector(`[data-size=${name}]`)?.focus();
    };
    input.addEventListener("keydown", e => {
      e.stopPropagation();
      if (e.key === "Enter") end(true);
      if (e.key === "Escape") end(false);
    });
    input.addEventListener("input", () => { input.removeAttribute("aria-invalid"); why.textContent = ""; });
    input.addEventListener("blur", () => { if (input.getAttribute("aria-invalid") === "true") end(false); else end(true); });
    why.classList.toggle("above", parseFloat(button.style.top) > this.view.canvas.clientHeight - 48);
    button.replaceWith(input, why);
    input.focus();
    input.select();
  }

  /* the edge of the box around the solid along which a size is shown: the one farthest from the middle, low ones first */
  edgeFor(name) {
    const { low, high } = this.view, axis = (this.form.along || Object.keys(AXES)).indexOf(name);
    const [i, j] = [0, 1, 2].filter(k => k !== axis), middle = this.view.seenAt(this.view.centre);
    let best = null;
    for (const a of [low[i], high[i]]) for (const b of [low[j], high[j]]) {
      const from = [], to = [];
      from[axis] = low[axis]; to[axis] = high[axis];
      from[i] = to[i] = a; from[j] = to[j] = b;
      const [p, q] = [this.view.seenAt(from), this.view.seenAt(to)], centre = [(p[0] + q[0]) / 2, (p[1] + q[1]) / 2];
      const away = Math.hypot(centre[0] - middle[0], centre[1] - middle[1]) + (axis === 1 ? 0 : 0.9 * (centre[1] - middle[1]));
      if (!best || away > best.away) best = { away, p, q, centre, out: [centre[0] - middle[0], centre[1] - middle[1]] };
    }
    return best;
  }

  painted() {
    const box = this.view.canvas.getBoundingClientRect(), taken = [];
    const floor = box.height - (this.view.section ? 56 : 20);
    for (const e of $("dimensions").querySelectorAll("[data-size]")) {
      const { p, q, centre, out } = this.edgeFor(e.dataset.size), length = Math.hypot(...out) || 1, d = out.map(c => c / length);
      const at = [centre[0] + 34 * d[0], centre[1] + 24 * d[1]];
      const place = [Math.max(44, Math.min(box.width - 44, at[0])), Math.max(18, Math.min(floor, at[1]))];
      // of a solid that looks small the labels stand one below the other
      for (const other of taken) if (Math.abs(other[0] - place[0]) < e.offsetWidth && Math.abs(other[1] - place[1]) < e.offsetHeight) place[1] = other[1] + e.offsetHeight + 2;
      taken.push(place);
      e.style.left = `${place[0]}px`;
      e.style.top = `${place[1]}px`;
      const pen = this.view.context, s = this.view.scale, line = [p, q].map(c => [(c[0] + 12 * d[0]) * s, (c[1] + 10 * d[1]) * s]);
      Object.assign(pen, { strokeStyle: this.view.colours.hidden, lineWidth: s });
      pen.setLineDash([]);
      pen.beginPath();
      pen.moveTo(...line[0]);
      pen.lineTo(...line[1]);
      pen.stroke();
      e.style.visibility = Math.hypot(p[0] - q[0], p[1] - q[1]) < 18 ? "hidden" : "";
    }
    this.paintCube();
  }

  /* ---- view cube */
  corners(name) {
    const [, , n, r] = FACES[name], d = [n[1] * r[2] - n[2] * r[1], n[2] * r[0] - n[0] * r[2], n[0] * r[1] - n[1] * r[0]].map(c => -c);
    return [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([u, v]) => this.turned([0, 1, 2].map(k => n[k] + u * r[k] + v * d[k])));
  }

  turned([x, y, z]) {
    const a = -this.view.yaw * Math.PI / 180, b = -this.view.pitch * Math.PI / 180;
    const tx = Math.cos(a) * x - Math.sin(a) * z, away = Math.sin(a) * x + Math.cos(a) * z;
    return [tx, Math.cos(b) * y + Math.sin(b) * away, -Math.sin(b) * y + Math.cos(b) * away];
  }

  paintCube() {
    const side = 76, ratio = window.devicePixelRatio || 1, pen = this.cube.getContext("2d"), { edge, pale, dark } = this.view.colours;
    if (this.cube.width !== side * ratio) this.cube.width = this.cube.height = side * ratio;
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, side, side);
    this.faces = [];
    for (const name of Object.keys(FACES)) {
      if (this.turned(FACES[name][2])[2] > -0.05) continue;
      const points = this.corners(name).map(([x, y]) => [side / 2 + 21 * x, side / 2 + 21 * y]);
      this.faces.push({ name, points });
      pen.beginPath();
      points.forEach((p, k) => k ? pen.lineTo(...p) : pen.moveTo(...p));
      pen.closePath();
      const light = -this.turned(FACES[name][2])[2];
      pen.fillStyle = `rgb(${pale.map((c, k) => Math.round(c * (0.55 + 0.45 * light) + dark[k] * 0.15)).join(" ")})`;
      pen.fill();
      Object.assign(pen, { strokeStyle: edge, lineWidth: 1 });
      pen.stroke();
      const words = { front: "viewFront", top: "viewTop", side: "viewSide" }[name];
      if (!words) continue;
      pen.save();
      const [a, b, , d] = points;
      pen.transform((b[0] - a[0]) / 42, (b[1] - a[1]) / 42, (d[0] - a[0]) / 42, (d[1] - a[1]) / 42, a[0], a[1]);
      Object.assign(pen, { fillStyle: "#10161d", font: "600 13px system-ui, sans-serif", textAlign: "center", textBaseline: "middle" });
      pen.fillText(say(words), 21, 21);
      pen.restore();
    }
  }

  cubeClick(e) {
    const box = this.cube.getBoundingClientRect(), p = [e.clientX - box.left, e.clientY - box.top];
    const face = this.faces.find(f => f.points.every((a, k) => {
      const b = f.points[(k + 1) % 4], c = f.points[(k + 2) % 4], side = q => (b[0] - a[0]) * (q[1] - a[1]) - (b[1] - a[1]) * (q[0] - a[0]);
      return side(p) * side(c) >= 0;
    }));
    if (face) this.view.glide(FACES[face.name][0], FACES[face.name][1]);
  }

  /* ---- section and ruler */
  section() {
    const on = $("cut").getAttribute("aria-pressed") === "true", { yaw, pitch } = this.view;
    $("cut-label").hidden = !on;
    if (!on) this.view.section = null;
    else if (!this.view.section) {
      const axis = Math.abs(pitch) > 55 ? 1 : Math.abs(Math.sin(yaw * Math.PI / 180)) > 0.75 ? 0 : 2;
      const keep = axis === 1 ? (pitch > 0 ? 1 : -1) : axis === 0 ? (Math.sin(yaw * Math.PI / 180) > 0 ? -1 : 1) : Math.cos(yaw * Math.PI / 180) > 0 ? 1 : -1;
      this.view.section = { axis, keep, at: 0.5 };
    }
    if (this.view.section) {
      const at = Number($("cut-at").value) / 100;
      this.view.section.at = this.view.section.keep > 0 ? at : 1 - at;
    }
    this.view.draw();
  }

  /* a corner is clicked; without a place measuring begins anew */
  rule(place) {
    const k = place ? this.view.nearest(...place) : -1;
    if (k >= 0) { this.take(k); return; }
    if (place) return;
    Object.assign(this, { picked: [], next: -1 });
    this.view.ruler = null;
    $("measured").hidden = !this.measuring;
    $("measured").textContent = this.measuring ? say("measureFirst") : "";
  }

  /* a corner is taken, the first or the second one; `only` shows it, as if it were */
  take(k, only = false) {
    const picked = this.picked.length === 2 ? [k] : [...this.picked, k], [a, b] = picked.map(j => this.form.vertices[j]);
    if (!only) this.picked = picked;
    this.view.ruler = [a, b || a];
    $("measured").textContent = b ? say("measured", { d: measure(Math.hypot(...a.map((c, j) => c - b[j])), this.fact?.unit || "px") }) : say("measureFirst");
    this.view.draw();
  }

  /* corners by the keyboard: N for the next one, B for the one before, Enter takes it */
  measureKey(e) {
    const n = this.form?.vertices.length, way = { n: 1, b: -1 }[e.key];
    if (!this.measuring || !n || e.ctrlKey || e.metaKey || e.altKey) return;
    if (way) { this.next = (this.next + way + n) % n; this.take(this.next, true); }
    else if (e.key === "Enter" && this.next >= 0) this.take(this.next);
  }

  /* side of the print bed in the solid's unit; 0 where none is shown or the solid has no real size */
  bedSide() {
    const millimetres = MILLIMETRES[this.fact?.unit];
    return millimetres && $("bed").getAttribute("aria-pressed") === "true" ? BED / millimetres : 0;
  }

  get measuring() { return $("measure").getAttribute("aria-pressed") === "true"; }

  /* ---- the drawing folds up into the solid; at once for those who asked for less motion */
  fold() {
    const flat = this.flat(), form = this.form;
    if (!flat || matchMedia("(prefers-reduced-motion: reduce)").matches) { this.view.home(); this.view.draw(); return; }
    const home = form.view || [28, 22], begin = performance.now(), run = this.folding = {};
    const step = () => {
      if (this.folding !== run) return;
      const t = Math.min(1, (performance.now() - begin) / FOLD_MS), ease = t * t * (3 - 2 * t);
      this.view.show({ ...form, vertices: form.vertices.map((v, k) => v.map((c, j) => flat[k][j] + (c - flat[k][j]) * ease)) });
      [this.view.yaw, this.view.pitch] = home.map(c => c * ease);
      this.view.draw();
      if (t < 1) requestAnimationFrame(step); else this.view.show(form);
    };
    step();
  }

  /* the drawing's vertices as a flat sheet where the solid stands, or null if they do not match */
  flat() {
    const { vertices } = this.form, drawn = this.drawing;
    if (!drawn || drawn.length !== vertices.length) return null;
    const middle = points => [0, 1].map(c => points.reduce((s, p) => s + p[c], 0) / points.length);
    const size = (points, m) => Math.sqrt(points.reduce((s, p) => s + (p[0] - m[0]) ** 2 + (p[1] - m[1]) ** 2, 0)) || 1;
    const from = middle(drawn), to = middle(vertices), scale = size(vertices, to) / size(drawn, from);
    return drawn.map(p => [to[0] + (p[0] - from[0]) * scale, to[1] + (p[1] - from[1]) * scale, this.view.centre[2]]);
  }

  /* ---- buttons */
  wire() {
    const toggle = (id, does) => $(id).addEventListener("click", () => {
      $(id).setAttribute("aria-pressed", $(id).getAttribute("aria-pressed") !== "true");
      does($(id).getAttribute("aria-pressed") === "true");
    });
    $("views").addEventListener("click", e => {
      const face = FACES[e.target.dataset.view];
      this.byHand = Boolean(face);
      if (face) this.view.glide(face[0], face[1]);
      else if (e.target.dataset.view) this.view.glide(...(this.form?.view || [28, 22]));
    });
    this.cube.addEventListener("click", e => this.cubeClick(e));
    toggle("wireframe", on => { this.view.lines = on; this.view.draw(); });
    toggle("hidden-edges", on => { this.view.hidden = on; this.view.draw(); });
    toggle("cut", () => this.section());
    $("cut-at").addEventListener("input", () => this.section());
    toggle("measure", () => { this.rule(null); this.view.draw(); });
    toggle("bed", on => {
      this.view.bed = this.bedSide();
      this.view.zoom = on ? Math.min(1, 2 * this.view.radius / this.view.bed) : 1;  // all of the bed is in view
      this.view.draw();
    });
    $("fold").addEventListener("click", () => this.fold());
    $("full").addEventListener("click", () => document.fullscreenElement ? document.exitFullscreen() : $("solid-stage").requestFullscreen?.());
    document.addEventListener("fullscreenchange", () => $("full").setAttribute("aria-pressed", Boolean(document.fullscreenElement)));
    let pressed = null;
    $("solid").addEventListener("pointerdown", e => { pressed = [e.clientX, e.clientY]; this.byHand = true; });
    $("solid").addEventListener("click", e => {
      const box = $("solid").getBoundingClientRect();
      if (this.measuring && pressed && Math.hypot(e.clientX - pressed[0], e.clientY - pressed[1]) < 6) this.rule([e.clientX - box.left, e.clientY - box.top]);
    });
    $("solid").addEventListener("keydown", e => this.measureKey(e));
    $("solid").addEventListener("keyup", () => {  // keys of the renderer that buttons show as well
      $("wireframe").setAttribute("aria-pressed", this.view.lines);
      $("hidden-edges").setAttribute("aria-pressed", this.view.hidden);
    });
  }
}
