// Classes, graded by the stand-in:   node class.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import {
  chmodSync,
  cpSync,
  existsSync,
  linkSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  renameSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { GRADE, classroom, rows } from './classroom.mjs';

const three = {
  'ada/1-first/one': '// score 10',
  'bob/1-first/one': '// score 4',
  'cy/1-first/one': 'no such thing',
  'ada/2-second/three': '// score 0',
};

test('a class is graded, and the tables say what the reports say', () => {
  const room = classroom(three);
  const { status, stdout, stderr, graded } = room.grade();
  assert.equal(status, 0, stderr);
  assert.deepEqual(graded, ['ada 1-first/one', 'ada 2-second/three', 'bob 1-first/one', 'cy 1-first/one']);
  assert.deepEqual(rows(room.read('grades.csv')), [
    'student,1-first/one,2-second/three,total,of',
    'ada,10,0,10,20',
    'bob,4,,4,10',
    'cy,0,,0,10',
  ]);
  const long = rows(room.read('report.csv'));
  assert.equal(long[0], 'student,exercise,verdict,score,points,seed,grader,why');
  assert.equal(long[1], 'ada,1-first/one,ACCEPTED,10,10,1,one,');
  assert.match(long[4], /^cy,1-first\/one,COMPILE_ERROR,0,10,1,one,./);
  assert.match(stdout, /^\[4\/4\] /m);
  assert.equal(long.length, 5);
  assert.ok(!room.has('bob/2-second')); // nobody asked it of him
  assert.match(room.read('summary.html'), /bob<\/th><td class="number">4\/10<\/td>/);
  assert.match(room.read('ada/1-first/one/feedback.md'), /^# 1-first\/one: ACCEPTED/);
});

test('who had to hand in something and did not is told what was expected and what is there', () => {
  const room = classroom({ ...three, 'dan/1-first/One': '// score 10' });
  writeFileSync(room.path('assigned'), '1-first/one');
  assert.equal(room.grade(['--assigned', room.path('assigned')]).status, 0);
  const { verdict, why, score } = room.report('dan/1-first/one');
  assert.deepEqual([verdict, score], ['REJECTED', 0]);
  assert.match(why, /one\.h/);
  assert.match(why, /One\.h/);
});

test('graded again, only what changed is graded', () => {
  const room = classroom({ ...three, 'empty/1-first/other': '' });
  assert.equal(room.grade().graded.length, 4);
  const { graded, stdout, status } = room.grade();
  assert.deepEqual([graded, status], [[], 0]);
  assert.match(stdout, /4 submissions graded before/);
  room.write('bob/1-first/one', '// score 10');
  assert.deepEqual(room.grade().graded, ['bob 1-first/one']);
  assert.match(room.read('grades.csv'), /^bob,10,,10,10\r$/m);
  writeFileSync(room.path('results/cy/1-first/one/report.json'), '{"schema":');
  assert.deepEqual(room.grade().graded, ['cy 1-first/one']);
  assert.equal(room.grade(['--seed', '7']).graded.length, 4);
  assert.equal(room.grade(['--seed', '7'], { STAND_IN_VERSION: 'two' }).graded.length, 4);
});

test('a submission that was not there is graded as soon as it is', () => {
  for (const more of [[], ['--assigned', 'assigned']]) {
    const room = classroom(three);
    writeFileSync(room.path('assigned'), '2-second/three');
    const words = more.map(word => word.replace(/^a/, room.path('a')));
    room.grade(words);
    room.write('bob/2-second/three', '// score 10');
    assert.deepEqual(room.grade(words).graded, ['bob 2-second/three']);
  }
});

test('a file of more than one name, as in a backup of hard links, is graded, and that is said once', () => {
  const room = classroom(three);
  linkSync(room.path('submissions/bob/1-first/one.h'), room.path('backup'));
  const { status, stdout } = room.grade();
  assert.equal(status, 0);
  assert.match(stdout, /^1 submission with more than one hard link, as a backup makes them$/m);
  assert.equal(room.report('bob/1-first/one').score, 4);
});

test('a submission on which the grader fails stops nobody, has no grade, and is tried again', () => {
  for (const [fate, code] of [
    ['crash', 75],
    ['again', 75],
    ['fails', 42],
  ]) {
    const room = classroom({ ...three, 'aaa/1-first/one': `// ${fate}` });
    const first = room.grade(['--exercise', '1-first/one']);
    assert.equal(first.status, code, fate);
    assert.match(first.stderr, /^grade: 1 submission without a grade[^\n]*\n$/);
    assert.equal(room.report('aaa/1-first/one').verdict, 'GRADER_ERROR');
    assert.equal(rows(room.read('part/grades.csv'))[1], 'aaa,,,');
    assert.equal(rows(room.read('part/grades.csv'))[2], 'ada,10,10,10');
    room.write('aaa/1-first/one', '// score 10');
    assert.deepEqual(room.grade(['--exercise', '1-first/one']).graded, ['aaa 1-first/one']);
  }
});

test('what is killed at its deadline has the points that it had, and is not tried again', () => {
  const room = classroom({ ...three, 'aaa/1-first/one': '// slow 4', 'abe/1-first/one': '// slow' });
  const { status, stderr } = room.grade(['--exercise', '1-first/one', '--emit', 'gradescope']);
  assert.deepEqual([status, stderr], [0, '']);
  for (const [student, score] of [
    ['aaa', 4],
    ['abe', 0],
  ]) {
    const report = room.report(`${student}/1-first/one`);
    assert.deepEqual([report.verdict, report.score], ['TIME_LIMIT', score]);
    assert.match(report.why, /stopped at its deadline/);
    assert.equal(JSON.parse(room.read(`${student}/1-first/one/results.json`)).score, score);
  }
  assert.deepEqual(rows(room.read('part/grades.csv')).slice(1, 4), ['aaa,4,4,10', 'abe,0,0,10', 'ada,10,10,10']);
  assert.deepEqual(room.grade(['--exercise', '1-first/one']).graded, []);
});

test('where a report cannot be written there is no grade, and the others have theirs', () => {
  const room = classroom(three);
  mkdirSync(room.results);
  writeFileSync(room.path('results/bob'), '');
  assert.equal(room.grade().status, 75);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), ['ada,10,0,10,20', 'bob,,,,', 'cy,0,,0,10']);
});

test('names of students do no harm', () => {
  const names = [
    'new\nline',
    '-rf',
    '$(touch forged)',
    '`touch forged`',
    '=1+1',
    '"quoted"',
    'a,b',
    'a;=1+1',
    "it's",
    '<i>',
    '##[x]',
    ' ',
    'n'.repeat(255),
  ];
  const room = classroom(Object.fromEntries(names.map(name => [`${name}/1-first/one`, '// score 10'])));
  const latin = Buffer.concat([Buffer.from(`${room.submissions}/`), Buffer.from([0xff, 0xfe])]);
  renameSync(room.path(`submissions/${names[0]}`), latin);
  room.write(`${names[0]}/1-first/one`, '// score 4');
  const { status, stdout } = room.grade();
  assert.equal(status, 0);
  const lines = rows(room.read('grades.csv'));
  assert.equal(lines.length, names.length + 2);
  for (const line of [
    'new\\x0aline,4,4,10',
    "'-rf,10,10,10",
    "'=1+1,10,10,10",
    '"""quoted""",10,10,10',
    '"a,b",10,10,10',
    '"a;=1+1",10,10,10',
    '\\xff\\xfe,10,10,10',
  ]) {
    assert.ok(lines.includes(line), line);
  }
  assert.ok(!room.has('forged'));
  assert.doesNotMatch(stdout, /##\[/);
  assert.doesNotMatch(room.read('summary.html'), /<i>|##\[|\nline/);
  assert.equal(room.grade().graded.length, 0);
});

test('what was assigned counts for all, and nothing else does', () => {
  const room = classroom(three);
  writeFileSync(room.path('assigned'), '1-first/one  # the first week\n\n1-first/two\n');
  const { status, stdout } = room.grade(['--assigned', room.path('assigned')]);
  assert.equal(status, 0);
  assert.match(stdout, /^Handed in, but not assigned: 2-second\/three$/m);
  assert.deepEqual(rows(room.read('grades.csv')), [
    'student,1-first/one,1-first/two,total,of',
    'ada,10,0,10,20',
    'bob,4,0,4,20',
    'cy,0,0,0,20',
  ]);
});

test('a part of the exercises has its own tables, and those of the class stay', () => {
  const room = classroom(three);
  room.grade();
  const whole = room.read('grades.csv');
  room.write('bob/1-first/one', '// score 10');
  const { stdout } = room.grade(['--exercise', '1-first/one']);
  assert.match(stdout, /see .*results\/part\/summary.html/);
  assert.equal(room.read('grades.csv'), whole);
  assert.deepEqual(rows(room.read('part/grades.csv')).slice(1), ['ada,10,10,10', 'bob,10,10,10', 'cy,0,0,10']);
});

test("headers may lie in the student's own folder, as Moodle packs them", () => {
  const name = 'Ada Lovelace_4711_assignsubmission_file_';
  const room = classroom({ [`${name}/one`]: '// score 10', [`${name}/onee`]: '// score 10' });
  const { status, stdout } = room.grade();
  assert.equal(status, 0);
  assert.match(stdout, /^Belongs to no exercise: .*file_\/onee.h$/m);
  assert.deepEqual(rows(room.read('grades.csv')), ['student,1-first/one,total,of', `${name},10,10,10`]);
});

test('files, links and hidden folders are no students', () => {
  const room = classroom(three);
  symlinkSync('/etc', room.path('submissions/link'));
  mkdirSync(room.path('submissions/.git'));
  writeFileSync(room.path('submissions/notes'), '');
  const { status, stdout } = room.grade();
  assert.equal(status, 0);
  for (const name of ['link', '.git', 'notes'])
    assert.match(stdout, new RegExp(`^Not a student's folder: ${name}$`, 'm'));
  assert.equal(rows(room.read('grades.csv')).length, 4);
});

test('shards together are the whole, and the tables come of a last run', () => {
  const room = classroom(three);
  const parts = [1, 2, 3, 4].map(i => {
    const run = room.grade(['--shard', `${i}/4`]);
    assert.equal(run.status, 0, run.stderr);
    assert.ok(!room.has('grades.csv'));
    return run.graded;
  });
  assert.deepEqual(
    parts.map(part => part.length),
    [1, 1, 1, 1],
  );
  assert.equal(new Set(parts.flat()).size, 4);
  assert.deepEqual(room.grade().graded, []);
  assert.equal(rows(room.read('grades.csv')).length, 4);
});

test('two graders do not work in one folder', async () => {
  const room = classroom({ 'ada/1-first/one': '// slow' });
  const slow = room.start();
  for (let n = 0; n < 200 && !room.has('ada/1-first/one/report.json'); ++n) await sleep(50);
  const { status, stderr } = room.grade();
  assert.equal(status, 75);
  assert.match(stderr, /another grader is at work in '.*results'; wait for it/);
  slow.kill();
});

test('a table of yours is not lost', () => {
  const room = classroom({ 'ada/1-first/one': '// score 10' });
  mkdirSync(room.results);
  writeFileSync(room.path('results/grades.csv'), 'of last year');
  const { status, stderr } = room.grade();
  assert.equal(status, 2);
  assert.match(stderr, /'.*results' holds a grades\.csv that is not the grader's own; name another folder/);
  assert.equal(room.read('grades.csv'), 'of last year');
  assert.ok(!room.has('ada'));
});

test('marks and seeds are for nobody else to read', () => {
  const room = classroom({ 'ada/1-first/one': '// score 10' });
  writeFileSync(room.path('seed'), '7\n', { mode: 0o644 });
  const { status, stderr } = room.grade(['--seed-file', room.path('seed')]);
  assert.equal(status, 0);
  assert.match(stderr, /others can read the seed; chmod 600 .*seed/);
  for (const file of ['grades.csv', 'ada/1-first/one/report.json']) {
    assert.equal(statSync(join(room.results, file)).mode & 0o077, 0, file);
  }
  chmodSync(room.path('seed'), 0o600);
  assert.equal(room.grade(['--seed-file', room.path('seed')]).stderr, '');
});

test('of many stray files a few are named', () => {
  const room = classroom({ 'ada/1-first/one': '// score 10' });
  for (let n = 0; n < 300; ++n) room.write(`ada/1-first/stray-${n}`, '');
  const named = room
    .grade()
    .stdout.split('\n')
    .filter(line => line.startsWith('Belongs to no exercise: '));
  assert.equal(named.length, 4);
  assert.equal(named[3], 'Belongs to no exercise: ada: 297 more');
});

test("many stray files of one student hide nobody else's", () => {
  const room = classroom({ 'ada/1-first/one': '// score 10', 'zoe/1-first/onee': '// score 10' });
  for (let n = 0; n < 300; ++n) room.write(`ada/1-first/stray-${n}`, '');
  assert.match(room.grade().stdout, /^Belongs to no exercise: zoe\/1-first\/onee.h$/m);
});

const slowest = {
  'ada/1-first/one': '// slow',
  'ada/1-first/two': '// slow',
  'ada/2-second/three': '// score 10',
  'bob/1-first/one': '// score 4',
  'cy/1-first/one': '// score 4',
};
const started = room => readFileSync(room.path('log'), 'utf8').split('\n').filter(Boolean);

test('whoever hands in much that is slow waits alone', () => {
  const room = classroom(slowest);
  assert.equal(room.grade([], { STAND_IN_SECONDS: '2' }).status, 0);
  const order = started(room);
  assert.ok(order.indexOf('cy 1-first/one') < order.indexOf('ada 1-first/two'), order.join(', '));
  assert.equal(order.length, 5);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), ['ada,10,10,10,30,30', 'bob,4,,,4,10', 'cy,4,,,4,10']);
});

test('one job takes submissions in the order of their names', () => {
  const room = classroom(slowest);
  const words = ['--class', room.submissions, '--out', room.results, '--jobs', '1'];
  assert.equal(spawnSync(GRADE, words, { env: room.environment({ STAND_IN_SECONDS: '0' }) }).status, 0);
  assert.deepEqual(
    started(room),
    Object.keys(slowest).map(name => name.replace('/', ' ')),
  );
});

// What stands in the results in place of something of the grader's.
for (const [name, make] of [
  ['a pipe as a report', room => pipe(room.path('results/ada/1-first/one/report.json'))],
  ['a pipe as feedback', room => pipe(room.path('results/ada/1-first/one/feedback.md'))],
  ['a pipe as a table', room => pipe(room.path('results/grades.csv'))],
  ['a pipe as the lock', room => pipe(room.path('results/.lock'))],
  ['an endless device', room => link(room, '/dev/zero', 'ada/1-first/one/report.json')],
  ['a linked report', room => link(room, room.path('elsewhere/report.json'), 'ada/1-first/one/report.json')],
  ['linked plots', room => link(room, room.path('elsewhere'), 'ada/1-first/one/plots')],
  ['a linked lock', room => link(room, room.path('elsewhere/lock'), '.lock')],
  ['a linked student', room => link(room, room.path('elsewhere'), 'ada')],
  ['a linked chapter', room => link(room, room.path('elsewhere'), 'ada/1-first')],
  ['a linked part', room => link(room, room.path('elsewhere'), 'part')],
]) {
  test(`${name} is not the grader's own, and stays as it is`, () => {
    const room = classroom({ 'ada/1-first/one': '// score 10' });
    const elsewhere = room.path('elsewhere');
    mkdirSync(elsewhere);
    for (const name of ['lock', 'test-1.svg']) writeFileSync(join(elsewhere, name), 'not to be touched');
    assert.equal(room.grade().status, 0);
    cpSync(room.path('results/ada/1-first/one/report.json'), join(elsewhere, 'report.json'));
    make(room);
    const { status, stderr, graded } = room.grade(['--seed', '7']);
    assert.match(stderr, /^grade: [^\n]* not the grader's own[^\n]*\n$/);
    assert.deepEqual([status, graded], [2, []]);
    assert.deepEqual(readdirSync(elsewhere).sort(), ['lock', 'report.json', 'test-1.svg']);
  });
}

function pipe(path) {
  rmSync(path, { force: true });
  execFileSync('mkfifo', [path]);
}

function link(room, to, name) {
  rmSync(room.path(`results/${name}`), { recursive: true, force: true });
  symlinkSync(to, room.path(`results/${name}`));
}

test('a grader that fails at its own solution of one exercise grades nobody', () => {
  const room = classroom(three);
  const { status, stderr, graded } = room.grade([], { STAND_IN_BROKEN: '2-second/three' });
  assert.deepEqual([status, graded], [42, []]);
  assert.equal(
    stderr,
    'grade: nobody is graded, since the grader gives its own solution COMPILE_ERROR:\ng++: no cc1plus\n',
  );
  assert.ok(!existsSync(room.results));
});

test('a machine that cannot hold a submission grades none', () => {
  const room = classroom(three);
  const { status, stderr, graded } = room.grade([], { STAND_IN_UNSAFE: '1' });
  assert.deepEqual([status, graded], [42, []]);
  assert.equal(stderr, 'grade: the cage does not hold; install bubblewrap\n');
  assert.ok(!room.has('grades.csv'));
});
