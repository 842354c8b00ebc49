// A class of an exercise's own right and wrong answers, by the real grader in two parts, as two machines would:
//   node real.test.mjs GRADE ANSWERS...   each a folder of headers that answer 2-euler/orbit-drift
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, join } from 'node:path';
import { after, test } from 'node:test';

const [grade, ...answers] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'class-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const at = (...names) => join(folder, ...names);

const hostile = "$(touch forged) 'n\newline";
mkdirSync(at('submissions', hostile, '2-euler/orbit-drift.h'), { recursive: true });
const students = answers.flatMap(from =>
  readdirSync(from)
    .filter(name => name.endsWith('.h'))
    .map(name => join(from, name)),
);
for (const file of students) {
  const student = at('submissions', basename(file, '.h'), '2-euler');
  mkdirSync(student, { recursive: true });
  copyFileSync(file, join(student, 'orbit-drift.h'));
}
writeFileSync(at('seed'), '20');

const run = more =>
  spawnSync(
    grade,
    ['--class', at('submissions'), '--out', at('results'), '--jobs', '2', '--seed-file', at('seed'), ...more],
    { encoding: 'utf8', cwd: folder },
  );
const verdict = student =>
  JSON.parse(readFileSync(at('results', student, '2-euler/orbit-drift/report.json'), 'utf8')).verdict;

test('two parts grade a class, and the same command without a part makes the tables', () => {
  for (const part of ['1/2', '2/2']) assert.equal(run(['--shard', part]).status, 0);
  assert.ok(!existsSync(at('results/grades.csv')));
  assert.match(run([]).stdout, new RegExp(`^${students.length + 1} submissions graded before and skipped\n`));
  assert.ok(existsSync(at('results/grades.csv')));
  for (const file of students) {
    const right = basename(join(file, '..')) === 'right';
    assert.equal(verdict(basename(file, '.h')) === 'ACCEPTED', right, file);
  }
  assert.equal(verdict(hostile), 'REJECTED');
  assert.ok(!existsSync(at('forged')));
});

const own = main => `#pragma once
#include "given.h"
#include <cstdio>
inline double twice(double x) { return 2 * x; }
#ifndef GRADING
${main}
#endif
`;

// Some virtual machines take seconds for a gigabyte that is written to for the first time.
function memoryIsSlow() {
  const began = process.cpuUsage();
  Buffer.alloc(2 ** 29, 1);
  const { user, system } = process.cpuUsage(began);
  return user + system > 1e6;
}

test("a main of one's own is run, its prints are shown, and so is what it must not do", t => {
  const ran = main => {
    writeFileSync(at('own.h'), main ? own(main) : '#pragma once\n');
    return spawnSync(grade, ['--run', at('own.h')], { encoding: 'utf8' });
  };
  const good = ran(
    'int main() { std::printf("%g\\n", twice(21)); std::fputs("==2==WARNING: of the checker\\nmine", stderr); }',
  );
  assert.deepEqual([good.status, good.stdout, good.stderr], [0, '42\n', 'mine']);
  const beyond = ran('int main() { std::puts("here"); std::vector<int> a(2); return a.data()[2]; }');
  assert.deepEqual([beyond.status, beyond.stdout], [1, 'here\n']);
  assert.match(beyond.stderr, /reads outside of the memory that it has, in line 6/);
  const index = ran('int main() { std::vector<int> a(2); return a[2]; }');
  assert.match(index.stderr, /uses an index that is past the end of its vector, array or string, in line 6/);
  assert.match(
    ran('int main() { return std::vector<int>(2).at(2); }').stderr,
    /throws std::out_of_range .*, in line 6/,
  );
  assert.match(ran('int main() { return 3; }').stderr, /^grade: it ended with exit code 3\n$/);
  assert.match(ran('int main() { return x; }').stderr, /own.h:6:21: error: 'x' was not declared/);
  const grows = ran(
    'int main() { std::vector<std::vector<char>> all; for (std::fputs("mine\\n", stderr);;) all.emplace_back(100000000, 1); }',
  );
  const stopped = {
    memory: /^mine\ngrade: it was stopped when it held two gigabytes of memory. Does something grow without end\?\n$/,
    time: /^mine\ngrade: it was stopped after \d+ s. Is there a loop that never ends\?\n$/,
  };
  const by = Object.keys(stopped).find(limit => stopped[limit].test(grows.stderr));
  const slow = memoryIsSlow();
  if (slow) t.diagnostic(`new memory is slow here: what grows was stopped by its ${by}`);
  assert.ok(by === 'memory' || (by === 'time' && slow), grows.stderr);
  const huge = ran('int main() { return std::vector<int>(1ul << 45)[0]; }');
  assert.match(huge.stderr, /asks for more memory than there can be, in line 6/);
  assert.match(ran('').stderr, /there is no main\(\) in it/);
  assert.equal(spawnSync(grade, ['--run', at('nothing.h')]).status, 3);
});
