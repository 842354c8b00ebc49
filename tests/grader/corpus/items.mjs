// The corpus: files whose first lines say what must come of them, and what is generated.
import {readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {generated} from './generated.mjs';

const here = fileURLToPath(new URL('.', import.meta.url));

// The corpus is about `step`. What else the exercise asks for stands in one line behind the first include, so that no line moves.
const notSolved = 'inline int steps_per_turn(double) { return 0; }';
const solved = solution => solution.match(/^inline int steps_per_turn.*?^}/ms)[0].replace(/\s+/g, ' ');
const withRest = (source, rest) => source.replace('#include "given.h"\n\n', `#include "given.h"\n${rest}\n`);

function fromFile(kind, file, solution) {
  const source = readFileSync(join(here, kind, file), 'utf8');
  const [, verdict] = source.match(/^\/\/ ([A-Z_|]+): \S/) ?? [];
  if (!verdict) throw new Error(`${kind}/${file}: the first line must be "// VERDICT: what it does"`);
  const [, says] = source.match(/^.*\n\/\/ says: (.*)/) ?? [];
  const whole = withRest(source, verdict.includes('ACCEPTED') ? solved(solution) : notSolved);
  const make = at => (writeFileSync(join(at, file), whole), join(at, file));
  return {name: `${kind}/${file.replace(/\.h$/, '')}`, verdict, says, source, make};
}

export function items(solution) {
  const files = ['broken', 'hostile'].flatMap(kind => readdirSync(join(here, kind)).map(file => fromFile(kind, file, solution)));
  return [...files, ...generated(solution)].sort((a, b) => (a.name < b.name ? -1 : 1));
}
