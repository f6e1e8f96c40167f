/* Undo and redo: whole states kept as text, so that nothing can be shared between them. */
const MOST = 300;

export class History {
  constructor(state) { this.reset(state); }

  reset(state) { this.past = []; this.future = []; this.present = JSON.stringify(state); }

  /* remember a new state; the same state twice is one */
  push(state) {
    const text = JSON.stringify(state);
    if (text === this.present) return;
    this.past.push(this.present);
    if (this.past.length > MOST) this.past.shift();
    this.present = text;
    this.future = [];
  }

  /* the present state told more exactly: no step of its own */
  amend(state) { this.present = JSON.stringify(state); }

  get canUndo() { return this.past.length > 0; }

  get canRedo() { return this.future.length > 0; }

  undo() { return this.step(this.past, this.future); }

  redo() { return this.step(this.future, this.past); }

  step(from, to) {
    if (!from.length) return null;
    to.push(this.present);
    this.present = from.pop();
    return JSON.parse(this.present);
  }
}
