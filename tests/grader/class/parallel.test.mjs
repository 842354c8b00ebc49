// A class graded by GNU parallel:   node parallel.test.mjs GRADE EXERCISES
import assert from 'node:assert/strict';
import {spawnSync} from 'node:child_process';
import {mkdirSync} from 'node:fs';
import {join} from 'node:path';
import {test} from 'node:test';
import {realClass, skip} from './real.mjs';

const [grade, exercises] = process.argv.slice(2);
if (spawnSync('parallel', ['--version']).error) skip('GNU parallel is not installed; ./setup.sh brings it');
const room = realClass(exercises);
mkdirSync(join(room.submissions, "$(touch forged) 'n\newline"));

test('GNU parallel grades each submission, and the grader then only makes the tables', () => {
  const script = join(exercises, 'grade/class/parallel.sh');
  const run = spawnSync(script, [grade, room.name, room.submissions, room.results, '--jobs', '2'], {encoding: 'utf8', cwd: room.folder});
  assert.equal(run.status, 0, run.stderr);
  for (const student of room.right) assert.equal(room.report(student).verdict, 'ACCEPTED');
  assert.equal(room.report("$(touch forged) 'n\newline").verdict, 'REJECTED');
  const {status, stdout} = spawnSync(grade, ['--class', room.submissions, '--out', room.results], {encoding: 'utf8'});
  assert.equal(status, 0);
  assert.match(stdout, new RegExp(`^${room.students.length + 1} submissions graded before and skipped\n`));
});
