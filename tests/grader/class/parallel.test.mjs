// A class graded by GNU parallel:   node parallel.test.mjs GRADE EXERCISES
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {realClass, skip} from './real.mjs';

const [grade, exercises] = process.argv.slice(2);
if (spawnSync('parallel', ['--version']).error) skip('GNU parallel is not installed; ./setup.sh brings it');
const room = realClass(exercises);
mkdirSync(join(room.submissions, "$(touch forged) 'n\newline"));

test('GNU parallel grades each submission, and the grader then only makes the tables', () => {
  const script = join(exercises, 'grader/class/parallel.sh');
  const seed = ['--seed-file', join(room.folder, 'seed')];
  writeFileSync(seed[1], '20');
  const run = spawnSync(script, [grade, room.name, room.submissions, room.results, ...seed],
      {encoding: 'utf8', cwd: room.folder, env: {...process.env, PARALLEL: '--jobs 2'}});
  assert.equal(run.status, 0, run.stderr);
  for (const student of room.right) assert.equal(room.report(student).verdict, 'ACCEPTED');
  assert.equal(room.report("$(touch forged) 'n\newline").verdict, 'REJECTED');
  assert.ok(!existsSync(join(room.folder, 'forged')));
  const {status, stdout} = spawnSync(grade, ['--class', room.submissions, '--out', room.results, ...seed], {encoding: 'utf8'});
  assert.equal(status, 0);
  assert.match(stdout, new RegExp(`^${room.students.length + 1} submissions graded before and skipped\n`));
});
