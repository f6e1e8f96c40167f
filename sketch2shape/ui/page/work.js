/* The work: what is open, what was found of it, what was changed, and the way back. Nothing here is to be seen. */
import { History } from "./history.js";
import { keep } from "./keep.js";
import { NONE } from "./marks.js";

/* the sizes of a solid, in the order in which they are told */
export const NAMES = ["width", "height", "depth"];
/* confidence from which an answer is called sure */
export const SURE = 0.9;
/* ms: a pause before choices are shown and work is kept */
export const PAUSE = 350;

/* all that undo travels through: the sheet in view, strokes, objects, loose vertices; why the objects are only a guess ("" if
   they are not) and how sure they are (null once changed by hand) */
export const EMPTY = { sheet: "welcome", strokes: [], objects: [], loose: [], guess: "", sure: null };
export const BLANK = { kind: "sketch", blob: null, name: "", width: 0, height: 0, picture: "", corners: [], page: 0, pages: 1 };
export const NO_SOLID = { solid: { vertices: [], triangles: [], edges: [] }, facts: [] };

/* state: as EMPTY; open: what it belongs to, as BLANK; answer: the solids and their facts; selected: which of the objects is
   spoken of; families: how each is drawn; marks: faults of the drawing; left: lines that fit nothing; about: what the program
   offers; changed(): called after each step */
export const work = { state: EMPTY, open: BLANK, answer: NO_SOLID, selected: 0, families: [], marks: NONE, left: [], about: null, changed: () => {} };

export const history = new History(EMPTY);

export const drawing = () => work.state.sheet === "pad";

/* is there work that another drawing would drop? */
export const dirty = () => work.state.strokes.length > 0 || (work.open.kind === "picture" && history.canUndo);

/* a new state that undo comes back from */
export function step(next) {
  work.state = next;
  history.push(next);
  saveSoon();
  work.changed();
}

/* the present state told more exactly */
export function amend(next) {
  work.state = next;
  history.amend(next);
  saveSoon();
  work.changed();
}

/* something else is open: nothing to go back to */
export function opened(open, state) {
  Object.assign(work, { open, state, selected: 0 });
  history.reset(state);
}

let saving = 0;
export function saveSoon() {
  clearTimeout(saving);
  const { kind, blob, name, page } = work.open;
  saving = setTimeout(() => { if (work.state.sheet !== "welcome") keep({ state: work.state, kind, blob, name, page }); }, PAUSE);
}
