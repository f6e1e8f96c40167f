/* The page begins: its words, its first screen, what was kept. */
import { kept } from "./keep.js";
import { fromLink, openExample, restore } from "./opening.js";
import * as server from "./server.js";
import { pad } from "./sheets.js";
import { settings, stage, tell, view } from "./showing.js";
import { live, startSketch } from "./sketching.js";
import { colours } from "./stage.js";
import { take } from "./wiring.js";
import { work } from "./work.js";
import { fill, say } from "./words.js";

const $ = id => document.getElementById(id);
/* degrees that the solid of the first screen turns in a millisecond */
const TURN = 0.014;

/* for those who measure: ms from the end of a stroke to its solid, and what the page knows */
window.timings = {
  live: () => live, busy: () => live.busy, state: () => work.state, facts: () => work.answer.facts, solid: () => stage.view, zoom: () => pad.view.s,
  reads: kinds => { work.about.reads = kinds; }, fresh: () => startSketch(),
};

function hero() {
  const f = [[0, 0], [0, 120], [120, 120], [120, 70], [50, 70], [50, 0]], n = f.length;
  const vertices = [...f.map(([x, y]) => [x, y, 0]), ...f.map(([x, y]) => [x, y, 90])];
  const caps = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4]].flatMap(t => [[t[0], t[2], t[1]], t.map(k => k + n)]);
  const sides = f.flatMap((_, k) => { const j = (k + 1) % n; return [[k, j, j + n], [k, j + n, k + n]]; });
  const edges = f.flatMap((_, k) => [[k, (k + 1) % n], [k + n, (k + 1) % n + n], [k, k + n]]);
  const show = new SolidView($("hero-solid"), { vertices, triangles: [...caps, ...sides], edges, view: [28, 22] }, { still: true, hidden: false, colours: colours(document.body) });
  if (matchMedia("(prefers-reduced-motion: reduce)").matches) return;
  let before = performance.now();
  const turn = now => {
    if (work.state.sheet === "welcome" && !document.hidden) show.turn((now - before) * TURN, 0);
    before = now;
    requestAnimationFrame(turn);
  };
  requestAnimationFrame(turn);
}

function gallery(examples) {
  $("gallery").append(...examples.map(e => {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.append(Object.assign(document.createElement("img"), { src: `/examples/${e.name}.png`, alt: "", loading: "lazy" }), e.title);
    button.addEventListener("click", () => openExample(e));
    item.append(button);
    return item;
  }));
}

async function begin() {
  fill(document);
  hero();
  settings();
  view();
  tell(say("welcome"));
  const before = await kept(), type = performance.getEntriesByType("navigation")[0]?.type;
  if (!await fromLink()) {
    if (before && (type === "reload" || type === "back_forward")) restore(before);
    else $("go-on").hidden = !before;
  }
  try {
    work.about = await server.about();
  } catch (error) {
    tell(error.message, true);
    return;
  }
  take.offers(work.about.formats);
  gallery(work.about.examples);
}

begin();
