// The compiler's files, which come from the page in parts, as text. A page opened from disk may not fetch, and so its thread may not:
// this takes the place of `fetch` before the compiler's own loader looks for it.

const arriving = new Map(); // file -> { chunks, whole, done }

function arrivalOf(file) {
  if (!arriving.has(file)) {
    const arrival = { chunks: [] };
    arrival.whole = new Promise(done => Object.assign(arrival, { done }));
    arriving.set(file, arrival);
  }
  return arriving.get(file);
}

const bytesOf = base64 => Uint8Array.from(atob(base64), letter => letter.charCodeAt(0));

// What the compiler's own loader asks for, by the last part of its address.
self.fetch = async address => {
  const file = String(address).split('/').at(-1);
  const chunks = await arrivalOf(file).whole;
  const unpacked = new Blob(chunks).stream().pipeThrough(new DecompressionStream('gzip'));
  const type = file.endsWith('.wasm') ? 'application/wasm' : 'application/x-tar';
  arriving.delete(file);
  return new Response(unpacked, { headers: { 'content-type': type } });
};

export function addPart({ file, base64, last }) {
  const arrival = arrivalOf(file);
  arrival.chunks.push(bytesOf(base64));
  if (last) arrival.done(arrival.chunks);
}
