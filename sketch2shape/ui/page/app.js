/* The page: what is open, what was found, what was changed, and the wiring between them. */
import { begun } from "./begun.js";
import { photograph } from "./camera.js";
import { Editor } from "./editor.js";
import { Strip } from "./folder.js";
import { History } from "./history.js";
import { keep, kept, packed, unpacked } from "./keep.js";
import { Live } from "./live.js";
import { NONE, areEdges, faults, label, told } from "./marks.js";
import { Pad } from "./pad.js";
import { Readings } from "./readings.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { given, lengthOf, shown } from "./sizes.js";
import { Stage, colours } from "./stage.js";
import { Take, offer } from "./take.js";
import { looseEnds } from "./tidy.js";
import { fill, say } from "./words.js";

const $ = id => document.getElementById(id);
const NAMES = ["width", "height", "depth"];
/* ms: a wait worth asking how long the queue is, a pause before choices are shown and work is kept */
const LONG = 1200, PAUSE = 350;
const SURE = 0.9;
/* confidence below which a drawing with loose ends is rather what it has begun */
const EVEN = 0.5;

/* all that undo travels through: the sheet in view, strokes, objects, loose vertices; why the objects are only a guess ("" if
   they are not) and how sure they are (null once changed by hand) */
const EMPTY = { sheet: "welcome", strokes: [], objects: [], loose: [], guess: "", sure: null };
const BLANK = { kind: "sketch", blob: null, name: "", width: 0, height: 0, picture: "", corners: [], page: 0, pages: 1 };
const NO_SOLID = { solid: { vertices: [], triangles: [], edges: [] }, facts: [] };

let state = EMPTY, open = BLANK, selected = 0, families = [], marks = NONE, left = [], about = null, answer = NO_SOLID;
const history = new History(EMPTY);
/* for those who measure: ms from the end of a stroke to its solid, and what the page knows */
const timings = window.timings = { live: () => live, busy: () => live.busy, state: () => state, facts: () => answer.facts, solid: () => stage.view, zoom: () => pad.view.s, reads: kinds => { about.reads = kinds; }, fresh: () => startSketch() };

fill(document);
const stage = new Stage({ size: (name, text) => typed(name, text, true) });
const readings = new Readings($("readings"), number => set(o => { o.reading = number; }));
const pad = new Pad($("pad"), {
  change: strokes => { const before = state.strokes; step({ ...state, strokes }); follow(before); },
  say: words => { $("hint").textContent = words; },
  paint: () => label($("marks"), drawing() ? marks : NONE, p => pad.onScreen(p), () => pad.join()),
});
const editor = new Editor($("editor"), {
  hint: words => { if (state.sheet === "editor") $("hint").textContent = words; },
  change: (next, done) => { moving = !done; editor.left = []; state = { ...next, sure: null, guess: "" }; if (done) step(state); lifted(); },
  choose: name => { if (name.object !== undefined && name.object !== selected) { selected = name.object; settings(); } },
});
const take = new Take({
  stem: () => (open.name || say("paper").toLowerCase()).replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "") || "drawing",
  fact: () => answer.facts[selected] || null,
  fit: (name, text) => typed(name, text, true),
  said: tell,
  save: () => offer(new Blob([JSON.stringify({ ...correctionsNow(), source: open.name }, null, 1)], { type: "application/json" }), `${take.on.stem()}.corrections.json`),
  file: async format => {
    const shows = take.formats.find(f => f.name === format)?.group === "picture";
    return server.file(format, { ...correctionsNow(), source: open.name }, !shows ? null : open.kind === "picture" ? open.blob : await pad.picture());
  },
});
const strip = new Strip($("strip"), file => server.reconstruct(file, file.name), (file, found, error) => {
  if (error) tell(error.message, true); else showPicture(found, file, file.name);
});

/* ---- words */
function tell(words, bad = false) {
  $("message").textContent = $("message").title = words;
  $("message").classList.toggle("bad", bad);
}

/* ---- state */
const drawing = () => state.sheet === "pad";

function step(next) {
  state = next;
  history.push(state);
  saveSoon();
  buttons();
}

let saving = 0;
function saveSoon() {
  clearTimeout(saving);
  const { kind, blob, name, page } = open;
  saving = setTimeout(() => { if (state.sheet !== "welcome") keep({ state, kind, blob, name, page }); }, PAUSE);
}

/* the sheet that is in view follows the state */
function view() {
  document.body.dataset.sheet = state.sheet;
  $("draw-on").hidden = open.kind !== "sketch";
  $("pages-label").hidden = open.pages < 2;
  if (state.sheet === "editor") editor.say();
  if (drawing()) { pad.paint(); $("hint").textContent = told(marks) || say("hintPad"); }
  buttons();
}

function sheetOf() {
  return open.kind === "sketch" ? { ...pad.frame(), strokes: state.strokes } : { picture: open.picture, width: open.width, height: open.height, left: state.guess ? left : [] };
}

function goTo(sheet) {
  live.stop();
  if (sheet === "editor") { editor.open(sheetOf(), state, open.kind === "sketch" ? state.strokes.flatMap(s => [s.points[0], s.points.at(-1)]) : open.corners); pick("move"); }
  step({ ...state, sheet });
  view();
  if (sheet === "editor") editor.fit();
}

/* the corrections that say what is in view; a sketch has its frame for a picture */
function correctionsNow(told = []) {
  if (open.kind !== "sketch") return shape.corrections(state, open.width, open.height, told);
  const { x, y, width, height } = pad.frame();
  return shape.corrections(shape.shifted(state, -x, -y), width, height, told);
}

/* is there work that a new drawing would drop? */
const dirty = () => state.strokes.length > 0 || (open.kind === "picture" && history.canUndo);

/* false if the work is to be kept */
function mayDrop() {
  if (!dirty()) return Promise.resolve(true);
  return new Promise(done => {
    $("ask").returnValue = "no";
    $("ask").addEventListener("close", () => done($("ask").returnValue === "yes"), { once: true });
    $("ask").showModal();
  });
}

/* ---- draw */
function startSketch(strokes = [], wishes = []) {
  live.stop();
  open = { ...BLANK };
  strip.close();
  state = { ...EMPTY, sheet: "pad", strokes, objects: [] };
  history.reset(state);
  selected = 0;
  wished = wishes;
  pad.show(strokes);
  showAnswer(NO_SOLID);
  showStages([]);
  view();
  if (strokes.length) { pad.fit(); follow(); }
  else pad.view = { x: 0, y: 0, s: 1 };
  tell(say("welcome"));
  $("pad").focus({ preventScroll: true });
}

const live = new Live({
  ask: found,
  show: showLive,
  none: nothingYet,
  failed: error => tell(error.message, true),
  busy: is => busy(is ? say("working") : ""),
});

/* the strokes were changed: those before are given where some were only added */
function follow(before = null) {
  const { strokes, objects } = state, fits = Boolean(before) && before.length < strokes.length && ["", say("begun")].includes(state.guess) && answer.facts.length === 1
    && before.every((s, k) => s === strokes[k]) && areEdges(strokes.slice(before.length), objects[0], pad.unit);
  review(fits ? objects[0] : null);
  live.follow(strokes, fits);
}

/* what the strokes are of; where that is no solid yet, what they have begun */
async function found(strokes, signal) {
  const answered = await server.sketch(strokes, signal), odds = Math.min(...answered.objects.map(o => o.confidence));
  const open = answered.problem || (odds < EVEN && looseEnds(strokes, pad.unit).length > 0), start = open && begun(strokes, pad.unit);
  if (!start) return answered;
  const { x, y, width, height } = pad.frame(), object = { ...shape.newObject(start.f1, start.f2), lines: start.lines };
  const lifted = await server.lift(shape.corrections(shape.shifted({ ...EMPTY, objects: [object] }, -x, -y), width, height));
  return { ...lifted, objects: [{ ...object, confidence: null }], problem: { error: say("begun"), left: [] } };
}

function nothingYet(strokes) {
  amend({ ...state, objects: [], guess: "", sure: null });
  showAnswer(NO_SOLID);
  if (strokes.length) tell(say("needMore"));
}

function amend(next) {
  state = next;
  history.amend(state);
  saveSoon();
  buttons();
}

let wished = [];
async function showLive(found, isNewest) {
  if (!drawing()) return;
  const objects = shape.withWishes(found.objects, state.objects.length ? state.objects : wished);
  const some = objects.length > 0;
  amend({ ...state, objects, guess: found.problem && some ? found.problem.error : "", sure: some ? Math.min(...found.objects.map(o => o.confidence)) : null });
  left = found.problem?.left || [];
  const first = answer === NO_SOLID || !answer.facts.length;
  const wishes = objects.some(o => o.projection !== "auto" || NAMES.some(n => o.sizes[n]));
  families = found.facts.map(f => f.projection);
  const shown = wishes && some ? await server.lift(correctionsNow()) : found;
  if (!isNewest()) return;
  showAnswer(shown, first);
  review(found.objects[0]);
  if (state.guess) tell(state.guess === say("begun") ? state.guess : say("guessedLive"));
  else if (some) tell(say("foundLive", { what: found.facts.map(f => f.shape).join(", ") }));
  else tell(say("needMore"));
  chooseSoon();
}

/* what is wrong with the drawing, marked on it */
function review(found) {
  const sure = state.sure !== null && state.sure >= SURE && !state.guess;
  marks = faults(state.strokes, sure ? null : found, pad.unit, found && state.guess ? left : []);
  pad.mark(marks);
  pad.over(found ? { sure, front: state.objects.flatMap(o => shape.rings(o).map((_, r) => shape.outline(o, r, 1))) } : null);
  if (drawing()) $("hint").textContent = told(marks) || (found && sure ? say("hintDone") : say("hintPad"));
}

/* ---- open a picture */
let loading = 0;
async function load(blob, name, page = 0) {
  if (!await mayDrop()) return;
  const kind = (/\.(heic|heif|pdf|svgz?)$/i.exec(name)?.[1] || "").toLowerCase().replace("heif", "heic").replace("svgz", "svg");
  if (about && kind && about.reads[kind] === false) { tell(say("cannotRead", { kind: kind.toUpperCase() }), true); return; }
  if (about && blob.size > about.most) { tell(say("tooLarge", { name, most: Math.floor(about.most / 2 ** 20) }), true); return; }
  strip.close();
  const turn = ++loading;
  busy(say("looking", { name }));
  tell(say("looking", { name }));
  try {
    const found = await server.reconstruct(blob, name, page);
    if (turn === loading) showPicture(found, blob, name, page);
  } catch (error) {
    if (turn === loading) tell(error.message, true);
  } finally {
    if (turn === loading) busy("");
  }
}

function showPicture(found, blob, name, page = 0) {
  live.stop();
  left = found.problem?.left || [];
  const { width, height, picture, corners, pages } = found, some = found.objects.length > 0;
  open = { kind: "picture", blob, name, width, height, picture, corners, page, pages };
  $("pages").replaceChildren(...Array.from({ length: pages }, (_, k) => new Option(say("pages", { n: k + 1, of: pages }), k, false, k === page)));
  state = { ...EMPTY, sheet: "editor", objects: shape.withWishes(found.objects, []), sure: some ? Math.min(...found.objects.map(o => o.confidence)) : null, guess: found.problem && some ? found.problem.error : "" };
  history.reset(state);
  selected = 0;
  pad.show([]);
  editor.open(sheetOf(), state, corners);
  view();
  editor.fit();
  families = found.facts.map(f => f.projection);
  showAnswer(found, true);
  showStages(found.stages);
  saveSoon();
  pick(some ? "move" : "trace");
  if (state.guess) tell(say("guessed", { why: left.length ? say("leftOver") : state.guess }));
  else if (found.problem) tell(say("foundNot", { why: found.problem.error }), true);
  else tell(state.objects.length > 1 ? say("foundMany", { n: state.objects.length, name }) : say("found", { name }));
  chooseSoon();
}

/* ---- the solid follows the vertices and wishes: one request at a time, the latest state last */
let lifting = false, again = false, moving = false;

async function lifted() {
  buttons();
  if (!state.objects.length) { showAnswer(NO_SOLID); joinLoose(); return; }
  if (!moving && state.loose.length && state.loose.every(v => v.face)) joinLoose();
  if (lifting) { again = true; return; }
  lifting = true;
  try {
    do {
      again = false;
      const still = !moving, found = await server.lift(correctionsNow(still ? [] : families));
      if (still) families = found.facts.map(f => f.projection);
      showAnswer(found);
      tell(say("follows"));
    } while (again);
    chooseSoon();
  } catch (error) {
    tell(error.message, true);
  } finally {
    lifting = false;
    if (again) lifted();
  }
}

/* loose vertices become an object once each is told to be of the front or the back and there are as many of both */
async function joinLoose() {
  const none = state.loose.filter(v => !v.face).length;
  const [front, back] = [1, 2].map(face => state.loose.filter(v => v.face === face).map(v => [v.x, v.y]));
  if (!front.length && !back.length) return;
  if (none) { tell(say("loose", { front: front.length, back: back.length, none })); return; }
  if (front.length !== back.length || front.length < 3) { tell(say("looseUneven", { front: front.length, back: back.length })); return; }
  try {
    const { f1, f2 } = await server.connect(front, back), next = shape.withObject(state, f1, f2);
    next.loose = [];
    change(next);
  } catch (error) {
    tell(error.message, true);
  }
}

function change(next) {
  step({ ...next, sure: null, guess: "" });
  editor.show(state);
  settings();
  lifted();
}

/* something is wished of the object that is selected */
function set(update, final = true) {
  const next = shape.copy(state);
  if (!next.objects[selected]) return;
  update(next.objects[selected]);
  state = next;
  if (final) step(next);
  editor.show(state);
  lifted();
}

/* a size was typed: false, and nothing else, if it is no length */
function typed(name, text, final) {
  const object = state.objects[selected], size = object && lengthOf(text, object.unit), field = $(`size-${name}`);
  const bad = size === undefined;
  field.setAttribute("aria-invalid", bad);
  $(`error-${name}`).textContent = bad ? say("badNumber") : "";
  if (bad) return false;
  set(o => given(o, name, size), final);
  return true;
}

/* ---- show */
function showAnswer(found, turn = false) {
  answer = found;
  const fact = found.facts[selected] || found.facts[0], object = state.objects[selected];
  stage.show(found.solid, found.facts, selected, { turn, guess: Boolean(state.guess && fact), drawing: state.objects.length === 1 ? object && drawn(object) : null });
  const real = fact && fact.unit !== "px", [w, h, d] = (fact?.size || []).map(c => real ? shown(c) : Math.round(c));
  const volume = real ? `${say("volume")} ${shown(fact.volume)} ${fact.unit}³.` : say("noSize");
  $("facts").textContent = fact ? `${say("facts", { w, h, d, unit: real ? ` ${fact.unit}` : "" })} ${volume}` : "";
  $("facts").dataset.volume = fact ? fact.volume : "";
  $("facts").dataset.projection = fact ? fact.projection : "";
  $("warnings").replaceChildren(...(fact ? fact.warnings : []).map(words => Object.assign(document.createElement("li"), { textContent: words })));
  const mark = $("confidence"), byHand = state.sure === null, sure = !byHand && state.sure >= SURE;
  mark.textContent = !fact ? "" : state.guess ? say("guess") : byHand ? say("byHand") : `${say(sure ? "sureYes" : "sureNo")} ${Math.round(100 * state.sure)} %`;
  mark.className = !fact ? "" : (sure || byHand) && !state.guess ? "sure" : "unsure";
  if (!fact) readings.show([], 1);
  settings();
  buttons();
}

/* the object's vertices in the order of the solid's */
const drawn = object => [...shape.rings(object).flatMap(r => r.f1), ...shape.rings(object).flatMap(r => r.f2)];

let choosing = 0;
function chooseSoon() {
  clearTimeout(choosing);
  choosing = setTimeout(async () => {
    const fact = answer.facts[selected], object = state.objects[selected];
    if (!fact || !object || fact.readings < 2) { readings.show([], 1); return; }
    try {
      const list = await server.readings(correctionsNow(), selected);
      if (state.objects[selected] === object) readings.show(list, object.reading);
    } catch { readings.show([], 1); }
  }, PAUSE);
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

let polling = 0;
function busy(words) {
  clearTimeout(polling);
  $("busy").hidden = !words;
  $("busy-words").textContent = words;
  const ask = async () => {
    try { const n = await server.waiting(); if (n > 2 && !$("busy").hidden) $("busy-words").textContent = say("queue", { n: n - 1 }); } catch { /* told elsewhere */ }
    if (!$("busy").hidden) polling = setTimeout(ask, LONG);
  };
  if (words) polling = setTimeout(ask, LONG);
}

/* ---- buttons and settings */
function buttons() {
  const some = state.objects.length > 0 && !state.guess;
  $("undo").disabled = !history.canUndo;
  $("redo").disabled = !history.canRedo;
  $("download").disabled = $("save").disabled = !some;
  $("share").disabled = $("share-too").disabled = !state.strokes.length;
  $("adjust").disabled = !state.objects.length;
  $("clear").disabled = !state.strokes.length;
  $("refresh").hidden = state.sure !== null || !some || open.kind !== "picture";
}

function settings() {
  selected = Math.max(0, Math.min(selected, state.objects.length - 1));
  const object = state.objects[selected], fact = answer.facts[selected];
  $("which-label").hidden = state.objects.length < 2;
  $("which").replaceChildren(...state.objects.map((_, k) => new Option(`${k + 1} / ${state.objects.length}`, k, false, k === selected)));
  $("settings").hidden = !object;
  $("swap").disabled = !object;
  if (!object) return;
  $("projection").value = object.projection;
  $("size-unit").value = object.unit;
  NAMES.forEach((name, k) => {
    const field = $(`size-${name}`);
    if (document.activeElement !== field) { field.value = object.sizes[name]; field.setAttribute("aria-invalid", "false"); $(`error-${name}`).textContent = ""; }
    field.placeholder = fact && fact.unit !== "px" ? shown(fact.size[k]) : "";
    const free = fact?.free === name && !object.sizes[name], mark = field.nextElementSibling;
    mark.textContent = free ? say("free") : "";
    mark.title = free ? say("freeTip") : "";
  });
}

function choose(list, key, value) {
  for (const button of list) {
    const on = button.dataset[key] === value;
    button.setAttribute("aria-checked", on);
    button.tabIndex = on ? 0 : -1;
  }
}

function pick(tool) { choose($("tools").children, "tool", tool); editor.setTool(tool); }

function pickPad(tool) { choose($("pad-tools").children, "pad", tool); pad.setTool(tool); }

function travel(back) {
  const next = back ? history.undo() : history.redo();
  if (!next) return;
  live.stop();
  state = next;
  pad.show(state.strokes);
  if (state.sheet === "editor") editor.open(sheetOf(), state, editor.corners); else editor.show(state);
  view();
  settings();
  saveSoon();
  if (drawing()) { review(state.objects[0] || null); if (state.objects.length) lifted(); else follow(); }
  else lifted();
}

/* a file from anywhere: a picture, or corrections for what is open */
async function takeFile(file) {
  if (!/\.json$/i.test(file.name || "")) { await load(file, file.name || "photo.jpg"); return; }
  try {
    const text = await file.text(), data = JSON.parse(text);
    if (Array.isArray(data) || data?.strokes) { await load(file, file.name); return; }  // a drawing, not corrections
    if (open.kind !== "picture" && !state.objects.length) { tell(say("pictureFirst"), true); return; }
    const { x, y, width, height } = open.kind === "sketch" ? pad.frame() : { x: 0, y: 0, ...open };
    const next = shape.fromCorrections(data, shape.shifted(state, -x, -y), open.name, width, height);
    change(shape.shifted(next, x, y));
    chooseSoon();
  } catch (error) {
    tell(say("notCorrections", { name: file.name, why: error.message }), true);
  }
}

/* ---- wiring */
for (const [id, does] of Object.entries({
  draw: async () => { if (await mayDrop()) startSketch(); }, "start-draw": async () => { if (await mayDrop()) startSketch(); },
  home: () => { if (state.sheet !== "welcome") { $("go-on").hidden = false; resume = { state, open }; state = { ...state, sheet: "welcome" }; view(); tell(say("kept")); } },
  photo: () => photograph(blob => load(blob, "photo.jpg"), words => tell(words, true)), "start-photo": () => photograph(blob => load(blob, "photo.jpg"), words => tell(words, true)),
  undo: () => travel(true), redo: () => travel(false), clear: () => pad.clear(), adjust: () => goTo("editor"), "draw-on": () => { goTo("pad"); review(state.objects[0] || null); },
  download: () => take.open(), numbers: () => $("numbers-box").showModal(),
  "zoom-in": () => drawing() ? pad.zoom(1.4) : editor.zoom(1 / 1.4), "zoom-out": () => drawing() ? pad.zoom(1 / 1.4) : editor.zoom(1.4), "zoom-fit": () => drawing() ? pad.fit() : editor.fit(),
  swap: () => { if (state.objects.length) change(shape.swapped(state, selected)); },
  anyway: () => { editor.left = []; editor.paint(); step({ ...state, guess: "", sure: null }); showAnswer(answer); tell(say("follows")); },
  "share-too": () => { $("take").close(); $("share").click(); },
  share: async () => {
    const text = await packed(state);
    if (!text) { tell(say("linkLong"), true); return; }
    $("link-text").value = `${location.origin}/#d=${text}`;
    $("link-box").showModal();
  },
  copy: async () => {
    $("link-text").select();
    try { await navigator.clipboard.writeText($("link-text").value); } catch { document.execCommand("copy"); }
    tell(say("copied"));
  },
  refresh: async () => {
    try { showStages((await server.stages(open.blob, correctionsNow())).stages); } catch (error) { tell(error.message, true); }
  },
})) $(id).addEventListener("click", does);

let resume = null;
$("go-on").addEventListener("click", async () => { if (resume) goBack(); else restore(await kept()); });
function goBack() { ({ state, open } = resume); resume = null; view(); }

for (const [id, does] of Object.entries({
  file: e => { if (e.files[0]) takeFile(e.files[0]); }, shot: e => { if (e.files[0]) load(e.files[0], e.files[0].name); },
  folder: async e => { const files = [...e.files]; if (files.length && await mayDrop() && !await strip.show(files)) tell(say("noPictures"), true); },
})) $(id).addEventListener("change", e => { does(e.target); e.target.value = ""; });
$("grid").addEventListener("change", e => pad.setGrid(e.target.value));
$("pair").addEventListener("change", e => { editor.together = e.target.checked; });
$("which").addEventListener("change", e => { selected = Number(e.target.value); showAnswer(answer); chooseSoon(); });
$("pages").addEventListener("change", e => load(open.blob, open.name, Number(e.target.value)));
$("projection").addEventListener("change", e => set(o => { o.projection = e.target.value; o.reading = 1; }));
$("size-unit").addEventListener("change", e => set(o => { o.unit = e.target.value; }));
for (const name of NAMES) {
  $(`size-${name}`).addEventListener("input", e => typed(name, e.target.value, false));
  $(`size-${name}`).addEventListener("change", e => typed(name, e.target.value, true));
}
$("settings").addEventListener("submit", e => e.preventDefault());
$("numbers-box").querySelector("form").addEventListener("submit", e => {
  e.preventDefault();
  const [x1, y1, x2, y2] = ["from-x", "from-y", "to-x", "to-y"].map(id => Number($(id).value));
  pad.addLine([x1, y1], [x2, y2]);
  $("from-x").value = x2;
  $("from-y").value = y2;
  $("to-x").focus();
});
$("numbers-box").querySelector(".close").addEventListener("click", () => $("numbers-box").close());
for (const [id, key, does] of [["tools", "tool", pick], ["pad-tools", "pad", pickPad]]) {
  $(id).addEventListener("click", e => { const button = e.target.closest("button"); if (button) does(button.dataset[key]); });
  $(id).addEventListener("keydown", e => {
    const list = [...$(id).children], k = list.indexOf(document.activeElement);
    const way = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[e.key];
    if (!way || k < 0) return;
    const next = list[(k + way + list.length) % list.length];
    does(next.dataset[key]);
    next.focus();
    e.preventDefault();
  });
}
document.addEventListener("keydown", e => {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && !["checkbox", "range"].includes(e.target.type);
  const command = e.ctrlKey || e.metaKey, key = e.key.toLowerCase();
  if (typing || document.querySelector("dialog[open]")) return;
  if (command && (key === "z" || key === "y")) {
    e.preventDefault();
    travel(key === "z" && !e.shiftKey);
  } else if (!command && !e.altKey && state.sheet === "editor" && e.target.id !== "solid") {
    const tool = { m: "move", a: "add", d: "delete", t: "trace", r: "front" }[key];
    if (tool) pick(tool);
    if (key === "escape") editor.cancel();
  } else if (!command && !e.altKey && drawing() && e.target.id !== "solid") {
    const tool = { p: "pen", d: "dashed", e: "erase", s: "select" }[key];
    if (tool) pickPad(tool);
    if (key === " " && e.target.id === "pad") { pad.space = true; e.preventDefault(); }
  }
});
document.addEventListener("keyup", e => { if (e.key === " ") pad.space = false; });
document.addEventListener("paste", e => {
  const file = [...(e.clipboardData?.files || [])][0];
  if (file) { e.preventDefault(); takeFile(file); }
});
document.addEventListener("dragover", e => { e.preventDefault(); document.body.classList.add("dropping"); });
document.addEventListener("dragleave", e => { if (!e.relatedTarget) document.body.classList.remove("dropping"); });
document.addEventListener("drop", e => {
  e.preventDefault();
  document.body.classList.remove("dropping");
  if (e.dataTransfer?.files[0]) takeFile(e.dataTransfer.files[0]);
});

/* ---- what was kept, what a link holds */
async function restore(work) {
  if (!work) return;
  if (work.kind === "picture" && work.blob) {
    await load(work.blob, work.name, work.page);
    if (JSON.stringify(work.state.objects) !== JSON.stringify(state.objects)) change({ ...state, objects: work.state.objects, loose: work.state.loose });
  } else if (work.state?.strokes) startSketch(work.state.strokes, work.state.objects);
}

async function fromLink() {
  const text = /^#d=([\w-]+)$/.exec(location.hash)?.[1];
  if (!text) return false;
  try {
    const { strokes, wishes } = await unpacked(text);
    if (!await mayDrop()) return true;
    startSketch(strokes, wishes.map(w => ({ ...shape.newObject([], []), ...w })));
    window.history.replaceState(null, "", "/");
  } catch {
    tell(say("linkBad"), true);
  }
  return true;
}
addEventListener("hashchange", fromLink);

/* ---- first screen */
async function openExample({ name, title }) {
  try { await load(await server.example(name), `${title.toLowerCase()}.png`); } catch (error) { tell(error.message, true); }
}

function hero() {
  const f = [[0, 0], [0, 120], [120, 120], [120, 70], [50, 70], [50, 0]].map(([x, y]) => [x, y]), n = f.length;
  const vertices = [...f.map(([x, y]) => [x, y, 0]), ...f.map(([x, y]) => [x, y, 90])];
  const caps = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]].flatMap(t => [[t[0], t[2], t[1]], t.map(k => k + n)]);
  const sides = f.flatMap((_, k) => { const j = (k + 1) % n; return [[k, j, j + n], [k, j + n, k + n]]; });
  const edges = f.flatMap((_, k) => [[k, (k + 1) % n], [k + n, (k + 1) % n + n], [k, k + n]]);
  const show = new SolidView($("hero-solid"), { vertices, triangles: [...caps, ...sides], edges, view: [28, 22] }, { still: true, hidden: false, colours: colours(document.body) });
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  let before = performance.now();
  const turn = now => {
    if (state.sheet === "welcome" && !document.hidden) show.turn((now - before) * 0.014, 0);
    before = now;
    requestAnimationFrame(turn);
  };
  requestAnimationFrame(turn);
}

async function begin() {
  hero();
  settings();
  view();
  tell(say("welcome"));
  const work = await kept(), type = performance.getEntriesByType("navigation")[0]?.type;
  if (!await fromLink()) {
    if (work && (type === "reload" || type === "back_forward")) restore(work);
    else $("go-on").hidden = !work;
  }
  try {
    about = await server.about();
  } catch (error) {
    tell(error.message, true);
    return;
  }
  take.offers(about.formats);
  $("gallery").append(...about.examples.map(e => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.append(Object.assign(document.createElement("img"), { src: `/examples/${e.name}.png`, alt: "", loading: "lazy" }), e.title);
    button.addEventListener("click", () => openExample(e));
    item.append(button);
    return item;
  }));
}

begin();
