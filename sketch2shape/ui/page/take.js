/* Taking the solid away: formats, sizes for printing, corrections. */
import { lengthOf, shown } from "./sizes.js";
import { say } from "./words.js";

const $ = id => document.getElementById(id);
const GROUPS = { solid: "forPrint", program: "asProgram", plan: "asPlan", drawing: "asDrawing", picture: "asPicture", report: "asReport" };
/* first in the list: what most printers and programs take */
const FIRST = ["3mf", "stl", "step"];

export function offer(blob, name) {
  const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

export class Take {
  /* on: {file(format): gives the bytes, save(), stem(): the name without ending, fact(): the solid's facts or null,
     fit(name, text): give a size, said(words, bad)} */
  constructor(on) {
    this.on = on;
    this.formats = [];
    $("format").addEventListener("change", () => this.tell());
    $("save").addEventListener("click", () => on.save());
    $("take-it").addEventListener("click", () => this.go());
  }

  offers(formats) {
    this.formats = formats;
    const rank = f => (FIRST.indexOf(f.name) + 1 || 99);
    $("format").replaceChildren(...Object.entries(GROUPS).filter(([name]) => formats.some(f => f.group === name)).map(([name, words]) => {
      const group = Object.assign(document.createElement("optgroup"), { label: say(words) });
      group.append(...formats.filter(f => f.group === name).sort((a, b) => rank(a) - rank(b)).map(f => new Option(f.name.toUpperCase(), f.name)));
      return group;
    }));
    $("format").value = "stl";
  }

  open() {
    $("take-size").hidden = this.on.fact()?.unit !== "px";
    this.tell();
    $("take").showModal();
  }

  tell() {
    const format = this.formats.find(f => f.name === $("format").value);
    $("take-what").textContent = format ? `${format.what} (${format.ending})` : "";
  }

  /* a solid without a size gets one before it goes to a printer */
  async go() {
    const name = $("format").value, format = this.formats.find(f => f.name === name), fact = this.on.fact();
    if (fact?.unit === "px" && ["solid", "program", "plan"].includes(format.group)) {
      const length = lengthOf($("take-length").value, "mm"), largest = ["width", "height", "depth"][fact.size.indexOf(Math.max(...fact.size))];
      if (!length) { $("take-length").setAttribute("aria-invalid", "true"); $("take-length").focus(); return; }
      $("take-length").removeAttribute("aria-invalid");
      this.on.fit(largest, `${shown(length.value)} ${length.unit}`);
    }
    $("take").close();
    try {
      const file = `${this.on.stem()}${format.ending}`;
      offer(await this.on.file(name), file);
      this.on.said(say("downloaded", { name: file }));
    } catch (error) {
      this.on.said(error.message, true);
    }
  }
}
