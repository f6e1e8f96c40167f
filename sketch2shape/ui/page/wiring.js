/* What every button, field and key does. */
import { photograph } from "./camera.js";
import { change, lifted, set, typed } from "./changing.js";
import { kept, packed } from "./keep.js";
import { fromLink, load, openFolder, restore, takeFile } from "./opening.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { correctionsNow, editor, pad, pick, pickPad, sheetOf } from "./sheets.js";
import { chooseSoon, mayDrop, settings, showAnswer, showStages, tell, view } from "./showing.js";
import { live, review, startSketch, travelled } from "./sketching.js";
import { Take, offer } from "./take.js";
import { NAMES, drawing, history, saveSoon, step, work } from "./work.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);

const corrections = () => ({ ...correctionsNow(), source: work.open.name });

export const take = new Take({
  stem: () => (work.open.name || say("paper").toLowerCase()).replace(/^.*[\\/]/, "").replace(/\.[^.]*$/, "") || "drawing",
  fact: () => work.answer.facts[work.selected] || null,
  fit: (name, text) => typed(name, text, true),
  said: tell,
  save: () => offer(new Blob([JSON.stringify(corrections(), null, 1)], { type: "application/json" }), `${take.on.stem()}.corrections.json`),
  file: async format => {
    const shows = take.formats.find(f => f.name === format)?.group === "picture";
    return server.file(format, corrections(), !shows ? null : work.open.kind === "picture" ? work.open.blob : await pad.picture());
  },
});

/* ---- from one sheet to another, through time, and home */
function goTo(sheet) {
  const { open, state } = work;
  live.stop();
  if (sheet === "editor") { editor.open(sheetOf(), state, open.kind === "sketch" ? state.strokes.flatMap(s => [s.points[0], s.points.at(-1)]) : open.corners); pick("move"); }
  step({ ...state, sheet });
  view();
  if (sheet === "editor") editor.fit();
}

function travel(back) {
  const next = back ? history.undo() : history.redo();
  if (!next) return;
  live.stop();
  work.state = next;
  pad.show(next.strokes);
  if (next.sheet === "editor") editor.open(sheetOf(), next, editor.corners); else editor.show(next);
  view();
  settings();
  saveSoon();
  if (drawing()) travelled(); else lifted();
}

/* what was in view when the start page was asked for */
let resume = null;
function goHome() {
  if (work.state.sheet === "welcome") return;
  $("go-on").hidden = false;
  resume = { state: work.state, open: work.open };
  work.state = { ...work.state, sheet: "welcome" };
  view();
  tell(say("kept"));
}

async function goOn() {
  if (!resume) { restore(await kept()); return; }
  Object.assign(work, resume);
  resume = null;
  view();
}

/* ---- buttons */
const fresh = async () => { if (await mayDrop()) startSketch(); };
const photo = () => photograph(blob => load(blob, "photo.jpg"), words => tell(words, true));

async function share() {
  const text = await packed(work.state);
  if (!text) { tell(say("linkLong"), true); return; }
  $("link-text").value = `${location.origin}/#d=${text}`;
  $("link-box").showModal();
}

async function copy() {
  $("link-text").select();
  try { await navigator.clipboard.writeText($("link-text").value); } catch { document.execCommand("copy"); }
  tell(say("copied"));
}

function takeGuess() {
  editor.left = [];
  editor.paint();
  step({ ...work.state, guess: "", sure: null });
  showAnswer(work.answer);
  tell(say("follows"));
}

async function refresh() {
  try { showStages((await server.stages(work.open.blob, correctionsNow())).stages); } catch (error) { tell(error.message, true); }
}

for (const [id, does] of Object.entries({
  draw: fresh, "start-draw": fresh, photo, "start-photo": photo, home: goHome, "go-on": goOn, share, copy, refresh, anyway: takeGuess,
  undo: () => travel(true), redo: () => travel(false), clear: () => pad.clear(),
  adjust: () => goTo("editor"), "draw-on": () => { goTo("pad"); review(work.state.objects[0] || null); },
  download: () => take.open(), "share-too": () => { $("take").close(); share(); }, numbers: () => $("numbers-box").showModal(),
  "zoom-in": () => drawing() ? pad.zoom(1.4) : editor.zoom(1 / 1.4), "zoom-out": () => drawing() ? pad.zoom(1 / 1.4) : editor.zoom(1.4), "zoom-fit": () => drawing() ? pad.fit() : editor.fit(),
  swap: () => { if (work.state.objects.length) change(shape.byHand(shape.swapped(work.state, work.selected), work.state)); },
})) $(id).addEventListener("click", does);

/* ---- fields */
for (const [id, does] of Object.entries({
  file: e => { if (e.files[0]) takeFile(e.files[0]); }, shot: e => { if (e.files[0]) load(e.files[0], e.files[0].name); },
  folder: e => openFolder([...e.files]),
})) $(id).addEventListener("change", e => { does(e.target); e.target.value = ""; });

for (const [id, does] of Object.entries({
  grid: e => pad.setGrid(e.value), pair: e => { editor.together = e.checked; },
  which: e => { work.selected = Number(e.value); showAnswer(work.answer); chooseSoon(); },
  pages: e => load(work.open.blob, work.open.name, Number(e.value)),
  projection: e => set(o => { o.projection = e.value; o.reading = 1; }), "size-unit": e => set(o => { o.unit = e.value; }),
})) $(id).addEventListener("change", e => does(e.target));

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

/* ---- tools and keys */
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

const EDITOR_KEYS = { m: "move", a: "add", d: "delete", t: "trace", r: "front" };
const PAD_KEYS = { p: "pen", d: "dashed", e: "erase", s: "select" };

document.addEventListener("keydown", e => {
  const typing = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && !["checkbox", "range"].includes(e.target.type);
  const command = e.ctrlKey || e.metaKey, key = e.key.toLowerCase();
  if (typing || document.querySelector("dialog[open]")) return;
  if (command && (key === "z" || key === "y")) {
    e.preventDefault();
    travel(key === "z" && !e.shiftKey);
  } else if (!command && !e.altKey && e.target.id !== "solid") toolKey(e, key);
});

function toolKey(e, key) {
  if (work.state.sheet === "editor") {
    if (EDITOR_KEYS[key]) pick(EDITOR_KEYS[key]);
    if (key === "escape") editor.cancel();
  } else if (drawing()) {
    if (PAD_KEYS[key]) pickPad(PAD_KEYS[key]);
    if (key === " " && e.target.id === "pad") { pad.space = true; e.preventDefault(); }
  }
}
document.addEventListener("keyup", e => { if (e.key === " ") pad.space = false; });

/* ---- files that are pasted or dropped */
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
addEventListener("hashchange", fromLink);
