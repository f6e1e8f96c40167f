/* What was found is changed: corners, wishes, sizes; and the solid follows. */
import * as server from "./server.js";
import * as shape from "./shape.js";
import { correctionsNow, editor } from "./sheets.js";
import { buttons, chooseSoon, hint, readings, settings, showAnswer, stage, tell } from "./showing.js";
import { given, lengthOf } from "./sizes.js";
import { NO_SOLID, step, work } from "./work.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);

/* one request at a time, the latest state last; moving: a vertex is being dragged */
let lifting = false, again = false, moving = false;

/* the solid is told again of the objects as they are now */
export async function lifted() {
  const { state } = work;
  buttons();
  if (!state.objects.length) { showAnswer(NO_SOLID); joinLoose(); return; }
  if (!moving && state.loose.length && state.loose.every(v => v.face)) joinLoose();
  if (lifting) { again = true; return; }
  lifting = true;
  try {
    do {
      again = false;
      const still = !moving, found = await server.lift(correctionsNow(still ? [] : work.families));
      if (still) work.families = found.facts.map(f => f.projection);
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
  const { loose } = work.state, none = loose.filter(v => !v.face).length;
  const [front, back] = [1, 2].map(face => loose.filter(v => v.face === face).map(v => [v.x, v.y]));
  if (!front.length && !back.length) return;
  if (none) { tell(say("loose", { front: front.length, back: back.length, none })); return; }
  if (front.length !== back.length || front.length < 3) { tell(say("looseUneven", { front: front.length, back: back.length })); return; }
  try {
    const { f1, f2 } = await server.connect(front, back), next = shape.withObject(work.state, f1, f2);
    next.loose = [];
    change(next);
  } catch (error) {
    tell(error.message, true);
  }
}

/* objects as somebody put them right */
export function change(next) {
  step({ ...next, sure: null, guess: "" });
  editor.show(work.state);
  settings();
  lifted();
}

/* something is wished of the object that is spoken of; not `final` while it is being typed */
export function set(update, final = true) {
  const next = shape.copy(work.state);
  if (!next.objects[work.selected]) return;
  update(next.objects[work.selected]);
  work.state = next;
  if (final) step(next);
  editor.show(next);
  lifted();
}

/* a size was typed: false, and nothing else, if it is no length */
export function typed(name, text, final) {
  const object = work.state.objects[work.selected], size = object && lengthOf(text, object.unit), field = $(`size-${name}`);
  const bad = size === undefined;
  field.setAttribute("aria-invalid", bad);
  $(`error-${name}`).textContent = bad ? say("badNumber") : "";
  if (bad) return false;
  set(o => given(o, name, size), final);
  return true;
}

Object.assign(editor.on, {
  hint: words => { if (work.state.sheet === "editor") hint(words); },
  change: (next, done) => {
    moving = !done;
    editor.left = [];
    work.state = shape.byHand({ ...next, sure: null, guess: "" }, work.state);
    if (done) step(work.state);
    lifted();
  },
  choose: name => { if (name.object !== undefined && name.object !== work.selected) { work.selected = name.object; settings(); } },
});
Object.assign(stage.on, { size: (name, text) => typed(name, text, true), left: settings });
readings.on.take = number => set(o => { o.reading = number; });
