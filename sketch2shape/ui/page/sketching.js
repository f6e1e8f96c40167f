/* A drawing on the pad: what its strokes are of so far, and what is wrong with it. */
import { begun } from "./begun.js";
import { lifted } from "./changing.js";
import { Live } from "./live.js";
import { areEdges, faults, label, told, NONE } from "./marks.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { correctionsNow, pad } from "./sheets.js";
import { busy, chooseSoon, hint, showAnswer, showStages, tell, view } from "./showing.js";
import { BLANK, EMPTY, NAMES, NO_SOLID, SURE, amend, drawing, opened, step, work } from "./work.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);

/* what the link of a drawing wishes of its objects, once they are found */
let wished = [];

/* a new sheet, or one with strokes on it */
export function startSketch(strokes = [], wishes = []) {
  live.stop();
  opened({ ...BLANK }, { ...EMPTY, sheet: "pad", strokes });
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

export const live = new Live({
  ask: found,
  early,
  show: showLive,
  none: nothingYet,
  failed: error => tell(error.message, true),
  busy: is => busy(is ? say("working") : ""),
});

/* the strokes were changed: those before are given where some were only added */
export function follow(before = null) {
  const { state: { strokes, objects, guess }, answer } = work;
  const fits = Boolean(before) && before.length < strokes.length && ["", say("begun")].includes(guess) && answer.facts.length === 1
    && before.every((s, k) => s === strokes[k]) && areEdges(strokes.slice(before.length), objects[0], pad.unit);
  review(fits ? objects[0] : null);
  live.follow(strokes, fits);
}

/* what the strokes are of; where that is no solid yet, what they have begun */
async function found(strokes, signal, first) {
  const answered = await server.sketch(strokes, signal);
  return answered.problem && (await first || await beginning(strokes)) || answered;
}

/* the same at once, where no sure solid is in view that would make place for a guess */
async function early(strokes) { return work.answer.facts.length && !work.state.guess ? null : beginning(strokes); }

async function beginning(strokes) {
  const start = begun(strokes, pad.unit);
  if (!start) return null;
  const { x, y, width, height } = pad.frame(), object = { ...shape.newObject(start.f1, start.f2), lines: start.lines };
  const solids = await server.lift(shape.corrections(shape.shifted({ ...EMPTY, objects: [object] }, -x, -y), width, height));
  return { ...solids, objects: [{ ...object, confidence: null }], problem: { error: say("begun"), left: [] } };
}

function nothingYet(strokes) {
  amend({ ...work.state, objects: [], guess: "", sure: null });
  showAnswer(NO_SOLID);
  if (strokes.length) tell(say("needMore"));
}

async function showLive(answered, isNewest) {
  if (!drawing()) return;
  const { state } = work, { problem } = answered;
  const before = state.objects.length ? state.objects : wished, ways = answered.facts.map(f => f.readings);
  const objects = shape.withWishes(answered.objects, before, ways), some = objects.length > 0;
  amend({ ...state, objects, guess: problem && some ? problem.error : "", sure: some ? Math.min(...answered.objects.map(o => o.confidence)) : null });
  work.left = problem?.left || [];
  const first = work.answer === NO_SOLID || !work.answer.facts.length;
  const wishes = objects.some(o => o.projection !== "auto" || o.reading > 1 || NAMES.some(n => o.sizes[n]));
  work.families = answered.facts.map(f => f.projection);
  const solids = wishes && some ? await server.lift(correctionsNow()) : answered;
  if (!isNewest()) return;
  showAnswer(solids, first);
  review(answered.objects[0]);
  const { guess } = work.state;
  if (guess) tell(guess === say("begun") ? guess : say("guessedLive"));
  else if (some) tell(say("foundLive", { what: answered.facts.map(f => f.shape).join(", ") }));
  else tell(say("needMore"));
  chooseSoon();
}

/* what is wrong with the drawing, marked on it */
export function review(object) {
  const { state } = work, sure = state.sure !== null && state.sure >= SURE && !state.guess;
  const marks = work.marks = faults(state.strokes, sure ? null : object, pad.unit, object && state.guess ? work.left : [], Boolean(object) && state.guess !== say("begun"));
  pad.mark(marks);
  pad.over(object ? { sure, front: state.objects.flatMap(o => shape.rings(o).map((_, r) => shape.outline(o, r, 1))) } : null);
  if (drawing()) hint(told(marks) || (object && sure ? say("hintDone") : say("hintPad")));
}

/* undo and redo have brought other strokes */
export function travelled() {
  const { objects } = work.state;
  review(objects[0] || null);
  if (objects.length) lifted(); else follow();
}

Object.assign(pad.on, {
  change: strokes => { const before = work.state.strokes; step({ ...work.state, strokes }); follow(before); },
  say: hint,
  paint: () => label($("marks"), drawing() ? work.marks : NONE, p => pad.onScreen(p), () => pad.join()),
});
