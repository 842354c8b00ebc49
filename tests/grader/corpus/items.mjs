// The corpus: files whose first lines say what must come of them, and what is generated.
import { copyFileSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { generated } from './generated.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));

function fromFile(kind, file) {
  const source = readFileSync(join(here, kind, file), 'utf8');
  const [, verdict] = source.match(/^\/\/ ([A-Z_|]+): \S/) ?? [];
  if (!verdict) throw new Error(`${kind}/${file}: the first line must be "// VERDICT: what it does"`);
  const [, says] = source.match(/^.*\n\/\/ says: (.*)/) ?? [];
  const [, never] = source.match(/^\/\/ never: (.*)/m) ?? [];
  const make = at => (copyFileSync(join(here, kind, file), join(at, file)), join(at, file));
  return { name: `${kind}/${file.replace(/\.h$/, '')}`, verdict, says, never, source, make };
}

export function items(solution) {
  const files = ['broken', 'hostile'].flatMap(kind => readdirSync(join(here, kind)).map(file => fromFile(kind, file)));
  return [...files, ...generated(solution)].sort((a, b) => (a.name < b.name ? -1 : 1));
}
