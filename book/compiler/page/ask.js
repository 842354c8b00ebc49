// The compiler comes when it is asked for: a line says what comes and how far it is, and can be cancelled.
import { Cancelled, loadCompiler } from './compiler.js';

/** Shows the line in `place` while the compiler comes. @returns the compiler, or null if the reader cancelled */
export async function askForCompiler(place) {
  const line = document.createElement('p');
  line.className = 'comes';
  line.setAttribute('role', 'status');
  const bar = document.createElement('progress');
  bar.setAttribute('aria-label', 'How much of the compiler is there');
  const cancel = document.createElement('button');
  cancel.type = 'button';
  cancel.textContent = 'Cancel';
  const { megabytes } = globalThis.Compiled ?? {};
  const size = megabytes ? `${megabytes}\u202fMB` : 'some 35\u202fMB';
  line.append(`A C++ compiler comes, once: ${size}, a few seconds from disk. `, bar, ' ', cancel);
  place.append(line);
  const stop = new AbortController();
  cancel.addEventListener('click', () => stop.abort());
  try {
    return await loadCompiler(share => (bar.value = share), stop.signal);
  } catch (fault) {
    if (fault instanceof Cancelled) return null;
    throw fault;
  } finally {
    line.remove();
  }
}
