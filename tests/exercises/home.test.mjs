// SPDX-License-Identifier: MIT-0
// What students call besides grading one file:   node home.test.mjs GRADE SOURCE
// The grader is a copy with a folder of its own, so that what is done there is this test's alone.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  realpathSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as pause } from 'node:timers/promises';

const [grade, source] = process.argv.slice(2);
const folder = mkdtempSync(join(tmpdir(), 'home-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const exercises = join(source, 'exercises');
const program = join(folder, 'program');
mkdirSync(join(program, 'grader'), { recursive: true });
for (const name of ['grade', 'grader/kit'])
  cpSync(join(dirname(grade), name), join(program, name), { recursive: true });
const installed = readFileSync(join(dirname(grade), 'installed.txt'), 'utf8');
writeFileSync(join(program, 'installed.txt'), installed.replace(/^exercises=.*$/m, `exercises=${exercises}`));

const work = name => (mkdirSync(join(folder, name), { recursive: true }), join(folder, name));
const env = { ...process.env, PATH: `${program}:${process.env.PATH}`, NO_COLOR: '1' };
const run = (cwd, ...words) => spawnSync('grade', words, { cwd, env, encoding: 'utf8', timeout: 60000 });
const solution = name => readFileSync(join(exercises, name, 'solution.h'), 'utf8');
const tasks = spawnSync(grade, ['list'], { encoding: 'utf8' })
  .stdout.trimEnd()
  .split('\n')
  .map(line => line.match(/\d-[a-z-]+\/[a-z-]+/)[0]);

test('a starter comes by its name alone, with what editors want to know, and never over an answer', () => {
  const here = work('start');
  const { status, stdout } = run(here, 'start', 'orbit-drift');
  assert.equal(status, 0);
  assert.match(
    stdout,
    /The drone that leaves, level 2, 20 min\nWrite a method from its two formulas[^]*\n {2}grade orbit-drift\.h\n/,
  );
  const starter = readFileSync(join(exercises, '2-euler/orbit-drift/starter.h'), 'utf8');
  assert.equal(readFileSync(join(here, 'orbit-drift.h'), 'utf8'), starter);
  const clean = spawnSync('g++', ['@compile_flags.txt', '-fsyntax-only', 'orbit-drift.h'], {
    cwd: here,
    encoding: 'utf8',
  });
  assert.equal(clean.status, 0, clean.stderr);
  const { configurations } = JSON.parse(readFileSync(join(here, '.vscode/c_cpp_properties.json'), 'utf8'));
  const [given] = configurations[0].includePath;
  assert.ok(existsSync(join(given.replace('${workspaceFolder}', here), 'given.h')), given);

  writeFileSync(join(here, 'orbit-drift.h'), '// mine\n');
  const again = run(here, 'start', '2-euler/orbit-drift.h');
  assert.equal(again.status, 2);
  assert.match(again.stderr, /^grade: 'orbit-drift\.h' is there already, and stays as it is[^\n]*\n$/);
  assert.equal(readFileSync(join(here, 'orbit-drift.h'), 'utf8'), '// mine\n');
  symlinkSync('nowhere', join(here, 'two-errors.h'));
  assert.equal(run(here, 'start', 'two-errors').status, 2);
  assert.equal(run(here, 'start', 'two-places', 'below/it').status, 0);
  assert.deepEqual(readdirSync(join(here, 'below/it')), ['two-places.h']); // editors know it from above
});

test('hints come one at a time, and after the last all of them; none has a formula that nobody can read', () => {
  const here = work('hints');
  for (const task of tasks) {
    const text = readFileSync(join(exercises, task, 'task.md'), 'utf8');
    const count = text.match(/^\\hint$/gm)?.length ?? 0;
    for (let n = 1; n <= count; ++n) {
      const { stdout } = run(here, 'hint', task);
      assert.match(stdout, new RegExp(`^${n} of ${count}  \\S`));
      assert.equal(stdout.includes('Another:'), n < count);
      assert.doesNotMatch(stdout, /[\\{}$]/);
    }
    assert.equal(run(here, 'hint', task).stdout.match(/^\d of \d {2}/gm).length, count);
  }
});

test('a header alone says which exercise it is for; full marks lead on, and open the other ways', () => {
  const here = work('alone');
  const before = run(here, 'ways', 'throw-to-runner');
  assert.equal(before.status, 2);
  assert.match(before.stderr, /^grade: [^\n]*no full marks here yet[^\n]*\n$/);
  writeFileSync(join(here, 'throw-to-runner.h'), solution('1-test-case/throw-to-runner'));
  const { status, stdout } = run(here, 'throw-to-runner.h');
  assert.equal(status, 0);
  assert.match(stdout, /^1-test-case\/throw-to-runner: ACCEPTED/);
  const next = tasks[tasks.indexOf('1-test-case/throw-to-runner') + 1].split('/')[1];
  assert.match(stdout, new RegExp(`^Next: grade start ${next}$`, 'm'));
  assert.match(stdout, /^See it move: grade play throw-to-runner\.h$/m);
  const right = readdirSync(join(exercises, '1-test-case/throw-to-runner/right'));
  const ways = run(here, 'ways', 'throw-to-runner').stdout;
  assert.deepEqual(
    [...ways.matchAll(/^== (.*)$/gm)].map(([, name]) => `${name}.h`),
    ['solution.h', ...right.sort()],
  );
  assert.match(run(here, 'list', 'throw').stdout, /^done /);
});

test('the sealed ways are those of the folder, and cannot be read as they are', () => {
  const here = work('sealed');
  const sealed = spawnSync('grade', ['seal', '1-test-case/throw-to-runner'], { cwd: here, env }).stdout;
  assert.ok(!sealed.toString('latin1').includes('inline'));
  const other = join(folder, 'elsewhere');
  mkdirSync(join(other, 'ways'), { recursive: true });
  cpSync(join(program, 'grade'), join(other, 'grade'));
  writeFileSync(join(other, 'installed.txt'), 'exercises=nothing\nkit=nothing\n');
  writeFileSync(join(other, 'done.txt'), '1-test-case/throw-to-runner\n');
  writeFileSync(join(other, 'ways/throw-to-runner.sealed'), sealed);
  const shown = spawnSync(join(other, 'grade'), ['ways', 'throw-to-runner'], { encoding: 'utf8' });
  assert.equal(shown.stdout, run(here, 'ways', 'throw-to-runner').stdout);
  assert.ok(shown.stdout.includes(solution('1-test-case/throw-to-runner')));
});

test("a main of one's own may print by streams, and the line that reads beyond an array is named", () => {
  const here = work('own');
  writeFileSync(
    join(here, 'mine.h'),
    '#include <iostream>\n#include <vector>\nint main() {\n  std::vector<int> a(2);\n  std::cout << 5 << std::endl << 1.5 << "\\n" << std::flush;\n  return a.data()[2];\n}\n',
  );
  const { status, stdout, stderr } = run(here, 'run', 'mine.h');
  assert.deepEqual([status, stdout], [1, '5\n1.5\n']);
  assert.match(stderr, /reads outside of the memory that it has, in line 6/);
});

test('the exercises of the level are listed, and a task has its place in the book', () => {
  const names = run(work('level'), 'list', 'level').stdout.match(/\d-[a-z-]+\/[a-z-]+/g);
  assert.equal(names.length, 6);
  assert.ok(names.every(name => tasks.includes(name)));
});

test('without a word and without a terminal it grades what was saved last', () => {
  const here = work('last');
  const none = run(here);
  assert.equal(none.status, 2);
  assert.match(
    none.stderr,
    /^grade: there is no answer here; begin by grade start \S+, or name an exercise and a file\n$/,
  );
  mkdirSync(join(here, '2-euler'));
  writeFileSync(join(here, '2-euler/orbit-drift.h'), '#pragma once\nnothing\n');
  assert.match(run(here).stdout, /^2-euler\/orbit-drift: COMPILE_ERROR/);
});

/** The grader on a terminal of its own; what it has shown, and a wait until it shows something. */
function onTerminal(cwd) {
  const child = spawn('script', ['-qfc', 'grade', '/dev/null'], { cwd, env, detached: true });
  const shown = { text: '' };
  child.stdout.on('data', data => (shown.text += data));
  shown.until = async (pattern, seconds = 30) => {
    for (const end = Date.now() + 1000 * seconds; !pattern.test(shown.text); await pause(50))
      assert.ok(Date.now() < end, `${pattern} is not in ${JSON.stringify(shown.text.slice(-2000))}`);
    shown.text = shown.text.slice(shown.text.search(pattern) + 1);
  };
  shown.end = () => process.kill(-child.pid, 'SIGKILL');
  return shown;
}

test('without a word it watches the folder: each save is graded, on a screen of its own, with a bar', async () => {
  const here = work('watch');
  const shown = onTerminal(here);
  try {
    await shown.until(/\[#\.{30}\] 1 of 31 exercises done/);
    await shown.until(/Begin with\r\n {2}grade start /);
    writeFileSync(join(here, 'orbit-drift.h'), readFileSync(join(exercises, '2-euler/orbit-drift/starter.h')));
    await shown.until(/\x1b\[2J[^]*2-euler\/orbit-drift: WRONG_ANSWER/);
    await shown.until(/A hint: grade hint orbit-drift/);
    writeFileSync(join(here, 'other.h'), 'no answer');
    writeFileSync(join(here, 'two-errors.h'), readFileSync(join(exercises, '1-test-case/two-errors/starter.h')));
    await shown.until(/1-test-case\/two-errors: WRONG_ANSWER[^]*No exercise is called like other\.h\./);
    writeFileSync(join(here, 'orbit-drift.h'), solution('2-euler/orbit-drift'));
    await shown.until(/\[##\.{29}\] 2 of 31 exercises done[^]*2-euler\/orbit-drift: ACCEPTED/);
    await shown.until(/Next: grade start camera-that-lags/);
  } finally {
    shown.end();
  }
});

test('with a compiler and nothing else it grades: no cage, and it says so; no pictures', () => {
  const here = work('bare');
  // As if they were not there: what lies in their place is no program.
  const nothing = join(here, 'nothing');
  writeFileSync(nothing, '');
  const hidden = ['/usr/bin/bwrap', '/usr/bin/gnuplot']
    .filter(existsSync)
    .flatMap(path => ['--bind', nothing, realpathSync(path)]);
  const bare = (...words) =>
    spawnSync('bwrap', ['--dev-bind', '/', '/', ...hidden, join(program, 'grade'), ...words], {
      cwd: here,
      env,
      encoding: 'utf8',
      timeout: 120000,
    });
  rmSync(join(program, 'grader/kit/compiler.txt'));
  rmSync(join(program, 'grader/kit/harness'), { recursive: true });
  const check = bare('check');
  assert.equal(check.status, 0, check.stdout + check.stderr);
  assert.match(check.stderr, /^Getting ready for \S*g\+\+\S*, once/);
  assert.match(check.stdout, /^compiler {4}ok .*\ncage {8}no .*bubblewrap is not installed/s);
  assert.match(check.stdout, /^memory {6}ok /m);
  assert.match(check.stdout, /^pictures {4}no .*gnuplot/m);
  writeFileSync(join(here, 'orbit-drift.h'), solution('2-euler/orbit-drift'));
  const own = bare('orbit-drift.h');
  assert.match(own.stdout, /^2-euler\/orbit-drift: ACCEPTED[^]*without\s+a\s+sandbox\./);
  assert.match(
    own.stderr,
    /^No cage here, so (your code runs like any program of yours|the code runs as a user who is nobody else): grade check says why\.\n$/,
  );
  // Others' code is never run so.
  assert.match(bare('2-euler/orbit-drift', 'orbit-drift.h').stdout, /GRADER_ERROR/);
});

test('where this user cannot write beside the program, it is kept in the state of the user', () => {
  if (process.getuid() === 0) {
    const as = spawnSync('setpriv', ['--reuid', '61101', '--regid', '61101', '--clear-groups', 'true']);
    if (as.status !== 0) return;
  }
  const here = work('shared');
  spawnSync('chmod', ['-R', 'a+rX', folder]);
  spawnSync('chmod', ['a-w', program]);
  spawnSync('chmod', ['777', here]);
  const words =
    process.getuid() === 0 ? ['setpriv', '--reuid', '61101', '--regid', '61101', '--clear-groups'] : ['env'];
  const { stdout, stderr } = spawnSync(words[0], [...words.slice(1), join(program, 'grade'), 'hint', 'orbit-drift'], {
    cwd: here,
    env: { PATH: process.env.PATH, HOME: here },
    encoding: 'utf8',
  });
  assert.match(stdout, /^1 of 2/, stderr);
  assert.equal(
    readFileSync(join(here, '.local/state/one-step-at-a-time/hints.txt'), 'utf8'),
    '2-euler/orbit-drift 1\n',
  );
});
