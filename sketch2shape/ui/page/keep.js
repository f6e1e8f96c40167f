/* Nothing is lost: the work is kept in the browser, and a drawing fits into a link. */
const NAME = "sketch2shape";
/* a link longer than this is cut off by some programs, characters */
const MOST_LINK = 16000;

/* keep what is open in this browser, one thing at a time; the picture as a blob in its own place */
function store(mode, does) {
  return new Promise((done, fail) => {
    const open = indexedDB.open(NAME, 1);
    open.onupgradeneeded = () => open.result.createObjectStore("work");
    open.onerror = () => fail(open.error);
    open.onsuccess = () => {
      const change = open.result.transaction("work", mode), asked = does(change.objectStore("work"));
      change.oncomplete = () => { open.result.close(); done(asked?.result); };
      change.onerror = () => { open.result.close(); fail(change.error); };
    };
  });
}

/* work: anything that can be cloned, blobs included. A browser that keeps nothing (private mode) is no reason to stop */
export async function keep(work) { try { await store("readwrite", s => s.put(work, "now")); } catch { /* not kept */ } }

export async function kept() { try { return await store("readonly", s => s.get("now")) || null; } catch { return null; } }

async function through(stream, bytes) {
  const answer = new Response(new Blob([bytes]).stream().pipeThrough(stream));
  return new Uint8Array(await answer.arrayBuffer());
}

/* the strokes and wishes as text for a link: numbers to a tenth, deflated, base64url; null if it is too long */
export async function packed(state) {
  const fine = p => p.slice(0, 2).map(c => Math.round(c * 10));
  const strokes = state.strokes.map(s => [s.dashed ? 1 : 0, ...s.points.flatMap(fine)]);
  const wishes = state.objects.map(({ projection, sizes, unit, reading }) => ({ projection, sizes, unit, reading }));
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(JSON.stringify([1, strokes, wishes])));
  const text = btoa(String.fromCharCode(...bytes)).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "");
  return text.length > MOST_LINK ? null : text;
}

/* the strokes and wishes that a link holds. Raises an Error if it holds no whole drawing */
export async function unpacked(text) {
  const raw = atob(text.replace(/-/g, "+").replace(/_/g, "/"));
  const bytes = await through(new DecompressionStream("deflate-raw"), Uint8Array.from(raw, c => c.charCodeAt(0)));
  const [version, lines, wishes] = JSON.parse(new TextDecoder().decode(bytes));
  const strokes = lines.map(([dashed, ...numbers]) => {
    if (numbers.length < 4 || numbers.length % 2 || !numbers.every(n => Number.isFinite(n) && Math.abs(n) < 1e7)) throw new Error("no stroke");
    return { dashed: dashed === 1, points: numbers.flatMap((n, k) => k % 2 ? [] : [[n / 10, numbers[k + 1] / 10]]) };
  });
  if (version !== 1 || strokes.length > 2000) throw new Error("no drawing");
  return { strokes, wishes: Array.isArray(wishes) ? wishes : [] };
}
