// Out of Moodle, from files made as its sources make them:   node moodle.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { linkSync, mkdirSync, rmSync, symlinkSync, utimesSync } from 'node:fs';
import { test } from 'node:test';
import { host, madeAt } from './hosts.mjs';
import { flat, handedIn, worksheet } from './moodle_files.mjs';

test('folders are taken as they are called, and headers as they lie in them', () => {
  const room = host();
  room.handOut(handedIn);
  const { status, stdout, stderr } = room.collect('moodle');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^to\/times.csv: fill in the times of 3 files\n3 files of 2 students, in to\n$/);
  assert.deepEqual(room.files(), [
    'to/Ada Lovelace_4711_assignsubmission_file/1-first/two.h',
    'to/Ada Lovelace_4711_assignsubmission_file/one.h',
    'to/Bob OBrien_4712_assignsubmission_file/one.h',
  ]);
  assert.equal(room.read('to/Bob OBrien_4712_assignsubmission_file/one.h'), '// score 4\n');
  assert.equal(room.modified('to/Bob OBrien_4712_assignsubmission_file/one.h'), madeAt.toISOString());
  assert.equal(room.mode('to/Bob OBrien_4712_assignsubmission_file/one.h'), 0o600);
  assert.ok(!room.has('to/people.csv'));
});

test('files without folders are taken into folders that Moodle takes back', () => {
  const room = host();
  room.handOut(flat);
  assert.match(room.collect('moodle').stdout, /\n3 files of 2 students, in to\n$/);
  assert.deepEqual(room.files(), [
    'to/Ada Lovelace_4711_assignsubmission_file_/one.h',
    'to/Ada Lovelace_4711_assignsubmission_file_/two.h',
    'to/Bob OBrien_4712_assignsubmission_file_/one.h',
  ]);
});

test('the folder of all rounds is no folder of students', () => {
  const room = host();
  room.handOut(handedIn);
  room.run('collect', 'moodle', 'from', 'submissions/week-1');
  const { status, stderr } = room.gradeCourse({ submissions: 'submissions' });
  assert.equal(status, 2);
  assert.match(
    stderr,
    /^grade: 'submissions' holds 'week-1', which grade collect made, [^\n]* submissions = "submissions\/week-1" [^\n]*\n$/,
  );
});

test('a second try is taken: the later one, else the one with the highest number', () => {
  const room = host();
  const of = (number, name) => `from/N_${number}_assignsubmission_file/${name}`;
  const made = (name, at = madeAt) => {
    room.write(name, `${name}\n`);
    utimesSync(room.path(name), at, at);
  };
  const later = new Date(madeAt.getTime() + 3600_000);
  made(of(1, 'one.h'));
  made(of(1, 'one (1).h'), later);
  made(of(2, 'one.h'));
  made(of(2, 'one (1).h'), new Date(madeAt.getTime() + 30_000));
  made(of(3, 'one (2).h'));
  made(of(3, 'one (10).h'));
  made(of(4, 'one (1).h'));
  made(of(5, 'other (1).h'));
  made(of(6, 'one (10).h'));
  made(of(6, 'one (2).h'), later);
  const { stdout } = room.collect('moodle');
  const taken = number => room.read(`to/N_${number}_assignsubmission_file/one.h`).trim();
  assert.equal(taken(1), of(1, 'one (1).h'));
  assert.equal(taken(2), of(2, 'one (1).h'));
  assert.equal(taken(3), of(3, 'one (10).h'));
  assert.equal(taken(4), of(4, 'one (1).h'));
  assert.equal(taken(6), of(6, 'one (2).h'));
  assert.ok(room.has('to/N_5_assignsubmission_file/other (1).h'));
  assert.match(stdout, /^Note: N_1_\w+: of one \(1\).h and one.h the first is taken, which is later$/m);
  assert.match(stdout, /^Note: N_2_\w+: of one \(1\).h and one.h the first is taken, which has the highest number$/m);
  assert.match(
    stdout,
    /^Note: N_3_\w+: of one \(10\).h and one \(2\).h the first is taken, which has the highest number$/m,
  );
  assert.match(stdout, /^Note: N_4_\w+: one \(1\).h is taken for one.h$/m);
});

test("nobody's name makes a file another's", () => {
  const room = host();
  room.handOut({
    'Eve_42_assignsubmission_file_x_4711_assignsubmission_file_one.h': '// score 10\n',
    'Eve_4711_5_assignsubmission_file_one.h': '// score 10\n',
  });
  const { stdout } = room.collect('moodle');
  assert.match(stdout, /^Not taken: Eve_4711_5_assignsubmission_file_one.h: /m);
  assert.deepEqual(room.files(), ['to/Eve_42_assignsubmission_file_/x_4711_assignsubmission_file_one.h']);
});

test('links, pipes, folders, archives and long files are not taken, and said', () => {
  const room = host();
  const ada = 'from/Ada_1_assignsubmission_file';
  room.write('secret', '// score 10\n');
  mkdirSync(room.path(`${ada}/2-second/three.h`), { recursive: true });
  symlinkSync(room.path('secret'), room.path(`${ada}/one.h`));
  symlinkSync(room.path('.'), room.path(`${ada}/1-first`));
  symlinkSync(room.path(ada), room.path('from/Bob_2_assignsubmission_file'));
  symlinkSync(room.path('secret'), room.path('from/Cy_3_assignsubmission_file_one.h'));
  execFileSync('mkfifo', [room.path(`${ada}/two.h`)]);
  room.write(`${ada}/all.zip`, 'PK');
  room.write(`${ada}/long.h`, 'x'.repeat(2 ** 20 + 1));
  linkSync(room.path('secret'), room.path(`${ada}/hard.h`));
  const { status, stdout } = room.collect('moodle');
  assert.equal(status, 0);
  for (const says of [
    'one.h is a link',
    '1-first is a link',
    '2-second/three.h is a folder',
    'two.h is no file',
    'all.zip is an archive: unpack it',
    'long.h is longer than a megabyte',
  ])
    assert.ok(stdout.includes(`Not taken: Ada_1_assignsubmission_file: ${says}\n`), `${says}: ${stdout}`);
  assert.match(stdout, /^Not taken: Bob_2_assignsubmission_file: it is not called/m);
  assert.match(stdout, /^Not taken: Cy_3_assignsubmission_file_: one.h is a link$/m);
  assert.match(stdout, /^Nothing taken of: Cy_3_assignsubmission_file_$/m);
  assert.deepEqual(room.files(), ['to/Ada_1_assignsubmission_file/hard.h']);
});

test('hostile names stay names', () => {
  const room = host();
  const name = '$(touch forged) \u202ea\nb, "c_1_assignsubmission_file';
  room.handOut({ [`${name}/one.h`]: '// score 10\n', [`${name}/--help`]: '' });
  room.write('sheet.csv', worksheet.replace('Participant 4711', 'Participant 1'));
  const { status, stdout } = room.collect('moodle', '--worksheet', 'sheet.csv');
  assert.equal(status, 0);
  assert.ok(!/\u202e/.test(stdout) && !stdout.includes('a\nb'), stdout);
  assert.ok(!room.has('forged'));
  assert.deepEqual(room.files(), [`to/${name}/one.h`]);
  assert.equal(room.read('to/times.csv'), 'student,exercise,time\r\n');
});

test('a name like a formula is found again', () => {
  const room = host();
  room.handOut({ '=SUM A1_4711_assignsubmission_file/one.h': '// score 10\n' });
  room.write('sheet.csv', worksheet.replace('Ada Lovelace', '=SUM A1'));
  room.collect('moodle', '--worksheet', 'sheet.csv');
  assert.match(room.read('to/times.csv'), /^'=SUM A1_4711/m);
  assert.equal(room.gradeCourse({ times: undefined }).status, 0);
  assert.deepEqual(Object.values(room.points()), [[10, 0]]);
});

test('a header in capitals is taken, for the student to be told its name', () => {
  const room = host();
  room.handOut({ 'Ada_1_assignsubmission_file/ONE.H': '// score 10\n' });
  assert.doesNotMatch(room.collect('moodle').stdout, /Not taken/);
  const { stdout } = room.gradeCourse();
  assert.match(stdout, /^Belongs to no exercise: Ada_1_assignsubmission_file\/ONE.H$/m);
});

test('collected again, a student has what is handed out now, and others keep what they had', () => {
  const room = host();
  room.handOut(handedIn);
  room.collect('moodle');
  rmSync(room.path('from'), { recursive: true });
  mkdirSync(room.path('to/.part-of-one-that-was-killed'));
  room.handOut({ 'Ada Lovelace_4711_assignsubmission_file/one.h': '// score 0\n' });
  const { stdout } = room.collect('moodle');
  assert.match(stdout, /^Still there from before: Bob OBrien_4712_assignsubmission_file$/m);
  assert.deepEqual(room.files(), [
    'to/Ada Lovelace_4711_assignsubmission_file/one.h',
    'to/Bob OBrien_4712_assignsubmission_file/one.h',
  ]);
  assert.equal(room.read('to/Ada Lovelace_4711_assignsubmission_file/one.h'), '// score 0\n');
  assert.ok(!room.has('to/.part-of-one-that-was-killed'));
});

test('the times of those who are not in this collection stay, and each collection has its own', () => {
  const room = host();
  room.handOut(handedIn);
  room.write('sheet.csv', worksheet);
  room.collect('moodle', '--worksheet', 'sheet.csv');
  room.run('collect', 'moodle', 'from', 'resit');
  rmSync(room.path('from/Bob OBrien_4712_assignsubmission_file'), { recursive: true });
  room.collect('moodle', '--worksheet', 'sheet.csv');
  assert.match(room.read('to/times.csv'), /^Bob OBrien_4712_assignsubmission_file,1-first\/one,2020-02-09T00:59\r$/m);
  assert.match(room.read('to/times.csv'), /^Ada Lovelace_4711_assignsubmission_file,1-first\/two,2020-02-08T23:58\r$/m);
  assert.match(room.read('resit/times.csv'), /^Bob OBrien_4712_assignsubmission_file,1-first\/one,\r$/m);
});

function refuses(code, says, prepare, ...words) {
  test(`refuses ${words.join(' ')}: ${says}`, () => {
    const room = host();
    room.handOut(handedIn);
    room.write('sheet.csv', worksheet);
    prepare?.(room);
    const { status, stdout, stderr } = room.run(...words);
    assert.match(stderr, /^grade: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.deepEqual([status, stdout], [code, '']);
    assert.ok(!room.has('to/Ada Lovelace_4711_assignsubmission_file'));
  });
}

refuses(2, /knows moodle, canvas, git and folders, not 'ilias'/, null, 'collect', 'ilias', 'from', 'to');
refuses(2, /TO is required/, null, 'collect', 'moodle', 'from');
refuses(2, /can't read the folder 'none': No such file/, null, 'collect', 'moodle', 'none', 'to');
refuses(
  2,
  /'from.zip' is an archive; unpack it/,
  room => room.write('from.zip', ''),
  'collect',
  'moodle',
  'from.zip',
  'to',
);
refuses(
  3,
  /nothing in 'from' that was handed in by way of folders/,
  room => {
    rmSync(room.path('from'), { recursive: true });
    mkdirSync(room.path('from'));
  },
  'collect',
  'folders',
  'from',
  'to',
);
refuses(2, /may not lie in each other/, null, 'collect', 'moodle', 'from', 'from/to');
refuses(
  2,
  /holds what was not collected; name a new folder/,
  room => room.write('to/mine', ''),
  'collect',
  'moodle',
  'from',
  'to',
);
refuses(
  2,
  /'to\/Ada Lovelace_4711_assignsubmission_file' is not the grader's own/,
  room => {
    room.write('to/.collected', '');
    symlinkSync(room.path('elsewhere'), room.path('to/Ada Lovelace_4711_assignsubmission_file'));
  },
  'collect',
  'moodle',
  'from',
  'to',
);
refuses(
  2,
  /'to\/times.csv' is no table of times that was collected/,
  room => {
    room.write('to/.collected', '');
    room.write('to/times.csv', 'a,b\n');
  },
  'collect',
  'moodle',
  'from',
  'to',
  '--worksheet',
  'sheet.csv',
);
refuses(
  2,
  /sheet.csv:2: 'yesterday' is no time/,
  room => room.write('sheet.csv', worksheet.replace(/Saturday[^"]*/, 'yesterday')),
  'collect',
  'moodle',
  'from',
  'to',
  '--worksheet',
  'sheet.csv',
);
refuses(
  2,
  /has the columns Identifier and Grade/,
  room => room.write('sheet.csv', 'a,b\n'),
  'collect',
  'moodle',
  'from',
  'to',
  '--worksheet',
  'sheet.csv',
);
refuses(2, /--until is for git and canvas/, null, 'collect', 'moodle', 'from', 'to', '--until', '2020-01-01T00:00Z');
refuses(2, /--worksheet is for grade collect/, null, 'one.h', '--worksheet', 'sheet.csv');
refuses(2, /grades nothing/, null, 'collect', 'moodle', 'from', 'to', '--seed', '3');
refuses(2, /no marks.json in 'results'/, null, 'hand-back', 'moodle', 'sheet.csv', 'results');
refuses(
  2,
  /knows moodle and canvas, not 'git'/,
  room =>
    room.write(
      'results/marks.json',
      JSON.stringify({
        schema: 'one-step-at-a-time/marks/v1',
        course: '',
        assignment: '',
        exercises: [],
        unmatched: [],
        students: [],
      }),
    ),
  'hand-back',
  'git',
  'sheet.csv',
  'results',
);
