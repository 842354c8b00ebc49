// What a reader has written: kept in the browser, and packed into a link that can be sent.
import { bytesOf } from './base64.js';

const keyOf = name => `code ${name}`;

export function keep(name, text) {
  try {
    if (text === null) localStorage.removeItem(keyOf(name));
    else localStorage.setItem(keyOf(name), text);
  } catch {
    // Where nothing can be kept, it lasts as long as the page.
  }
}

export function kept(name) {
  try {
    return localStorage.getItem(keyOf(name));
  } catch {
    return null;
  }
}

const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

/** A text as letters, digits, - and _ alone. */
export async function packed(text) {
  const bytes = new Uint8Array(await through(text, new CompressionStream('deflate')));
  return btoa(String.fromCharCode(...bytes))
    .replace(/\+/g, '-')
    .replace(/\//g, '_')
    .replace(/=+$/, '');
}

/** The text that packed() was given; null if there never was one. */
export async function unpacked(letters) {
  try {
    const bytes = bytesOf(letters.replace(/-/g, '+').replace(/_/g, '/'));
    return new TextDecoder('utf-8', { fatal: true }).decode(await through(bytes, new DecompressionStream('deflate')));
  } catch {
    return null;
  }
}
