/* What is wrong with a drawing, in plain words at the place where it is. */
import { gap, middle, toSegment } from "./geometry.js";
import { looseEnds, undrawn } from "./tidy.js";
import { count, say } from "./words.js";

/* loose ends nearer than this were meant to meet, CSS pixels; strokes this near an edge draw it */
const NEAR = 45, ALONG = 14;
/* labels shown at once: more would hide the drawing */
const MOST_LABELS = 3;

export const NONE = { loose: [], missing: [], left: [], done: false };

/* what is wrong: {loose: [{point, other, held}], missing: [[a, b]], left: [[a, b]], done}; `left` are lines that the guess has no place for:
   none are told while an end waits for its line, as nobody has said that the drawing is done.
   Ends are told once there is enough to belong together; edges
   once something was found that has them and that is not a drawing without hidden lines; `done` tells that a whole solid was
   found: an end that is loose then waits for nothing */
export function faults(strokes, found, unit, left = [], done = false) {
  // before, an end near a corner may be on its way elsewhere
  const ends = strokes.length > 2 ? looseEnds(strokes, NEAR * unit) : [], loose = ends.map(l => l.held && !done ? { ...l, other: null, held: false } : l);
  const edges = found && found.lines !== "removed" ? edgesOf(found) : [];
  const waits = loose.some(l => !l.other);
  return { loose, missing: waits ? [] : undrawn(edges, strokes, ALONG * unit), left: waits ? [] : left, done };
}

/* the straight edges; a drawing has none where a line and an arc join smoothly, so of objects with arcs those between the
   faces are left out */
function edgesOf({ f1, f2, holes, arcs = [] }) {
  return [{ f1, f2 }, ...holes].flatMap((ring, r) => {
    const n = ring.f1.length, next = k => (k + 1) % n;
    const bent = k => arcs.some(arc => (arc.hole ?? -1) === r - 1 && arc.from === k);
    const around = f => f.length === n ? f.flatMap((p, k) => bent(k) ? [] : [[p, f[next(k)]]]) : [];
    if (arcs.length) return [...around(ring.f1), ...around(ring.f2)];
    const across = ring.f1.map((p, k) => [p, ring.f2[ring.f2.length === n ? k : 0]]);
    return [...around(ring.f1), ...around(ring.f2), ...across];
  }).filter(([a, b]) => a && b);
}

/* do these strokes draw edges of the object, each a different one, as a whole? */
export function areEdges(strokes, found, unit) {
  const near = ALONG * unit, free = edgesOf(found);
  return strokes.every(({ points }) => {
    const [p, q] = [points[0], points.at(-1)];
    const k = free.findIndex(([a, b]) => points.every(c => toSegment(c, a, b).gap < near) && [a, b].every(e => Math.min(gap(e, p), gap(e, q)) < near));
    if (k >= 0) free.splice(k, 1);
    return k >= 0;
  });
}

/* the faults counted, in one sentence; "" if there are none */
export function told({ loose, missing, left }) {
  const held = loose.filter(l => l.held).length, apart = loose.filter(l => l.other).length - held, ends = loose.length - apart - held;
  const pairs = held + Math.ceil(apart / 2);
  return [pairs && count("dontMeet", pairs), ends && count("loose", ends), missing.length && count("missing", missing.length), left.length && count("left", left.length)].filter(Boolean).join(", ");
}

/* labels beside the faults: `place` takes the sheet to the screen, `join` brings ends together */
export function label(box, marks, place, join) {
  const seen = [];
  for (const { point, other } of marks.loose) {
    // while one draws, an end that is merely loose may be waiting for its line: its ring is enough
    if (other ? seen.some(s => s.key === String(other)) : !marks.done) continue;
    seen.push(other ? { key: String(point), at: middle(point, other), words: say("dontMeet") } : { at: point, words: say("looseEnd") });
  }
  for (const [a, b] of marks.missing) seen.push({ at: middle(a, b), words: say("missingEdge") });
  const labels = seen.slice(0, MOST_LABELS).map(({ at, words }) => {
    const [x, y] = place(at), e = Object.assign(document.createElement("span"), { textContent: words });
    Object.assign(e.style, { left: `${x}px`, top: `${y}px` });
    return e;
  });
  if (marks.loose.some(l => l.other)) {
    const button = Object.assign(document.createElement("button"), { type: "button", id: "join", textContent: say("joinThem") });
    button.addEventListener("click", join);
    labels.push(button);
  }
  box.replaceChildren(...labels);
  for (const e of labels.filter(e => e.tagName === "SPAN")) {  // all of its words are in view
    const half = e.offsetWidth / 2, x = parseFloat(e.style.left);
    e.style.left = `${Math.max(half + 4, Math.min(box.clientWidth - half - 4, x))}px`;
  }
}
