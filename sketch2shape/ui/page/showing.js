/* What is to be seen of the work: messages, the solid and its facts, which buttons may be pressed. */
import { told } from "./marks.js";
import { Readings } from "./readings.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { correctionsNow, editor, pad } from "./sheets.js";
import { shown } from "./sizes.js";
import { Stage } from "./stage.js";
import { NAMES, PAUSE, SURE, dirty, drawing, history, work } from "./work.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);
/* ms: a wait worth asking how long the queue is */
const LONG = 1200;

/* what is typed and tapped on them is answered in changing.js */
export const stage = new Stage({});
export const readings = new Readings($("readings"), {});

export function tell(words, bad = false) {
  $("message").textContent = $("message").title = words;
  $("message").classList.toggle("bad", bad);
}

export function hint(words) { $("hint").textContent = words; }

let polling = 0;
/* a sign that something is being worked on; "" takes it away */
export function busy(words) {
  clearTimeout(polling);
  $("busy").hidden = !words;
  $("busy-words").textContent = words;
  const ask = async () => {
    try { const n = await server.waiting(); if (n > 2 && !$("busy").hidden) $("busy-words").textContent = say("queue", { n: n - 1 }); } catch { /* told elsewhere */ }
    if (!$("busy").hidden) polling = setTimeout(ask, LONG);
  };
  if (words) polling = setTimeout(ask, LONG);
}

/* false if the work is to be kept */
export function mayDrop() {
  if (!dirty()) return Promise.resolve(true);
  return new Promise(done => {
    $("ask").returnValue = "no";
    $("ask").addEventListener("close", () => done($("ask").returnValue === "yes"), { once: true });
    $("ask").showModal();
  });
}

/* the sheet that is in view follows the state */
export function view() {
  const { state, open, marks } = work;
  document.body.dataset.sheet = state.sheet;
  $("draw-on").hidden = open.kind !== "sketch";
  $("pages-label").hidden = open.pages < 2;
  if (state.sheet === "editor") editor.say();
  if (drawing()) { pad.paint(); hint(told(marks) || say("hintPad")); }
  buttons();
}

export function showAnswer(found, turn = false) {
  work.answer = found;
  const { state, selected } = work, fact = found.facts[selected] || found.facts[0], object = state.objects[selected];
  stage.show(found.solid, found.facts, selected, { turn, guess: Boolean(state.guess && fact), drawing: state.objects.length === 1 ? object && drawn(object) : null });
  showFacts(fact);
  showConfidence(fact);
  if (!fact) readings.show([], 1);
  settings();
  buttons();
}

/* the object's vertices in the order of the solid's */
const drawn = object => [...shape.rings(object).flatMap(r => r.f1), ...shape.rings(object).flatMap(r => r.f2)];

function showFacts(fact) {
  const real = fact && fact.unit !== "px", [w, h, d] = (fact?.size || []).map(c => real ? shown(c) : Math.round(c));
  const volume = real ? `${say("volume")} ${shown(fact.volume)} ${fact.unit}³.` : say("noSize");
  $("facts").textContent = fact ? `${say("facts", { w, h, d, unit: real ? ` ${fact.unit}` : "" })} ${volume}` : "";
  $("facts").dataset.volume = fact ? fact.volume : "";
  $("facts").dataset.projection = fact ? fact.projection : "";
  $("warnings").replaceChildren(...(fact ? fact.warnings : []).map(words => Object.assign(document.createElement("li"), { textContent: words })));
}

function showConfidence(fact) {
  const { sure, guess } = work.state, mark = $("confidence"), byHand = sure === null, good = !byHand && sure >= SURE;
  mark.textContent = !fact ? "" : guess ? say("guess") : byHand ? say("byHand") : `${say(good ? "sureYes" : "sureNo")} ${Math.round(100 * sure)} %`;
  mark.className = !fact ? "" : (good || byHand) && !guess ? "sure" : "unsure";
}

let choosing = 0;
/* the other solids that the drawing may be of, once nothing changes for a moment */
export function chooseSoon() {
  clearTimeout(choosing);
  choosing = setTimeout(async () => {
    const { selected } = work, fact = work.answer.facts[selected], object = work.state.objects[selected];
    if (!fact || !object || fact.readings < 2) { readings.show([], 1); return; }
    try {
      const list = await server.readings(correctionsNow(), selected);
      if (work.state.objects[selected] === object) readings.show(list, object.reading);
    } catch { readings.show([], 1); }
  }, PAUSE);
}

export function showStages(list) {
  $("steps").hidden = !list.length;
  $("stages").replaceChildren(...list.map(one => {
    const item = document.createElement("li");
    item.append(
      Object.assign(document.createElement("img"), { src: one.picture, alt: "" }),
      Object.assign(document.createElement("h3"), { textContent: one.title }),
      Object.assign(document.createElement("p"), { textContent: one.sentence }));
    return item;
  }));
}

/* which buttons may be pressed */
export function buttons() {
  const { state, open } = work, some = state.objects.length > 0 && !state.guess;
  $("undo").disabled = !history.canUndo;
  $("redo").disabled = !history.canRedo;
  $("download").disabled = $("save").disabled = !some;
  $("share").disabled = $("share-too").disabled = !state.strokes.length;
  $("adjust").disabled = !state.objects.length;
  $("clear").disabled = !state.strokes.length;
  $("refresh").hidden = state.sure !== null || !some || open.kind !== "picture";
}
work.changed = buttons;

/* the fields of the object that is spoken of */
export function settings() {
  const { state, answer } = work, selected = work.selected = Math.max(0, Math.min(work.selected, state.objects.length - 1));
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
