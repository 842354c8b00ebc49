// What a chapter sets in italics is a word that it introduces, and then the glossary has it; or it is said with emphasis.
//   node tests/book/terms.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { italics } from '../../book/weave/terms.mjs';

const source = process.argv[3] ?? '.';
const read = path => readFileSync(join(source, path), 'utf8');

// Said with emphasis, or the name of a game, of a button, of a symbol: no word that has to be looked up.
const EMPHASIS = [
  'the thing is here now; where is it one frame later?',
  'model no more than the scene needs',
  'model no more than a scene needs. a model that is simple enough has an exact step: take it.',
  ...['position', 'velocity', 'neither', 'fast', 'second', 'exact', 'eliminate', 'middle', 'is', 'new', 'large'],
  ...['shrinks', 'relative', 'gone', 'uneven steps.', 'a collision.', 'a force that switches.'],
  ...['hitman: codename 47', 'time it here', 'omega', 'zeta'],
];

const fences = /^```[\s\S]*?^```/gm;
const pages = readdirSync(join(source, 'chapters'))
  .filter(name => /^\d-/.test(name))
  .flatMap(name => readdirSync(join(source, 'chapters', name)).map(file => `chapters/${name}/${file}`))
  .filter(path => path.endsWith('.md'))
  .map(path => ({ number: 1, source: read(path).replace(fences, '') }));
const said = new Set(italics({ pages }));
const glossary = new Set(
  [...read('book/glossary.md').matchAll(/\\term\{([^}]+)\}/g)].map(([, term]) => term.toLowerCase()),
);

test('every word that a chapter introduces in italics is in the glossary', () => {
  assert.ok(said.size > 50, `${said.size} words in italics`);
  assert.deepEqual(
    [...said].filter(words => !glossary.has(words) && !EMPHASIS.includes(words)),
    [],
  );
});

test('what is said with emphasis is still said, and is no word of the glossary', () => {
  assert.deepEqual(
    EMPHASIS.filter(words => !said.has(words) || glossary.has(words)),
    [],
  );
});
