/* A folder of pictures as a filmstrip: all are looked at, one after the other; what needs a look comes first. */
import { say } from "./words.js";

const PICTURE = /\.(png|jpe?g|webp|bmp|gif|tiff?|svg|heic|heif|pdf)$/i;
/* confidence from which an answer need not be looked at */
const SURE = 0.9;

export class Strip {
  /* list: the element; find(file) gives an answer; open(file, found) shows one */
  constructor(list, find, open) { Object.assign(this, { list, find, open, frames: [], turn: 0 }); }

  close() { this.turn++; this.frames = []; this.list.hidden = true; this.list.replaceChildren(); }

  /* false if there is no picture among the files */
  async show(files) {
    const turn = ++this.turn;
    this.frames = [...files].filter(f => PICTURE.test(f.name)).map(file => ({ file, address: URL.createObjectURL(file), state: "wait", sure: 2 }));
    this.list.hidden = !this.frames.length;
    this.paint();
    if (!this.frames.length) return false;
    this.look(this.frames[0]);
    for (const frame of [...this.frames]) {
      try {
        frame.found = await this.find(frame.file);
        frame.sure = frame.found.problem ? 0 : Math.min(1, ...frame.found.objects.map(o => o.confidence));
      } catch (error) {
        Object.assign(frame, { sure: 0, error });
      }
      if (turn !== this.turn) return true;
      frame.state = frame.sure >= SURE ? "good" : "look";
      this.frames.sort((a, b) => a.sure - b.sure);
      this.paint();
      if (frame === this.current) this.open(frame.file, frame.found, frame.error);
    }
    return true;
  }

  look(frame) { this.current = frame; this.paint(); if (frame.state !== "wait") this.open(frame.file, frame.found, frame.error); }

  paint() {
    this.list.replaceChildren(...this.frames.map(frame => {
      const item = document.createElement("li"), button = document.createElement("button");
      const words = { wait: "stripWait", good: "stripGood", look: "stripBad" }[frame.state];
      button.type = "button";
      button.classList.toggle("look", frame.state === "look");
      button.setAttribute("aria-current", frame === this.current);
      button.append(Object.assign(document.createElement("img"), { src: frame.address, alt: "" }), `${frame.file.name}: ${say(words)}`);
      button.addEventListener("click", () => this.look(frame));
      item.append(button);
      return item;
    }));
  }
}
