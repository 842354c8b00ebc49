// Bad input and exit codes of the command line, in front of the stand-in:   node command_line.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync, spawnSync } from 'node:child_process';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { GRADE, scratch } from './classroom.mjs';

const folder = scratch();
const at = name => join(folder, name);
for (const [name, text] of Object.entries({
  'full.h': '// score 10',
  'some.h': '// score 4',
  'fails.h': '// fails',
  'again.h': '// again',
  'file': '',
  'seed': '12\n',
  'words': 'secret words',
  'two': '1 2 x',
}))
  writeFileSync(at(name), text);
mkdirSync(at('class/ada/1-first'), { recursive: true });
mkdirSync(at('empty'));
mkdirSync(at('nothing/ada'), { recursive: true });
mkdirSync(at('grades/grades.csv'), { recursive: true });

const run = (...words) => spawnSync(GRADE, words, { encoding: 'utf8', cwd: folder, timeout: 20000 });
const pipe = path => execFileSync('mkfifo', [path]);

function refuses(code, says, ...words) {
  test(`refuses ${words.join(' ')}`, () => {
    const before = readdirSync(folder);
    const { status, stdout, stderr } = run(...words);
    assert.match(stderr, /^grade: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.deepEqual([status, stdout], [code, '']);
    assert.deepEqual(readdirSync(folder), before);
  });
}

refuses(2, /name an exercise and a file/);
refuses(2, /name the file to grade/, '1-first/one');
refuses(2, /no exercise '1-first\/onee'; did you mean '1-first\/one'/, '1-first/onee', 'full.h');
refuses(2, /no exercise 'onne'; did you mean '1-first\/one'/, 'onne', 'full.h');
refuses(2, /--fast/, '1-first/one', 'full.h', '--fast');
refuses(2, /third/, '1-first/one', 'full.h', 'third');
refuses(2, /whole number below 2\^64, not '-1'/, '1-first/one', 'full.h', '--seed=-1');
refuses(2, /whole number below 2\^64, not '1e3'/, '1-first/one', 'full.h', '--seed', '1e3');
refuses(2, /below 2\^64/, '1-first/one', 'full.h', '--seed', '18446744073709551616');
refuses(2, /can't read the seed file 'none'/, '1-first/one', 'full.h', '--seed-file', 'none');
refuses(2, /seed file .words. must hold a whole number/, '1-first/one', 'full.h', '--seed-file', 'words');
refuses(2, /excludes/, '1-first/one', 'full.h', '--seed-file', 'seed', '--seed', '1');
refuses(2, /'file' is a file; name a folder/, '1-first/one', 'full.h', '--out', 'file');
refuses(2, /'file\/below' is below a file; name a folder/, '1-first/one', 'full.h', '--out', 'file/below');
refuses(2, /'file\/be\/low' is below a file/, '--class', 'class', '--out', 'file/be/low');
refuses(2, /cannot be used: File name too long/, '1-first/one', 'full.h', '--out', 'n'.repeat(300));
refuses(2, /--emit requires --out/, '1-first/one', 'full.h', '--emit', 'junit');
refuses(2, /xml not in {gradescope,junit}/, '1-first/one', 'full.h', '--out', 'o', '--emit', 'xml');
refuses(2, /chroot not in/, '1-first/one', 'full.h', '--sandbox', 'chroot');
refuses(2, /--seed needs a value/, '1-first/one', 'full.h', '--seed', '');
refuses(2, /--out needs a value/, '1-first/one', 'full.h', '--out', '');
refuses(2, /can't read the seed file '\/dev\/zero'/, '1-first/one', 'full.h', '--seed-file', '/dev/zero');
refuses(2, /grade list grades nothing/, '--list', '--class', 'class', '--out', 'o');
refuses(2, /--limits/, '1-first/one', 'full.h', '--limits', '1,2,3');
refuses(2, /--jobs requires --class/, '1-first/one', 'full.h', '--jobs', '2');
refuses(2, /--class requires --out/, '--class', 'class');
refuses(2, /sandbox only/, '--class', 'class', '--out', 'o', '--sandbox', 'none');
for (const jobs of ['0', '-1', '1001', 'two', '99999999999999999999'])
  refuses(2, /--jobs takes a whole number from 1 to 1000, not '/, '--class', 'class', '--out', 'o', '--jobs', jobs);
refuses(2, /can't read the file of what was assigned/, '--class', 'class', '--out', 'o', '--assigned', 'none');
refuses(2, /names no exercise/, '--class', 'class', '--out', 'o', '--assigned', 'file');
refuses(2, /did you mean/, '--class', 'class', '--out', 'o', '--assigned', 'words');
refuses(2, /--assigned requires --class/, '1-first/one', 'full.h', '--assigned', 'words');
refuses(2, /no exercise has '3-none' in its name/, '3-none', '--list');
refuses(2, /grade run grades nothing/, '1-first/one', '--run', 'full.h');
refuses(2, /grade hint grades nothing/, 'hint', '1-first/one', 'full.h');
refuses(2, /grade start grades nothing/, 'start', '1-first/one', '--out', 'o');
refuses(2, /EXERCISE is required/, 'start');
refuses(2, /FILE is required/, 'run');
refuses(2, /no exercise 'five'; did you mean '1-first\/one'/, 'hint', 'five');
refuses(2, /'full\.h' has no exercise's name; name the exercise before it: grade EXERCISE FILE/, 'full.h');
refuses(2, /'empty' is a folder; go there/, 'empty');
refuses(2, /name the file to grade behind the exercise; there is no one\.h here/, 'one');
refuses(2, /name an exercise and a file before --out/, '--out', 'o');
refuses(3, /two.h cannot be read|two.h/, 'two.h');
refuses(2, /no exercise '1-first\/four'/, '--class', 'class', '--out', 'o', '--exercise', '1-first/four');
for (const shard of ['0/2', '3/2', '1/0', '2', '/', 'a/b', '1/2/3']) {
  refuses(2, /--shard takes/, '--class', 'class', '--out', 'o', '--shard', shard);
}
refuses(2, /can't be called grades.csv/, '--class', 'grades', '--out', 'o');
refuses(3, /can't read the folder 'none'/, '--class', 'none', '--out', 'o');
refuses(3, /no student's folder/, '--class', 'empty', '--out', 'o');
refuses(3, /nobody handed in an exercise/, '--class', 'nothing', '--out', 'o');
refuses(3, /none.h/, '1-first/one', 'none.h');

test('an exercise is known by its name alone, and its header by where it lies', () => {
  assert.match(run('one', 'some.h').stdout, /^1-first\/one: PARTIAL/);
  mkdirSync(at('alone'));
  writeFileSync(at('alone/one.h'), '// score 4');
  const alone = word => spawnSync(GRADE, [word], { encoding: 'utf8', cwd: at('alone') }).stdout;
  for (const word of ['one', 'one.h', '1-first/one', './one.h'])
    assert.match(alone(word), /^1-first\/one: PARTIAL/, word);
});

test('exit codes say whether it was graded, or by --exit-status verdict how', () => {
  const code = (...words) => run('1-first/one', ...words).status;
  assert.equal(code('full.h'), 0);
  assert.equal(code('some.h'), 0);
  assert.equal(code('full.h', '--exit-status', 'verdict'), 0);
  assert.equal(code('some.h', '--exit-status', 'verdict'), 1);
  assert.equal(code('fails.h'), 42);
  assert.equal(code('again.h'), 75);
  assert.equal(code('again.h', '--exit-status', 'verdict'), 75);
});

test('without --out the grader only prints; with it, it writes as well', () => {
  const before = readdirSync(folder);
  assert.match(run('1-first/one', 'some.h').stdout, /^1-first\/one: PARTIAL, 4 of 10 points$/m);
  assert.deepEqual(readdirSync(folder), before);
  run('1-first/one', 'some.h', '--out', 'out/a', '--emit', 'junit', '--emit', 'gradescope', '--seed-file', 'seed');
  assert.deepEqual(readdirSync(at('out/a')).sort(), ['feedback.md', 'junit.xml', 'report.json', 'results.json']);
  assert.equal(JSON.parse(readFileSync(at('out/a/report.json'), 'utf8')).seed, '12');
  assert.ok(!existsSync(at('out/a/plots')));
});

test('a report that nobody could read is no success', () => {
  const { status, stderr } = spawnSync('/bin/sh', ['-c', '"$0" 1-first/one full.h > /dev/full', GRADE], {
    encoding: 'utf8',
    cwd: folder,
  });
  assert.deepEqual([status, stderr], [75, 'grade: what it had to say could not be written\n']);
});

test('options may stand anywhere', () => {
  for (const [n, words] of [
    ['--emit', 'junit', '--out', 'order-0', '1-first/one', 'some.h'],
    ['--out', 'order-1', '--emit', 'gradescope', '1-first/one', 'some.h'],
    ['1-first/one', '--emit', 'gradescope', 'some.h', '--out', 'order-2'],
  ].entries()) {
    const { status, stderr } = run(...words);
    assert.deepEqual([status, stderr], [0, ''], words.join(' '));
    assert.equal(readdirSync(at(`order-${n}`)).length, 3);
  }
});

test('a file of yours in the folder that --out names is not lost', () => {
  mkdirSync(at('mine'));
  writeFileSync(at('mine/feedback.md'), 'Dear diary');
  const { status, stderr, stdout } = run('1-first/one', 'some.h', '--out', 'mine');
  assert.deepEqual([status, stdout], [2, '']);
  assert.match(stderr, /^grade: 'mine' holds a feedback\.md that is not the grader's own; name another folder/);
  assert.deepEqual(readdirSync(at('mine')), ['feedback.md']);
  for (const _ of ['new', 'its own']) assert.equal(run('1-first/one', 'some.h', '--out', 'out/b').status, 0);
});

test("what is no file of the grader's, or is a link, is not read and stays", () => {
  for (const [name, make] of [
    ['report.json', pipe],
    ['feedback.md', pipe],
    ['report.json', path => symlinkSync('/dev/zero', path)],
    ['report.json', path => symlinkSync(at('own/report.json'), path)],
    ['feedback.md', path => symlinkSync(at('full.h'), path)],
    ['plots', path => symlinkSync(at('own'), path)],
  ]) {
    for (const first of [true, false]) {
      rmSync(at('odd'), { recursive: true, force: true });
      rmSync(at('own'), { recursive: true, force: true });
      run('1-first/one', 'some.h', '--out', 'own');
      mkdirSync(at('odd'));
      if (!first) run('1-first/one', 'some.h', '--out', 'odd');
      rmSync(at(`odd/${name}`), { force: true });
      make(at(`odd/${name}`));
      const before = readdirSync(at('odd'));
      const { status, stderr } = run('1-first/one', 'full.h', '--out', 'odd');
      assert.match(stderr, new RegExp(`^grade: 'odd' holds a ${name} that is not the grader's own[^\n]*\n$`));
      assert.equal(status, 2);
      assert.deepEqual(readdirSync(at('odd')), before);
    }
  }
});

test('what the grader keeps beside itself is read only if it is a file', () => {
  const own = at('own-grader');
  mkdirSync(own);
  copyFileSync(GRADE, join(own, 'grade'));
  const grade = (...words) => spawnSync(join(own, 'grade'), words, { encoding: 'utf8', cwd: folder, timeout: 20000 });
  for (const [name, words] of [
    ['done.txt', ['1-first/one', 'full.h']],
    ['installed.txt', ['run', 'full.h']],
  ]) {
    for (const make of [pipe, path => symlinkSync('/dev/zero', path)]) {
      for (const old of ['done.txt', 'installed.txt']) rmSync(join(own, old), { force: true });
      writeFileSync(join(own, 'installed.txt'), 'exercises=.\nkit=.\n');
      rmSync(join(own, name), { force: true });
      make(join(own, name));
      const { status, stderr } = grade(...words);
      assert.match(stderr, new RegExp(`^grade: '[^\n]*${name}' is not the grader's own[^\n]*\n$`));
      assert.equal(status, 2);
    }
  }
});

test('a text of an exercise that is a pipe holds up no list', () => {
  const here = at('here');
  mkdirSync(here);
  pipe(join(here, 'task.md'));
  const { status, stderr } = spawnSync(GRADE, ['--list'], { encoding: 'utf8', cwd: here, timeout: 20000 });
  assert.match(stderr, /^grade: 'task.md' is not the grader's own[^\n]*\n$/);
  assert.equal(status, 2);
});

test('files written by hand may begin with the mark of some editors', () => {
  writeFileSync(at('marked'), '\ufeff1-first/one\r\n');
  writeFileSync(at('marked-seed'), '\ufeff12\r\n');
  mkdirSync(at('marked-class/ada/1-first'), { recursive: true });
  writeFileSync(at('marked-class/ada/1-first/one.h'), '// score 10');
  const words = [
    '--class',
    'marked-class',
    '--out',
    'marked-out',
    '--assigned',
    'marked',
    '--seed-file',
    'marked-seed',
  ];
  const { status, stderr } = run(...words);
  assert.equal(status, 0, stderr);
  assert.equal(JSON.parse(readFileSync(at('marked-out/ada/1-first/one/report.json'), 'utf8')).seed, '12');
});

test('an exercise that is named twice counts once', () => {
  writeFileSync(at('twice'), '1-first/one\n1-first/one\n');
  mkdirSync(at('twice-class/ada/1-first'), { recursive: true });
  writeFileSync(at('twice-class/ada/1-first/one.h'), '// score 10');
  const named = [
    ['--assigned', 'twice'],
    ['--exercise', '1-first/one', '--exercise', '1-first/one'],
  ];
  for (const [n, words] of named.entries()) {
    const { status, stdout, stderr } = run('--class', 'twice-class', '--out', `twice-${n}`, '--seed', '5', ...words);
    assert.equal(status, 0, stderr);
    assert.match(stdout + stderr, /1 exercise\b/);
  }
});

test('a pipe or a device in place of a submission is rejected, as the help says', () => {
  const seen = run('1-first/one', '/dev/zero');
  assert.equal(seen.status, 0);
  assert.match(seen.stdout, /REJECTED/);
  assert.match(
    run('--help').stdout.replace(/\s+/g, ' '),
    /3 the submission is not there or may not be read, while a pipe/,
  );
});

test('what had full marks is done', () => {
  const done = join(dirname(GRADE), 'done.txt');
  rmSync(done, { force: true });
  run('1-first/two', 'some.h');
  assert.ok(!existsSync(done));
  for (const _ of ['once', 'again']) run('1-first/two', 'full.h');
  assert.equal(readFileSync(done, 'utf8'), '1-first/two\n');
});

test('colours come on terminals only', () => {
  assert.ok(!run('1-first/one', 'some.h').stdout.includes('\x1b'));
});

test('the grader lists exercises, says its version and helps', () => {
  assert.equal(run('--list').stdout, '1-first/one\n1-first/two\n2-second/three\n');
  assert.match(run('--version').stdout, /^1-first\/one +one$/m);
  const { status, stdout } = run('--help');
  assert.equal(status, 0);
  for (const word of ['EXERCISE', '--class', '--shard', 'Exit codes', 'start', 'hint', 'grade FILE'])
    assert.ok(stdout.includes(word), word);
  assert.ok(!stdout.includes('--limits'));
  assert.ok(stdout.split('\n').every(line => line.length <= 100));
});

test('a grader that fails at its own solution takes no point from anybody', () => {
  const grade = (file, ...more) =>
    spawnSync(GRADE, ['1-first/one', file, ...more], {
      encoding: 'utf8',
      cwd: folder,
      env: { ...process.env, STAND_IN_BROKEN: '1-first/one' },
    });
  const { status, stdout } = grade('some.h', '--out', 'broken');
  assert.equal(status, 42);
  assert.match(stdout, /g\+\+: no cc1plus/);
  const { verdict, score, why } = JSON.parse(readFileSync(at('broken/report.json'), 'utf8'));
  assert.deepEqual([verdict, score], ['GRADER_ERROR', null]);
  assert.match(why, /^the grader gives its own solution COMPILE_ERROR/);
  assert.equal(grade('full.h').status, 0); // full marks prove that it works
});
