// No exercise of the kind "write" can be had by pasting:   node paste.test.mjs SOURCE GRADE EXERCISES...
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { bodies, pasted } from './paste.mjs';

const [source, grade, ...exercises] = process.argv.slice(2);

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
const written = exercises.filter(exercise => kind(exercise) === 'write');
assert.ok(written.length > 0);

for (const exercise of written) {
  test(`${exercise} has to be written`, () => {
    const found = pasted(exercise, { source, grade });
    assert.ok(found.length > 0);
    const say = found.map(({ name, tried, from }) => `${name}: ${tried} compile; ${from.join(' ') || 'none is right'}`);
    console.log(say.join('\n'));
    assert.ok(
      found.some(({ from }) => from.length === 0),
      'each of its functions stands somewhere to be copied',
    );
  });
}
