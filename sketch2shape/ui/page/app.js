/* The page: what is open, what was found, what was changed, and the wiring between them. */
import { Editor } from "./editor.js";
import { History } from "./history.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { Sketchpad } from "./sketchpad.js";

const $ = id => document.getElementById(id);
const EMPTY = { objects: [], loose: [] };

const open = { blob: null, name: "", width: 0, height: 0, confidence: null };
const history = new History(EMPTY);
let state = EMPTY, selected = 0, loading = 0, moving = false, families = [];

const solid = new SolidView($("solid"));
const pad = new Sketchpad($("pad"));
const editor = new Editor($("editor"), {
  hint: words => { $("hint").textContent = words; },
  change: (next, done) => { state = next; moving = !done; if (done) history.push(state); followed(); },
  choose: name => { if (name.object !== undefined && name.object !== selected) { selected = name.object; settings(); } },
});

/* ---- words */
function say(words, bad = false) {
  $("message").textContent = words;
  $("message").classList.toggle("bad", bad);
}

/* ---- which of the three sheets is in view */
function view(which) {
  $("welcome").hidden = which !== "welcome";
  $("pad").hidden = $("pad-tools").hidden = which !== "pad";
  $("editor").toggleAttribute("hidden", which !== "editor");
  $("tools").hidden = $("zoom").hidden = $("options").hidden = which !== "editor";
  $("hint").textContent = which === "pad" ? "Draw the front face, the back face and the edges between them; dash what is hidden, or leave it out." : "";
  if (which === "editor") { editor.fit(); editor.say(); }
  buttons();
}

const drawing = () => !$("pad").hidden;

/* ---- open a picture */
async function load(blob, name) {
  const turn = ++loading;
  $("busy").hidden = false;
  say(`Looking at ${name}…`);
  try {
    const found = await server.reconstruct(blob, name);
    if (turn === loading) show(found, blob, name);
  } catch (error) {
    if (turn === loading) say(error.message, true);
  } finally {
    if (turn === loading) $("busy").hidden = true;
  }
}

function show(found, blob, name) {
  Object.assign(open, { blob, name, width: found.width, height: found.height });
  open.confidence = found.objects.length ? Math.min(...found.objects.map(o => o.confidence)) : null;
  state = { objects: found.objects.map(o => ({ ...shape.newObject(o.f1, o.f2), holes: o.holes })), loose: [] };
  history.reset(state);
  selected = 0;
  editor.open(found.picture, found.width, found.height, state, found.corners);
  view("editor");
  families = found.facts.map(f => f.projection);
  showSolid(found);
  solid.home();
  showStages(found.stages);
  if (found.problem) {
    say(`No object was found: ${found.problem.error}. Trace it by hand: click around its front face.`, true);
    pick("trace");
  } else {
    pick("move");
    const many = state.objects.length;
    say(many > 1 ? `Found ${many} objects in ${name}.` : `Found the object in ${name}. If a vertex is wrong, drag it to its place.`);
  }
}

/* ---- the solid follows the vertices: one request at a time, the latest state last */
let lifting = false, again = false;

async function followed() {
  buttons();
  if (!state.objects.length) { showSolid({ solid: { vertices: [], triangles: [], edges: [] }, facts: [] }); return joinLoose(); }
  if (!moving && state.loose.length && state.loose.every(v => v.face)) joinLoose();
  if (lifting) { again = true; return null; }
  lifting = true;
  try {
    do {
      again = false;
      const still = !moving;
      const found = await server.lift(shape.corrections(state, open.width, open.height, still ? [] : families));
      if (still) families = found.facts.map(f => f.projection);
      showSolid(found);
      say("The solid follows your changes.");
    } while (again);
  } catch (error) {
    say(error.message, true);
  } finally {
    lifting = false;
    if (again) followed();
  }
  return null;
}

/* loose vertices become an object once each is told to be of the front or the back and there are as many of both */
async function joinLoose() {
  const undecided = state.loose.filter(v => !v.face).length;
  const [front, back] = [1, 2].map(face => state.loose.filter(v => v.face === face).map(v => [v.x, v.y]));
  if (!front.length && !back.length) return;
  if (undecided) {
    say(`${front.length} front and ${back.length} back vertices; ${undecided} still without a face: click them with the Faces tool.`);
    return;
  }
  if (front.length !== back.length || front.length < 3) {
    say(`The front face has ${front.length} vertices and the back face ${back.length}: they need as many as each other, at least three.`);
    return;
  }
  try {
    const { f1, f2 } = await server.connect(front, back);
    const next = shape.withObject(state, f1, f2);
    next.loose = [];
    change(next);
  } catch (error) {
    say(error.message, true);
  }
}

function change(next) {
  state = next;
  history.push(state);
  editor.show(state);
  settings();
  followed();
}

function showSolid({ solid: form, facts }) {
  solid.show(form);
  const fact = facts[selected] || facts[0];
  const number = x => Number(x.toPrecision(4)).toLocaleString("en", { maximumSignificantDigits: 4 });
  const rows = fact ? [
    ["Size", `${fact.size.map(number).join(" × ")} ${fact.unit}`], ["Volume", `${number(fact.volume)} ${fact.unit}³`], ["Read as", fact.projection],
  ] : [];
  $("facts").replaceChildren(...rows.flatMap(([k, v]) => [["dt", k], ["dd", v]]).map(([kind, words]) => Object.assign(document.createElement(kind), { textContent: words })));
  $("facts").dataset.volume = fact ? fact.volume : "";
  $("warnings").replaceChildren(...(fact ? fact.warnings : []).map(words => Object.assign(document.createElement("li"), { textContent: words })));
  const mark = $("confidence"), sure = open.confidence !== null && open.confidence >= 0.9;
  const words = !facts.length ? "" : history.edited ? "changed by hand" : sure ? "sure of it" : "please check it";
  mark.textContent = words && !history.edited ? `${words} (${open.confidence.toFixed(2)})` : words;
  mark.className = !words ? "" : sure || history.edited ? "sure" : "unsure";
  settings();
}

function showStages(list) {
  $("steps").hidden = !list.length;
  $("stages").replaceChildren(...list.map(stage => {
    const item = document.createElement("li");
    item.append(
      Object.assign(document.createElement("img"), { src: stage.picture, alt: "" }),
      Object.assign(document.createElement("h3"), { textContent: stage.title }),
      Object.assign(document.createElement("p"), { textContent: stage.sentence }));
    return item;
  }));
}

/* ---- buttons and settings */
function buttons() {
  const some = state.objects.length > 0;
  $("undo").disabled = drawing() ? !pad.strokes.length : !history.canUndo;
  $("redo").disabled = drawing() ? !pad.undone.length : !history.canRedo;
  $("download").disabled = $("save").disabled = !some || drawing();
  $("refresh").hidden = !history.edited || !some;
  $("make").disabled = !pad.strokes.length;
}

function settings() {
  selected = Math.max(0, Math.min(selected, state.objects.length - 1));
  const object = state.objects[selected];
  $("which-label").hidden = state.objects.length < 2;
  $("which").replaceChildren(...state.objects.map((_, k) => new Option(`${k + 1} of ${state.objects.length}`, k, false, k === selected)));
  for (const id of ["projection", "size-name", "size-value", "size-unit", "swap"]) $(id).disabled = !object;
  if (!object) return;
  $("projection").value = object.projection;
  for (const part of ["name", "value", "unit"]) {
    if (document.activeElement !== $(`size-${part}`)) $(`size-${part}`).value = object.size[part];
  }
}

function set(update) {
  const next = shape.copy(state);
  update(next.objects[selected]);
  state = next;
  history.push(state);
  editor.show(state);
  followed();
}

function pick(tool) {
  for (const button of $("tools").children) {
    const on = button.dataset.tool === tool;
    button.setAttribute("aria-checked", on);
    button.tabIndex = on ? 0 : -1;
  }
  editor.setTool(tool);
}

function travel(back) {
  if (drawing()) { if (back) pad.undo(); else pad.redo(); buttons(); return; }
  const next = back ? history.undo() : history.redo();
  if (!next) return;
  state = next;
  editor.show(state);
  settings();
  followed();
}

function offer(blob, name) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

const stem = () => (open.name || "drawing").replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "") || "drawing";

/* a file from anywhere: a picture, or corrections for the picture that is open */
async function take(file) {
  if (!/\.json$/i.test(file.name || "")) return load(file, file.name || "pasted picture");
  if (!open.blob) return say("Open the picture first, then its corrections.", true);
  try {
    change(shape.fromCorrections(JSON.parse(await file.text())));
  } catch {
    say(`${file.name} is not a corrections file.`, true);
  }
  return null;
}

/* ---- wiring */
$("file").addEventListener("change", e => { if (e.target.files[0]) take(e.target.files[0]); e.target.value = ""; });
$("draw").addEventListener("click", () => { view("pad"); say("Draw the object, then choose Make the solid."); });
$("back").addEventListener("click", () => { view(open.blob ? "editor" : "welcome"); say("The drawing is kept for later."); });
$("make").addEventListener("click", async () => load(await pad.picture(), "my drawing.png"));
$("clear").addEventListener("click", () => { pad.clear(); buttons(); });
$("straight").addEventListener("change", e => { pad.straight = e.target.checked; });
$("dashed").addEventListener("change", e => { pad.dashed = e.target.checked; });
$("pad").addEventListener("change", buttons);
$("undo").addEventListener("click", () => travel(true));
$("redo").addEventListener("click", () => travel(false));
$("zoom-in").addEventListener("click", () => editor.zoom(1 / 1.4));
$("zoom-out").addEventListener("click", () => editor.zoom(1.4));
$("zoom-fit").addEventListener("click", () => editor.fit());
$("pair").addEventListener("change", e => { editor.together = e.target.checked; });
$("swap").addEventListener("click", () => { if (state.objects.length) change(shape.swapped(state, selected)); });
$("which").addEventListener("change", e => { selected = Number(e.target.value); settings(); followed(); });
$("projection").addEventListener("change", e => set(o => { o.projection = e.target.value; }));
for (const part of ["name", "value", "unit"]) {
  $(`size-${part}`).addEventListener("input", e => set(o => { o.size[part] = e.target.value; }));
}
$("settings").addEventListener("submit", e => e.preventDefault());
$("tools").addEventListener("click", e => { if (e.target.dataset.tool) pick(e.target.dataset.tool); });
$("tools").addEventListener("keydown", e => {
  const list = [...$("tools").children], k = list.indexOf(document.activeElement);
  const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[e.key];
  if (!step || k < 0) return;
  const next = list[(k + step + list.length) % list.length];
  pick(next.dataset.tool);
  next.focus();
  e.preventDefault();
});
$("download").addEventListener("click", async () => {
  const format = $("format").value;
  try {
    offer(await server.mesh(format, shape.corrections(state, open.width, open.height)), `${stem()}.${format}`);
    say(`${stem()}.${format} is in your downloads.`);
  } catch (error) {
    say(error.message, true);
  }
});
$("save").addEventListener("click", () => {
  const text = JSON.stringify({ ...shape.corrections(state, open.width, open.height), source: open.name }, null, 1);
  offer(new Blob([text], { type: "application/json" }), `${stem()}.corrections.json`);
});
$("refresh").addEventListener("click", async () => {
  try {
    showStages((await server.stages(open.blob, shape.corrections(state, open.width, open.height))).stages);
  } catch (error) {
    say(error.message, true);
  }
});
document.addEventListener("keydown", e => {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && e.target.type !== "checkbox";
  const command = e.ctrlKey || e.metaKey, key = e.key.toLowerCase();
  if (command && (key === "z" || key === "y") && !typing) {
    e.preventDefault();
    travel(key === "z" && !e.shiftKey);
  } else if (!command && !e.altKey && !typing && !$("tools").hidden) {
    const tool = { m: "move", a: "add", d: "delete", t: "trace" }[key];
    if (tool) pick(tool);
  }
});
document.addEventListener("paste", e => {
  const file = [...(e.clipboardData?.files || [])][0];
  if (file) { e.preventDefault(); take(file); }
});
document.addEventListener("dragover", e => { e.preventDefault(); document.body.classList.add("dropping"); });
document.addEventListener("dragleave", e => { if (!e.relatedTarget) document.body.classList.remove("dropping"); });
document.addEventListener("drop", e => {
  e.preventDefault();
  document.body.classList.remove("dropping");
  if (e.dataTransfer?.files[0]) take(e.dataTransfer.files[0]);
});

/* ---- examples */
async function openExample(name, title) {
  try { await load(await server.example(name), `${title.toLowerCase()}.png`); } catch (error) { say(error.message, true); }
}

server.examples().then(({ examples }) => {
  const titles = Object.fromEntries(examples.map(e => [e.name, e.title]));
  $("examples").append(...examples.map(e => new Option(e.title, e.name)));
  $("examples").addEventListener("change", e => { if (e.target.value) openExample(e.target.value, titles[e.target.value]); e.target.value = ""; });
  $("gallery").append(...examples.map(e => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.append(Object.assign(document.createElement("img"), { src: `/examples/${e.name}.png`, alt: "" }), e.title);
    button.addEventListener("click", () => openExample(e.name, e.title));
    item.append(button);
    return item;
  }));
}, error => say(error.message, true));

settings();
buttons();
