/* Everything the page asks of its server. Each call gives data or throws an Error whose message is fit to be shown. */
async function ask(address, options) {
  let response;
  try {
    response = await fetch(address, options);
  } catch {
    throw new Error("The program does not answer. Try: is it still running?");
  }
  if (response.ok) return response;
  let said = {};
  try { said = await response.json(); } catch { /* an answer in no form of ours */ }
  const words = said.error || `it answered ${response.status}`;
  throw new Error(words[0].toUpperCase() + words.slice(1) + (said.advice ? `. Try: ${said.advice}.` : "."));
}

function post(address, data) {
  return ask(address, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(data) });
}

export async function reconstruct(blob, name) {
  const headers = { "Content-Type": blob.type.startsWith("image/") ? blob.type : "application/octet-stream", "X-Name": encodeURIComponent(name) };
  return (await ask("/api/reconstruct", { method: "POST", headers, body: blob })).json();
}

export async function lift(corrections) { return (await post("/api/lift", corrections)).json(); }

export async function connect(front, back) { return (await post("/api/connect", { front, back })).json(); }

export async function stages(blob, corrections) {
  const bytes = new Uint8Array(await blob.arrayBuffer());
  let text = "";
  for (let k = 0; k < bytes.length; k += 32768) text += String.fromCharCode(...bytes.subarray(k, k + 32768));
  return (await post("/api/stages", { picture: btoa(text), corrections })).json();
}

export async function mesh(format, corrections) { return (await post(`/api/export/${format}`, corrections)).blob(); }

export async function examples() { return (await ask("/examples")).json(); }

export async function example(name) { return (await ask(`/examples/${name}.png`)).blob(); }
