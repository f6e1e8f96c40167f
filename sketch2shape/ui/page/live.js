/* The solid follows the strokes, the newest first. What they have begun is soon told and stands there until the search has come
   to its end. A stroke along an edge of the solid in view changes nothing to be seen:
   that solid stays, and the whole search, which tells how sure it is, waits until the pen rests. */
import { mayShow } from "./tidy.js";

/* ms: a wait worth a sign; a rest of the pen */
const SOON = 300, REST = 400;
/* ms from which a search took so long that a drawing on its way is not searched at every stroke: others wait too */
const SLOW = 1500;

const pause = ms => new Promise(done => setTimeout(done, ms));

export class Live {
  /* on: {ask(strokes, signal, first): gives what was found, early(strokes): gives what they have begun, which is soon told, or
     null, show(found, isNewest()), none(strokes): too few of them, failed(error), busy(is)} */
  constructor(on) { Object.assign(this, { on, turn: 0, pending: 0, took: 0, waits: [], fits: false }); }

  get busy() { return this.pending > 0; }

  /* is a solid awaited that is not there already? */
  searching() { return this.busy && !this.fits; }

  /* the strokes are these now; `fits`: the solid in view is one of them already. waits, ms, are for those who measure: until
     a solid of these strokes stood there */
  async follow(strokes, fits = false) {
    const begin = performance.now(), turn = ++this.turn, isNewest = () => turn === this.turn;
    this.flight?.abort();
    this.flight = null;
    this.fits = fits;
    if (!mayShow(strokes)) { this.on.none(strokes); return; }
    if (fits) this.waits.push(performance.now() - begin);
    this.pending++;
    let sign = 0;
    try {
      if (fits || this.took > SLOW) await pause(REST);
      if (!isNewest()) return;
      sign = setTimeout(() => { if (isNewest()) this.on.busy(true); }, SOON);
      const asked = performance.now(), flight = this.flight = new AbortController(), first = this.on.early(strokes);
      const found = this.on.ask(strokes, flight.signal, first), soon = await Promise.race([first.catch(() => null), found]);
      if (soon && isNewest()) { await this.on.show(soon, isNewest); this.stands(soon, begin, isNewest); }
      const whole = await found;
      this.took = performance.now() - asked;
      if (!isNewest() || whole === soon) return;
      await this.on.show(whole, isNewest);
      this.stands(whole, begin, isNewest);
    } catch (error) {
      if (isNewest()) this.on.failed(error);
    } finally {
      clearTimeout(sign);
      this.pending--;
      if (isNewest()) this.on.busy(false);
    }
  }

  /* there is a solid of the newest strokes */
  stands(found, begin, isNewest) {
    if (!isNewest() || this.fits || !found.objects.length) return;
    this.waits.push(performance.now() - begin);
    this.fits = true;
  }

  /* what is on its way is not wanted any more */
  stop() {
    this.turn++;
    this.flight?.abort();
    this.on.busy(false);
  }
}
