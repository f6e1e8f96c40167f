/* Everything the page asks of its server. Each call gives data or throws an Error whose message is fit to be shown. */
import { say } from "./words.js";

async function ask(address, options) {
  let response;
  try {
    response = await fetch(address, options);
  } catch {
    throw new Error(say("noAnswer"));
  }
  if (response.ok) return response;
  let said = {};
  try { said = await response.json(); } catch { /* an answer in no form of ours */ }
  const words = said.error || say("answered", { status: response.status });
  throw new Error(`${words[0].toUpperCase()}${words.slice(1)}. ${said.advice ? say("tryThis", said) : ""}`.trim());
}

function post(address, data, signal) {
  return ask(address, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(data), signal });
}

export async function reconstruct(blob, name, page = 0) {
  const headers = {
    "Content-Type": blob.type.startsWith("image/") ? blob.type : "application/octet-stream", "X-Name": encodeURIComponent(name), "X-Page": String(page),
  };
  return (await ask("/api/reconstruct", { method: "POST", headers, body: blob })).json();
}

/* signal: aborts what nobody waits for any more */
export async function sketch(strokes, signal) { return (await post("/api/sketch", { strokes }, signal)).json(); }

export async function lift(corrections) { return (await post("/api/lift", corrections)).json(); }

export async function readings(corrections, object) { return (await (await post("/api/readings", { corrections, object })).json()).readings; }

export async function connect(front, back) { return (await post("/api/connect", { front, back })).json(); }

export async function base64(blob) {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = "";
  for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
  return btoa(text);
}

export async function stages(blob, corrections) {
  return (await post("/api/stages", { picture: await base64(blob), corrections })).json();
}

export async function file(format, corrections, blob) {
  const picture = blob ? { picture: await base64(blob) } : {};
  return (await post(`/api/export/${format}`, { ...corrections, ...picture })).blob();
}

export async function about() { return (await ask("/about")).json(); }

export async function example(name) { return (await ask(`/examples/${name}.png`)).blob(); }

export async function waiting() { return (await (await ask("/queue")).json()).waiting; }
