/* Something to work on comes from outside: pictures, folders, corrections, what was kept, what a link holds. */
import { change } from "./changing.js";
import { Strip } from "./folder.js";
import { unpacked } from "./keep.js";
import * as server from "./server.js";
import * as shape from "./shape.js";
import { editor, pad, pick, sheetOf } from "./sheets.js";
import { busy, chooseSoon, mayDrop, showAnswer, showStages, tell, view } from "./showing.js";
import { live, startSketch } from "./sketching.js";
import { EMPTY, opened, saveSoon, work } from "./work.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);

export const strip = new Strip($("strip"), file => server.reconstruct(file, file.name), (file, found, error) => {
  if (error) tell(error.message, true); else showPicture(found, file, file.name);
});

let loading = 0;
/* look at a picture, at one page of it, and show it */
export async function load(blob, name, page = 0) {
  if (!await mayDrop()) return;
  const why = unreadable(blob, name);
  if (why) { tell(why, true); return; }
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

/* why a file need not be sent at all, "" if it may be read */
function unreadable(blob, name) {
  const kind = (/\.(heic|heif|pdf|svgz?)$/i.exec(name)?.[1] || "").toLowerCase().replace("heif", "heic").replace("svgz", "svg"), { about } = work;
  if (about && kind && about.reads[kind] === false) return say("cannotRead", { kind: kind.toUpperCase() });
  if (about && blob.size > about.most) return say("tooLarge", { name, most: Math.floor(about.most / 2 ** 20) });
  return "";
}

function showPicture(found, blob, name, page = 0) {
  live.stop();
  const { width, height, picture, corners, pages, problem } = found, some = found.objects.length > 0;
  work.left = problem?.left || [];
  $("pages").replaceChildren(...Array.from({ length: pages }, (_, k) => new Option(say("pages", { n: k + 1, of: pages }), k, false, k === page)));
  const sure = some ? Math.min(...found.objects.map(o => o.confidence)) : null, guess = problem && some ? problem.error : "";
  opened({ kind: "picture", blob, name, width, height, picture, corners, page, pages }, { ...EMPTY, sheet: "editor", objects: shape.withWishes(found.objects, []), sure, guess });
  pad.show([]);
  editor.open(sheetOf(), work.state, corners);
  view();
  editor.fit();
  work.families = found.facts.map(f => f.projection);
  showAnswer(found, true);
  showStages(found.stages);
  saveSoon();
  pick(some ? "move" : "trace");
  if (guess) tell(say("guessed", { why: work.left.length ? say("leftOver") : guess }));
  else if (problem) tell(say("foundNot", { why: problem.error }), true);
  else tell(some && found.objects.length > 1 ? say("foundMany", { n: found.objects.length, name }) : say("found", { name }));
  chooseSoon();
}

/* a file from anywhere: a picture, or corrections for what is open */
export async function takeFile(file) {
  if (!/\.json$/i.test(file.name || "")) { await load(file, file.name || "photo.jpg"); return; }
  try {
    const text = await file.text(), data = JSON.parse(text), { open, state } = work;
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

export async function openFolder(files) {
  if (files.length && await mayDrop() && !await strip.show(files)) tell(say("noPictures"), true);
}

export async function openExample({ name, title }) {
  try { await load(await server.example(name), `${title.toLowerCase()}.png`); } catch (error) { tell(error.message, true); }
}

/* work that was kept in this browser */
export async function restore(kept) {
  if (!kept) return;
  if (kept.kind === "picture" && kept.blob) {
    await load(kept.blob, kept.name, kept.page);
    if (JSON.stringify(kept.state.objects) !== JSON.stringify(work.state.objects)) change({ ...work.state, objects: kept.state.objects, loose: kept.state.loose });
  } else if (kept.state?.strokes) startSketch(kept.state.strokes, kept.state.objects);
}

/* the drawing in the address; false if there is none */
export async function fromLink() {
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
