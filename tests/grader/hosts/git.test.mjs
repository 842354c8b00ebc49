// Clones of git repositories, honest ones and others:   node git.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { appendFileSync, chmodSync, cpSync, mkdirSync, rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { host, time } from './hosts.mjs';
import { commit, git } from './repository.mjs';

const inTime = '2020-02-08T22:00:00Z';
const late = '2020-02-09T12:00:00Z';
const end = '2020-02-08T23:59:00+01:00';

test('the last commit is taken, or the last one by then, with its time', () => {
  const room = host();
  commit(room.path('from/ada'), { 'one.h': '// score 4\n', '1-first/two.h': '// score 4\n', 'notes.txt': '' }, inTime);
  commit(room.path('from/ada'), { 'one.h': '// score 10\n' }, late);
  const now = room.collect('git');
  assert.deepEqual([now.status, now.stderr], [0, '']);
  assert.match(
    now.stdout,
    /^Note: ada: commit [0-9a-f]{10} of 2020-02-09T12:00Z\nThe times are in to\/times.csv\n2 files of 1 student, in to\n$/,
  );
  assert.deepEqual(room.files(), ['to/ada/1-first/two.h', 'to/ada/one.h']);
  assert.equal(room.read('to/ada/one.h'), '// score 10\n');
  assert.equal(room.modified('to/ada/one.h'), new Date(late).toISOString());
  assert.match(room.read('to/times.csv'), /^ada,1-first\/one,2020-02-09T12:00Z\r$/m);
  assert.match(room.read('to/times.csv'), /^ada,1-first\/two,2020-02-08T22:00Z\r$/m); // which that commit left alone
  assert.match(room.collect('git', '--until', end).stdout, /of 2020-02-08T22:00Z$/m);
  assert.equal(room.read('to/ada/one.h'), '// score 4\n');
  assert.match(
    room.collect('git', '--until', '2020-01-01T00:00Z').stdout,
    /^Not taken: ada: there is no commit by then$/m,
  );
  assert.ok(!room.has('to/ada/one.h'));
});

test('what is not committed does not count, and packed or bare repositories do', () => {
  const room = host();
  commit(room.path('from/ada'), { 'one.h': '// score 4\n' }, inTime);
  writeFileSync(room.path('from/ada/one.h'), '// score 10\n');
  git(room.path('from/ada'), ['gc', '--quiet']);
  git(room.path('from/ada'), ['pack-refs', '--all']);
  commit(room.path('bob'), { 'one.h': '// score 4\n' }, inTime);
  git(room.folder, ['clone', '--quiet', '--bare', 'bob', 'from/bob.git']);
  commit(room.path('cy'), { 'one.h': '// score 0\n' }, inTime);
  commit(room.path('cy'), { 'one.h': '// score 4\n' }, inTime);
  git(room.folder, ['clone', '--quiet', '--depth', '1', `file://${room.path('cy')}`, 'from/cy']);
  git(room.path('from/ada'), ['checkout', '--quiet', '--detach']);
  mkdirSync(room.path('from/dan'));
  git(room.path('from/dan'), ['init', '--quiet']);
  mkdirSync(room.path('from/eve'));
  const { stdout } = room.collect('git');
  for (const name of ['ada', 'bob', 'cy']) assert.equal(room.read(`to/${name}/one.h`), '// score 4\n');
  assert.match(stdout, /^Not taken: dan: its branch has no commit yet$/m);
  assert.match(stdout, /^Not taken: eve: it is no git repository$/m);
});

test('a table names folders and addresses', () => {
  const room = host();
  commit(room.path('a b'), { 'one.h': '// score 4\n' }, inTime);
  commit(room.path('a b'), { 'one.h': '// score 10\n' }, late);
  room.write(
    'table.csv',
    `student,repository\nada,a b\nbob,file://${room.path('a b')}\ncy,file:///nowhere\ndan,ext::sh -c touch% forged\n`,
  );
  const { status, stdout } = room.run('collect', 'git', 'table.csv', 'to', '--until', end);
  assert.equal(status, 0);
  assert.equal(room.read('to/ada/one.h'), '// score 4\n');
  assert.equal(room.read('to/bob/one.h'), '// score 4\n');
  assert.match(stdout, /^Not taken: cy: fatal: /m);
  assert.match(stdout, /^Not taken: dan: fatal: transport 'ext' not allowed$/m);
  for (const [says, rows] of [
    [/:1: the columns of such a table/, 'a,b\n'],
    [/:2: a folder can't be called '..'/, 'student,repository\n..,a b\n'],
    [/:2: a folder can't be called 'x\/y'/, 'student,repository\nx/y,a b\n'],
    [/:2: where is the repository\?/, 'student,repository\nada,--upload-pack=touch forged\n'],
    [/:3: 'ada' has a line already/, 'student,repository\nada,a b\nada,a b\n'],
  ]) {
    room.write('table.csv', rows);
    const refused = room.run('collect', 'git', 'table.csv', 'to');
    assert.match(refused.stderr, says);
    assert.equal(refused.status, 2);
  }
  assert.ok(!room.has('forged'));
});

test('nothing that a repository brings along is run', () => {
  const room = host();
  const ada = room.path('from/ada');
  commit(ada, { 'one.h': '// score 4\n', '.gitattributes': '* filter=evil diff=evil\n' }, inTime);
  const hash = git(ada, ['rev-parse', 'HEAD:one.h']);
  const evil = join(room.folder, 'evil');
  writeFileSync(evil, `#!/bin/sh\ntouch ${room.path('forged')}\n`);
  chmodSync(evil, 0o755);
  for (const hook of ['post-checkout', 'reference-transaction', 'post-index-change', 'pre-auto-gc']) {
    cpSync(evil, join(ada, '.git/hooks', hook));
    chmodSync(join(ada, '.git/hooks', hook), 0o755);
  }
  appendFileSync(
    join(ada, '.git/config'),
    `[core]\n\tfsmonitor = ${evil}\n\tpager = ${evil}\n\teditor = ${evil}\n\tsshCommand = ${evil}\n\talternateRefsCommand = ${evil}\n` +
      `[filter "evil"]\n\tclean = ${evil}\n\tsmudge = ${evil}\n[diff "evil"]\n\ttextconv = ${evil}\n\tcommand = ${evil}\n` +
      `[gpg]\n\tprogram = ${evil}\n[log]\n\tshowSignature = true\n[protocol]\n\tallow = always\n` +
      `[extensions]\n\tpartialClone = origin\n[remote "origin"]\n\turl = ext::${evil}\n\tpromisor = true\n`,
  );
  assert.equal(room.collect('git').status, 0);
  assert.equal(room.read('to/ada/one.h'), '// score 4\n');
  // An object that is missing is not fetched.
  rmSync(join(ada, '.git/objects', hash.slice(0, 2), hash.slice(2)));
  assert.match(room.collect('git').stdout, /^Not taken: ada: git can't read it: /m);
  assert.ok(!room.has('forged'));
});

test('trees that no git makes, links and submodules stay where they are', () => {
  const room = host();
  const ada = room.path('from/ada');
  commit(ada, { 'one.h': '// score 10\n' }, inTime);
  const blob = git(ada, ['rev-parse', 'HEAD:one.h']);
  const raw = name => Buffer.concat([Buffer.from(`100644 ${name}\0`), Buffer.from(blob, 'hex')]);
  const link = git(ada, ['hash-object', '-w', '--stdin'], { input: room.path('secret') });
  const tree = Buffer.concat([
    raw('../../climbs.h'),
    Buffer.concat([Buffer.from('120000 one.h\0'), Buffer.from(link, 'hex')]),
    Buffer.concat([Buffer.from('160000 two.h\0'), Buffer.from(blob, 'hex')]),
  ]);
  const hash = git(ada, ['hash-object', '-t', 'tree', '-w', '--literally', '--stdin'], { input: tree });
  git(ada, ['update-ref', 'refs/heads/main', git(ada, ['commit-tree', hash, '-m', 'x'])]);
  room.write('secret', '// score 10\n');
  const { stdout } = room.collect('git');
  assert.match(stdout, /climbs.h has a name that no file has$/m);
  assert.match(stdout, /one.h is a link$/m);
  assert.match(stdout, /two.h is no file$/m);
  assert.deepEqual(room.files(), []);
  assert.ok(!room.has('climbs.h') && !room.has('to/climbs.h'));
});

test('a repository that leads elsewhere is not followed', () => {
  const room = host();
  commit(room.path('other'), { 'one.h': '// score 10\n' }, inTime);
  mkdirSync(room.path('from/ada'));
  symlinkSync(room.path('other/.git'), room.path('from/ada/.git'));
  mkdirSync(room.path('from/bob'));
  writeFileSync(room.path('from/bob/.git'), `gitdir: ${room.path('other/.git')}\n`);
  symlinkSync(room.path('other'), room.path('from/cy'));
  mkdirSync(room.path('from/dan/.git'), { recursive: true });
  symlinkSync(room.path('other/.git/objects'), room.path('from/dan/.git/objects'));
  writeFileSync(room.path('from/dan/.git/HEAD'), git(room.path('other'), ['rev-parse', 'HEAD']));
  mkdirSync(room.path('from/eve/.git/objects'), { recursive: true });
  writeFileSync(room.path('from/eve/.git/HEAD'), `ref: refs/heads/../../../../../other/.git/refs/heads/main\n`);
  const { stdout } = room.collect('git');
  assert.match(stdout, /^Not taken: ada: its .git is no folder/m);
  assert.match(stdout, /^Not taken: bob: its .git is no folder/m);
  assert.match(stdout, /^Not taken: cy: it is not a student's folder$/m);
  assert.match(stdout, /^Not taken: dan: it is no git repository$/m);
  assert.match(stdout, /^Not taken: eve: its branch has no commit yet$/m);
  assert.deepEqual(room.files(), []);
});

test(
  "a repository is read, whoever's it is",
  { skip: process.getuid() !== 0 && 'only root can give files away' },
  () => {
    const room = host();
    commit(room.path('from/ada'), { 'one.h': '// score 4\n' }, inTime);
    execFileSync('chown', ['-R', '61102:61102', room.path('from/ada')]);
    room.collect('git');
    assert.equal(room.read('to/ada/one.h'), '// score 4\n');
  },
);

test('a round is graded by the times of commits', () => {
  const room = host();
  commit(room.path('from/ada'), { 'one.h': '// score 10\n' }, inTime);
  commit(room.path('from/bob'), { 'one.h': '// score 10\n' }, late);
  room.collect('git');
  room.gradeCourse({ times: undefined, late: { points_a_day: 3 } });
  assert.deepEqual(room.points(), { ada: [10, 0], bob: [7, 0] });
});

test('a course takes what still counts of each student, and tidying up is not late', () => {
  const room = host();
  const dayAfter = '2020-02-10T12:00:00Z';
  const weekAfter = '2020-02-16T12:00:00Z';
  for (const name of ['ada', 'bob', 'cy', 'dan'])
    commit(room.path(`from/${name}`), { 'one.h': '// score 4\n' }, inTime);
  commit(room.path('from/ada'), { 'one.h': '// score 10\n' }, late); // with an extension
  commit(room.path('from/bob'), { 'one.h': '// score 10\n' }, dayAfter);
  commit(room.path('from/cy'), { 'notes.txt': '' }, dayAfter);
  commit(room.path('from/dan'), { 'one.h': '// score 10\n' }, weekAfter);
  const course = {
    times: undefined,
    late: { points_a_day: 1, days: 3 },
    extension: [{ student: 'ada', assignment: 'week-1', due: time('2020-02-09T23:59:00') }],
  };
  room.handOut({}, 'to');
  room.gradeCourse(course); // writes the file
  const { status, stderr } = room.collect('git', '--course', 'course.toml', '--round', 'week-1');
  assert.deepEqual([status, stderr], [0, '']);
  room.gradeCourse(course);
  assert.deepEqual(room.points(), { ada: [10, 0], bob: [8, 0], cy: [4, 0], dan: [4, 0] });
});

for (const [says, ...words] of [
  [/--course and --round belong together/, '--round', 'week-1'],
  [/--until is one time for all/, '--course', 'course.toml', '--round', 'week-1', '--until', end],
  [/there is no assignment 'week-2'; did you mean 'week-1'\?/, '--course', 'course.toml', '--round', 'week-2'],
])
  test(`refuses ${words.join(' ')}: ${says}`, () => {
    const room = host();
    commit(room.path('from/ada'), { 'one.h': '// score 4\n' }, inTime);
    room.gradeCourse();
    const { status, stderr } = room.collect('git', ...words);
    assert.match(stderr, says);
    assert.equal(status, 2);
    assert.ok(!room.has('to'));
  });
