// The autograder for Gradescope, in a room like Gradescope's: /autograder, root, and a container's limits.
//   node gradescope.test.mjs GRADE LIKE_DOCKER SOURCE
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  copyFileSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after, test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv/dist/2020.js';

const [grade, likeDocker, source] = process.argv.slice(2);
if (process.getuid() !== 0) {
  console.log('not root: nobody here can become another user');
  process.exit(77);
}
const folder = mkdtempSync(join(tmpdir(), 'gradescope-'));
after(() => rmSync(folder, { recursive: true, force: true }));
const at = (...names) => join(folder, ...names);
const build = dirname(dirname(grade));
const make = join(source, 'exercises/hosts/gradescope/make.sh');
const exercise = '2-euler/orbit-drift';
const seed = '7777777777777777';
const schema = new URL('../report/gradescope.schema.json', import.meta.url);
const ajv = new Ajv({ allErrors: true, allowUnionTypes: true });
const isResults = ajv.compile(JSON.parse(readFileSync(fileURLToPath(schema), 'utf8')));

writeFileSync(at('seed'), `${seed}\n`, { mode: 0o600 });
const run = (command, words, more) => spawnSync(command, words, { encoding: 'utf8', cwd: folder, ...more });
const made = (...words) => run(make, ['--build', build, ...words]);

// The container: the system's folders, /autograder, and no way to new namespaces.
const room = at('autograder');
const inRoom = (words, user = []) =>
  run('bwrap', [
    ...['--ro-bind', '/usr', '/usr', '--ro-bind', '/etc', '/etc', '--proc', '/proc', '--dev', '/dev'],
    ...['bin', 'sbin', 'lib', 'lib64'].flatMap(name => ['--symlink', `usr/${name}`, `/${name}`]),
    ...['--perms', '1777', '--tmpfs', '/tmp', '--bind', room, '/autograder', '--ro-bind', likeDocker, '/like_docker'],
    ...['--ro-bind', at('bin'), '/fake', '--setenv', 'PATH', '/fake:/usr/bin:/usr/sbin'],
    ...['--cap-add', 'ALL', '--chdir', '/autograder', '--', '/like_docker', ...user, ...words],
  ]);

// Of what Gradescope does, what the autograder sees.
function submit(files) {
  for (const name of ['submission', 'results']) {
    rmSync(join(room, name), { recursive: true, force: true });
    mkdirSync(join(room, name));
  }
  for (const [name, text] of Object.entries(files)) writeFileSync(join(room, 'submission', name), text);
  writeFileSync(join(room, 'submission_metadata.json'), '{"users": [{"email": "ada@example.org"}]}');
  const ran = inRoom(['./run_autograder']);
  const path = join(room, 'results/results.json');
  return { ...ran, text: existsSync(path) ? readFileSync(path, 'utf8') : undefined };
}

function results(files) {
  const { status, stdout, stderr, text } = submit(files);
  assert.deepEqual([status, stdout, stderr], [0, '', '']);
  const all = JSON.parse(text);
  assert.ok(isResults(all), ajv.errorsText(isResults.errors));
  assert.ok(!text.includes(seed) && !/seed \d/i.test(text), text);
  return all;
}

const answer = name => readFileSync(join(source, 'exercises', exercise, name), 'utf8');
const wrong = readFileSync(join(build, 'exercises', exercise, 'wrong/symplectic.h'), 'utf8');
const answers = {
  right: answer('solution.h'),
  wrong,
  starter: answer('starter.h'),
  broken: answer('solution.h').replace(';', ''),
};

test('a zip is made of the grader, and refuses what is not there', () => {
  const zip = made('--exercise', exercise, '--seed-file', 'seed', '--out', at('a.zip'));
  assert.deepEqual([zip.status, zip.stderr], [0, '']);
  assert.equal(statSync(at('a.zip')).mode & 0o077, 0);
  const refusals = [
    [/name at least one --exercise/],
    [/there is no exercise '2-euler\/none'/, '--exercise', '2-euler/none'],
    [/there is no exercise '..\/grader'/, '--exercise', '../grader'],
    [/needs a value/, '--exercise'],
    [/knows --exercise/, '--fast', 'x'],
    [/must hold a whole number/, '--exercise', exercise, '--seed-file', make],
  ];
  for (const [says, ...words] of refusals) {
    const { status, stderr } = made(...words);
    assert.match(stderr, /^make.sh: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.equal(status, 2);
  }
  assert.match(made('--exercise', exercise, '--out', at('b.zip')).stdout, /^It grades with the public seed/);
});

test('it is set up by root, once', () => {
  mkdirSync(join(room, 'source'), { recursive: true });
  mkdirSync(at('bin'));
  writeFileSync(at('bin/apt-get'), '#!/bin/sh\necho "$@" >>/autograder/apt\n', { mode: 0o755 });
  assert.equal(run('cmake', ['-E', 'tar', 'xf', at('a.zip')], { cwd: join(room, 'source') }).status, 0);
  copyFileSync(join(room, 'source/run_autograder'), join(room, 'run_autograder'));
  chmodSync(join(room, 'run_autograder'), 0o755);
  const { status, stderr } = inRoom(['bash', '/autograder/source/setup.sh']);
  assert.equal(status, 0, stderr);
  assert.match(readFileSync(join(room, 'apt'), 'utf8'), /^update\ninstall -y --no-install-recommends g\+\+ /);
  const all = readdirSync(join(room, 'source'), { recursive: true });
  assert.ok(all.includes('build/exercises/grader/kit/harness/harness.o'));
  for (const name of all) assert.equal(statSync(join(room, 'source', name)).mode & 0o077, 0, name);
});

test('the points are those of a class with the same seed', () => {
  for (const [name, text] of Object.entries(answers)) {
    mkdirSync(at('class', name), { recursive: true });
    writeFileSync(at('class', name, 'orbit-drift.h'), text);
  }
  const words = ['--class', at('class'), '--out', at('marks'), '--seed-file', 'seed', '--jobs', '2'];
  assert.equal(run(grade, words).status, 0);
  for (const [name, text] of Object.entries(answers)) {
    const report = JSON.parse(readFileSync(at('marks', name, exercise, 'report.json'), 'utf8'));
    const all = results({ 'orbit-drift.h': text });
    assert.equal(all.score, report.score, name);
    const points = all.tests.slice(1).map(one => one.score);
    assert.deepEqual(
      points,
      report.tests.map(one => (one.ran && one.held ? one.points : 0)),
      name,
    );
  }
});

test('what is asked shows with the marks, and at once only whether it compiles', () => {
  const shown = all => all.tests.filter(one => one.visibility === 'visible');
  const right = results({ 'orbit-drift.h': answers.wrong });
  assert.deepEqual(
    shown(right).map(one => [one.status, one.output, one.score]),
    [['passed', 'It is there and compiles. Points come with the marks.', undefined]],
  );
  assert.ok(right.tests.slice(1).every(one => one.visibility === 'after_published'));
  const broken = results({ 'orbit-drift.h': answers.broken });
  assert.equal(shown(broken)[0].status, 'failed');
  assert.match(shown(broken)[0].output, /orbit-drift.h:\d+:\d+: error/);
  const other = results({ 'orbit-drift (1).h': answers.right });
  assert.equal(other.score, 0);
  assert.match(shown(other)[0].output, /is it orbit-drift \(1\).h\? Then name it orbit-drift.h/);
});

// Right, unless it can open one of these as it runs.
const opens = files =>
  answers.right
    .replace(
      'inline void step',
      `#include <cstdio>
inline bool seen() {
  for (const char* file : {${files.map(file => JSON.stringify(file)).join(', ')}})
    if (std::fopen(file, "r")) return true;
  return false;
}
inline void step`,
    )
    .replace('const Vec a =', 'if (seen()) return;\n  const Vec a =');
const right = 10;

const judges = [
  'source/seed.txt',
  `source/exercises/${exercise}/solution.h`,
  'source/build/exercises/grade',
  'source/run_autograder',
  'submission_metadata.json',
  'submission/orbit-drift.h',
  'results',
].map(name => `/autograder/${name}`);

test('what is graded can read nothing of the judge as it runs', () => {
  assert.equal(results({ 'orbit-drift.h': opens([...judges, '/proc/1/environ']) }).score, right);
  assert.ok(results({ 'orbit-drift.h': opens(['/etc/passwd']) }).score < right);
});

test('what is graded can read nothing of the judge as it is compiled', () => {
  const asks = file =>
    results({ 'orbit-drift.h': `#if __has_include("${file}")\n#error it is there\n#endif\n${answers.right}` }).tests[0];
  for (const file of judges.slice(0, 2)) assert.match(asks(file).output, /: Permission denied$/, file);
  assert.match(asks('/etc/passwd').output, /it is there/);
  for (const taken of [`#include "${judges[0]}"`, `__asm__(".incbin \\"${judges[0]}\\"");`]) {
    const all = results({ 'orbit-drift.h': `${answers.right}\n${taken}\n` });
    assert.equal(all.score, 0);
    assert.match(all.tests[0].output, /: Permission denied$|error: file not found: /m);
  }
});

test('it writes nothing where the marks are', () => {
  const forges = answers.right.replace(
    'const Vec a =',
    'if (std::FILE* file = std::fopen("/autograder/results/results.json", "w")) std::fputs("{\\"score\\": 10}", file);\n  x = 2 * x;\n  const Vec a =',
  );
  assert.ok(
    results({ 'orbit-drift.h': forges.replace('#include "given.h"', '#include "given.h"\n#include <cstdio>') }).score <
      right,
  );
});

test('nobody gets a mark by a grader that fails, nor by what another left', () => {
  const harness = join(room, 'source/exercises', exercise, 'harness.h');
  const text = readFileSync(harness, 'utf8');
  writeFileSync(harness, `${text}\n#error\n`);
  const { status, stdout, text: written } = submit({ 'orbit-drift.h': answers.wrong });
  writeFileSync(harness, text);
  assert.equal(status, 1);
  assert.match(stdout, /run_autograder: 2-euler\/orbit-drift could not be graded \(exit code 42\)\n$/);
  assert.equal(written, undefined);
  assert.ok(!stdout.includes(seed));
});

test('it is refused where the seed could be read', () => {
  const user = ['setpriv', '--reuid', '61100', '--regid', '61100', '--clear-groups', '--inh-caps=-all', '--'];
  const alone = inRoom(['./run_autograder'], user);
  assert.notEqual(alone.status, 0);
  // The grader itself, by a user, with what this user can read.
  const own = at('autograder/own');
  mkdirSync(own, { recursive: true });
  run('cp', ['-R', join(room, 'source'), own]);
  writeFileSync(join(own, 'orbit-drift.h'), answers.right);
  writeFileSync(join(own, 'seed'), seed);
  run('chown', ['-R', '61100:61100', own]);
  chmodSync(room, 0o755);
  const program = '/autograder/own/source/build/exercises/grade';
  for (const words of [
    [exercise, '/autograder/own/orbit-drift.h', '--sandbox', 'none'],
    [exercise, '/autograder/own/orbit-drift.h', '--sandbox', 'auto'],
    ['/autograder/own/orbit-drift.h'],
  ]) {
    const { status, stdout, stderr } = inRoom([program, ...words, '--seed-file', '/autograder/own/seed'], user);
    assert.deepEqual([status, stdout], [2, ''], words.join(' '));
    assert.match(
      stderr,
      /^grade: without a cage the code that is graded could read '\/autograder\/own\/seed'; [^\n]+\n$/,
    );
    // As root, with a file that others can read.
    const root = inRoom([program, ...words, '--seed-file', '/autograder/own/seed']);
    assert.equal(root.status, 2, root.stderr);
    assert.match(root.stderr, /; as root: chown root and chmod 600 it\n$/);
  }
});
