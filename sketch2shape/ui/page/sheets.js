/* The two sheets: the pad that is drawn on and the editor of corners. What comes of what is done on them is told elsewhere
   (sketching.js, changing.js), which give them their `on`. */
import { Editor } from "./editor.js";
import { Pad } from "./pad.js";
import * as shape from "./shape.js";
import { work } from "./work.js";

const $ = id => document.getElementById(id);

export const pad = new Pad($("pad"), {});
export const editor = new Editor($("editor"), {});

/* what lies under the vertices */
export function sheetOf() {
  const { open, state, left } = work;
  if (open.kind === "sketch") return { ...pad.frame(), strokes: state.strokes };
  return { picture: open.picture, width: open.width, height: open.height, left: state.guess ? left : [] };
}

/* the corrections that say what is in view; a sketch has its frame for a picture */
export function correctionsNow(families = []) {
  const { open, state } = work;
  if (open.kind !== "sketch") return shape.corrections(state, open.width, open.height, families);
  const { x, y, width, height } = pad.frame();
  return shape.corrections(shape.shifted(state, -x, -y), width, height, families);
}

function choose(list, key, value) {
  for (const button of list) {
    const on = button.dataset[key] === value;
    button.setAttribute("aria-checked", on);
    button.tabIndex = on ? 0 : -1;
  }
}

export function pick(tool) { choose($("tools").children, "tool", tool); editor.setTool(tool); }

export function pickPad(tool) { choose($("pad-tools").children, "pad", tool); pad.setTool(tool); }
