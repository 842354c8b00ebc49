// The compiler's files, which come from the page in parts, as text. A page opened from disk may not fetch, and so its thread may not:
// this takes the place of `fetch` before the compiler's own loader looks for it.
import { bytesOf } from './base64.js';

const arriving = new Map(); // file -> { chunks, whole, done }

function arrivalOf(file) {
  if (!arriving.has(file)) {
    const arrival = { chunks: [] };
    arrival.whole = new Promise(done => Object.assign(arrival, { done }));
    arriving.set(file, arrival);
  }
  return arriving.get(file);
}

const unpacked = async file =>
  new Blob(await arrivalOf(file).whole).stream().pipeThrough(new DecompressionStream('gzip'));

// What the compiler's own loader asks for, by the last part of its address.
self.fetch = async address => {
  const file = String(address).split('/').at(-1);
  const bytes = await unpacked(file);
  const type = file.endsWith('.wasm') ? 'application/wasm' : 'application/x-tar';
  arriving.delete(file);
  return new Response(bytes, { headers: { 'content-type': type } });
};

/** The bytes of a file that is none of the compiler's own; it is unpacked once. */
export function shipped(file) {
  const arrival = arrivalOf(file);
  arrival.bytes ??= unpacked(file).then(async stream => new Uint8Array(await new Response(stream).arrayBuffer()));
  return arrival.bytes;
}

export function addPart({ file, base64, last }) {
  const arrival = arrivalOf(file);
  arrival.chunks.push(bytesOf(base64));
  if (last) arrival.done(arrival.chunks);
}
