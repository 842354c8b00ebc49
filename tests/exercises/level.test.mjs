// SPDX-License-Identifier: MIT-0
// The level, kept by a student's headers:   node level.test.mjs GRADE SOURCE
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';

const [grade, source] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'level-'));
after(() => rmSync(folder, { recursive: true, force: true }));

const parts = {
  '1-test-case/leftover-time': 'the clock',
  '2-euler/camera-that-lags': 'the camera',
  '4-implicit/slow-suspension': 'the spring',
  '5-verlet/rope-link': 'the rope',
  '6-symplectic/rewind-the-replay': 'the replay',
  '7-which-to-use/shuttle-on-a-budget': 'the shuttle',
};

/** Plays the level with these headers, by their exercises' names; what became of each part. */
function played(headers, ...words) {
  const here = mkdtempSync(join(folder, 'played-'));
  for (const [exercise, path] of Object.entries(headers)) copyFileSync(path, join(here, `${exercise.split('/')[1]}.h`));
  const { status, stdout, stderr } = spawnSync(grade, ['play', 'level', here, ...words], { encoding: 'utf8' });
  const outcomes = Object.fromEntries(
    [...stdout.matchAll(/^(kept|not|-) +(the \w+), .*\n {4}((?:.*\n {4})*.*)$/gm)].map(([, word, name, says]) => [
      name,
      { word, says: says.replace(/\s+/g, ' ') },
    ]),
  );
  return { status, stdout, stderr, outcomes };
}
const all = file =>
  Object.fromEntries(Object.keys(parts).map(exercise => [exercise, join(source, 'exercises', exercise, file)]));

test('an hour of the solutions is kept, in all six parts', () => {
  const { status, stdout, outcomes } = played(all('solution.h'), '--exit-status', 'verdict');
  assert.equal(status, 0, stdout);
  assert.deepEqual(Object.keys(outcomes), Object.values(parts));
  for (const [name, { word }] of Object.entries(outcomes)) assert.equal(word, 'kept', name);
  assert.match(stdout, /^6 of 6 are kept: ship it\. Open \S*level\.html in a browser\.$/m);
});

test('the starters keep nothing, and each is told why', () => {
  const { status, stdout, outcomes } = played(all('starter.h'), '--exit-status', 'verdict');
  assert.equal(status, 1);
  for (const [name, { word, says }] of Object.entries(outcomes)) {
    assert.equal(word, 'not', name);
    assert.match(says, /off at most|explodes|evaluations/, name);
  }
  assert.match(stdout, /^0 of 6 are kept\./m);
});

test('a level grows: what is not there yet is named, and costs nothing but itself', () => {
  const camera = '2-euler/camera-that-lags';
  const { status, stdout, outcomes } = played({ [camera]: join(source, 'exercises', camera, 'solution.h') });
  assert.equal(status, 0);
  assert.equal(outcomes['the camera'].word, 'kept');
  assert.equal(outcomes['the rope'].word, '-');
  assert.match(outcomes['the rope'].says, /grade start rope-link$/);
  assert.match(stdout, /^1 of 6 are kept\./m);
});

test('a mistake shows in the part that it is in, on the screen that shows it', () => {
  const rope = '5-verlet/rope-link';
  const clock = '1-test-case/leftover-time';
  const ways = {
    [clock]: join(source, 'exercises', clock, 'starter.h'),
    [rope]: join(source, 'exercises', rope, 'starter.h'),
  };
  const { outcomes } = played(ways);
  assert.match(outcomes['the clock'].says, /frames/);
  assert.equal(outcomes['the rope'].word, 'not');
});
