// A time is recorded under the name of a method that there is: else tables say "not recorded", and nobody knows why.
//   node recorded.test.mjs TIMES REGISTER
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { readRecords } from '../../book/weave/csv.mjs';

const [times, register] = process.argv.slice(2);
const functions = new Set(readRecords(register).map(method => method.function));

// Of one step: THING/BODIES/FUNCTION, or card/FUNCTION.
const ofSteps = names => names.filter(name => /^card\/|^[^/]+\/\d+\/[a-z]/.test(name));
const gone = names => ofSteps(names).filter(name => !functions.has(name.split('/').at(-1)));

const names = readFileSync(times, 'utf8')
  .split('\n')
  .filter(line => line && !line.startsWith('#'))
  .map(line => line.split(',')[0]);

test('each recorded time of a step is that of a method of the book', () => {
  assert.ok(ofSteps(names).length > 100, `${ofSteps(names).length} times of steps found`);
  assert.deepEqual(gone(names), []);
});

test('a time under a name that is gone is found', () => {
  assert.deepEqual(gone(['leaf/64/eulr', 'leaf/64/euler', 'particles/4096', 'card/hoin']), [
    'leaf/64/eulr',
    'card/hoin',
  ]);
});
