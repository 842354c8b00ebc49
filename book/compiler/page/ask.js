// The compiler comes when it is asked for: a line says what comes and how far it is, and can be cancelled.
import { Cancelled, loadCompiler, stillToCome } from './compiler.js';

/** Shows the line in `place` while the compiler comes, with what it needs for a 'step' or a 'program'. @returns the compiler, or null if the reader cancelled */
export async function askForCompiler(place, forWhat) {
  const line = document.createElement('p');
  line.className = 'comes';
  line.setAttribute('role', 'status');
  const bar = document.createElement('progress');
  bar.setAttribute('aria-label', 'How much of the compiler is there');
  const cancel = document.createElement('button');
  cancel.type = 'button';
  cancel.textContent = 'Cancel';
  const size = `${stillToCome(forWhat)}\u202fMB`;
  line.append(`A C++ compiler comes, once: ${size}, a few seconds from disk. `, bar, ' ', cancel);
  place.append(line);
  const stop = new AbortController();
  cancel.addEventListener('click', () => stop.abort());
  try {
    return await loadCompiler(forWhat, share => (bar.value = share), stop.signal);
  } catch (fault) {
    if (fault instanceof Cancelled) return null;
    throw fault;
  } finally {
    line.remove();
  }
}
