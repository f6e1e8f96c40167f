/* "Which did you mean?": the solids that a drawing may be of, each turning slowly; a tap takes one. */
import { measure } from "./sizes.js";
import { colours } from "./stage.js";
import { say } from "./words.js";

/* degrees a second */
const SPEED = 24;

export class Readings {
  /* box: the element with a list; on: {take(number): a reading was taken} */
  constructor(box, on) {
    Object.assign(this, { box, on, views: [], last: 0 });
    this.still = matchMedia("(prefers-reduced-motion: reduce)");
  }

  /* what there is to choose from: [{number, name, solid, size, unit}]; nothing is shown for one alone */
  show(list, chosen) {
    this.box.hidden = list.length < 2;
    this.views = [];
    this.box.querySelector("ul").replaceChildren(...(list.length < 2 ? [] : list).map(reading => {
      const item = document.createElement("li"), button = document.createElement("button"), canvas = document.createElement("canvas");
      const size = reading.size.map(c => measure(c, reading.unit).replace(` ${reading.unit}`, "")).join(" × ");
      button.type = "button";
      button.dataset.reading = reading.number;
      button.setAttribute("aria-pressed", reading.number === chosen);
      button.setAttribute("aria-label", say("whichOne", { n: reading.number, name: reading.name, size }));
      canvas.setAttribute("aria-hidden", "true");
      button.append(canvas, size);
      button.addEventListener("click", () => this.on.take(reading.number));
      item.append(button);
      this.views.push(new SolidView(canvas, reading.solid, { still: true, hidden: false, ground: false, colours: colours(document.body) }));
      return item;
    }));
    if (!this.running && !this.box.hidden) this.run();
  }

  run() {
    this.running = !this.still.matches && this.views.length > 0;
    if (!this.running) return;
    requestAnimationFrame(now => {
      const step = Math.min(100, now - this.last);
      this.last = now;
      if (!document.hidden) for (const view of this.views) view.turn(SPEED * step / 1000, 0);
      this.run();
    });
  }
}
