// No exercise can be had by pasting:   node paste.test.mjs write|others SOURCE GRADE EXERCISES...
// Those of the kind "write", or all others. A class, which has no function to paste into, is left out.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { bodies, pasted } from './paste.mjs';

const [which, source, grade, ...exercises] = process.argv.slice(2);

test('bodies of functions and lambdas are found, and what they return', () => {
  const text = 'double twice(double x) { if (x > 0) { return 2 * x; } return 0; } auto f = [&](int n) { g(n); };';
  assert.deepEqual(
    bodies(text).map(({ name, parameters }) => [name, parameters]),
    [
      ['twice', ['x']],
      [']', ['n']],
      ['return', null],
      ['return', null],
    ],
  );
});

const kind = exercise => readFileSync(join(source, 'exercises', exercise, 'task.md'), 'utf8').match(/^Kind: (\w+)/m)[1];
const isClass = exercise => /^class /m.test(readFileSync(join(source, 'exercises', exercise, 'starter.h'), 'utf8'));
const tried = exercises.filter(exercise => (kind(exercise) === 'write') === (which === 'write') && !isClass(exercise));
assert.ok(tried.length > 0);

for (const exercise of tried) {
  test(`${exercise} cannot be pasted`, () => {
    const found = pasted(exercise, { source, grade });
    assert.ok(found.length > 0);
    const say = found.map(
      ({ name, tried: count, from }) => `${name}: ${count} compile; ${from.join(' ') || 'none is right'}`,
    );
    console.log(say.join('\n'));
    assert.ok(
      found.some(({ from }) => from.length === 0),
      'each of its functions stands somewhere to be copied',
    );
  });
}
