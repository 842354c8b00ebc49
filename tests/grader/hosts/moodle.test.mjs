// Moodle, there and back, from files made as its sources make them:   node moodle.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { linkSync, mkdirSync, rmSync, symlinkSync, utimesSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { host, madeAt } from './hosts.mjs';

const handedIn = {
  'Ada Lovelace_4711_assignsubmission_file/one.h': '// score 10\n',
  'Ada Lovelace_4711_assignsubmission_file/1-first/two.h': '// score 4\n',
  'Bob OBrien_4712_assignsubmission_file/one.h': '// score 4\n',
};
// The same without folders, and what an older Moodle has at a folder's end.
const flat = {
  'Ada Lovelace_4711_assignsubmission_file_one.h': '// score 10\n',
  'Ada Lovelace_4711_assignsubmission_file_two.h': '// score 4\n',
  'Bob OBrien_4712_assignsubmission_file_one.h': '// score 4\n',
};
const worksheet =
  '\ufeffIdentifier,"Full name","Email address",Status,Grade,"Maximum Grade","Grade can be changed",' +
  '"Last modified (submission)","Last modified (grade)","Feedback comments"\r\n' +
  '"Participant 4711","Ada Lovelace",ada@example.org,"Submitted for grading",,20.00,Yes,"Saturday, 8 February 2020, 11:58 PM",-,\r\n' +
  '"Participant 4712","Bob O\'Brien",bob@example.org,"Submitted for grading - 1 hour late",,20.00,Yes,"Sunday, 9 February 2020, 12:59 AM",-,"said ""hm"""\r\n' +
  '"Participant 4713","Cy, C.",cy@example.org,"No submission",,20.00,Yes,-,-,\r\n';
const roster =
  "First name,Last name,Email address\nAda,Lovelace,ada@example.org\nBob,O'Brien,bob@example.org\nCy,C.,cy@example.org\n";

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

for (const [name, files] of Object.entries({ folders: handedIn, files: flat }))
  test(`a round goes in as ${name} and out as a worksheet, with the times of the worksheet`, () => {
    const room = host();
    room.handOut(files);
    room.write('sheet.csv', worksheet);
    room.write('roster.csv', roster);
    assert.match(room.collect('moodle', '--worksheet', 'sheet.csv').stdout, /^The times are in to\/times.csv\n/);
    const late = { points_a_day: 2 };
    const { status, stderr } = room.gradeCourse({ roster: 'roster.csv', times: undefined, late });
    assert.deepEqual([status, stderr], [0, '']);
    assert.deepEqual(room.points(), {
      'ada@example.org': [10, 4],
      'bob@example.org': [2, 0],
      'cy@example.org': [0, 0],
    });
    const back = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
    assert.deepEqual([back.status, back.stderr], [0, '']);
    assert.equal(back.stdout, '3 marks of week-1 filled in: results/week-1/moodle.csv\n');
    const filled = worksheet
      .replace('grading",,20', 'grading",14,20')
      .replace('late",,20', 'late",2,20')
      .replace('submission",,20', 'submission",0,20')
      .replace('PM",-,\r', 'PM",-,1-first/one: 10 of 10. 1-first/two: 4 of 10.\r')
      .replace(
        '"said ""hm"""',
        '"1-first/one: 2 of 10. Handed in 1 h after the end: 2 points are taken, for 1 day begun. 1-first/two: 0 of 10. Not handed in."',
      )
      .replace('Yes,-,-,\r', 'Yes,-,-,1-first/one: 0 of 10. Not handed in. 1-first/two: 0 of 10. Not handed in.\r');
    assert.equal(room.read('results/week-1/moodle.csv'), filled);
    assert.equal(room.read('sheet.csv'), worksheet);
    assert.equal(room.mode('results/week-1/moodle.csv'), 0o600);
  });

test('without a roster the number in the folder is enough', () => {
  const room = host();
  room.handOut(handedIn);
  room.write('sheet.csv', worksheet);
  room.collect('moodle', '--worksheet', 'sheet.csv');
  assert.equal(room.gradeCourse({ times: undefined }).status, 0);
  const { stdout } = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.match(stdout, /^2 marks of week-1 filled in/);
  assert.match(room.read('results/week-1/moodle.csv'), /"Cy, C.",cy@example.org,"No submission",,20/);
});

test('whoever has no row, and whoever has no mark, is said', () => {
  const room = host();
  room.handOut({
    ...handedIn,
    'Eve_9999_assignsubmission_file/one.h': '// score 10\n',
    'Cy C._4713_assignsubmission_file/one.h': '// fails\n',
  });
  room.write('sheet.csv', worksheet);
  room.collect('moodle');
  assert.equal(room.gradeCourse().status, 42);
  const { stdout } = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.match(stdout, /^On no line of the table: Eve_9999_assignsubmission_file\n/);
  assert.match(stdout, /\nWithout a mark, and left as it was: Cy C._4713_assignsubmission_file\n2 marks/);
});

for (const most of ['10.00', '100.00'])
  test(`a round is not handed back into an assignment out of ${most}`, () => {
    const room = host();
    room.handOut(handedIn);
    room.write('sheet.csv', worksheet.replaceAll('20.00', most));
    room.collect('moodle');
    room.gradeCourse();
    const { status, stderr } = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
    assert.equal(status, 2);
    assert.match(
      stderr,
      new RegExp(`^grade: sheet.csv:2: the assignment is out of ${most} there, and this round out of 20; [^\\n]*\\n$`),
    );
    assert.ok(!room.has('results/week-1/moodle.csv'));
  });

test('the worksheet of another assignment is refused, in which the numbers are others’', () => {
  const room = host();
  room.handOut(handedIn);
  room.write('sheet.csv', worksheet.replace('4711', '9').replace('4712', '4711'));
  room.collect('moodle');
  room.gradeCourse();
  const { status, stderr } = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.equal(status, 2);
  assert.match(
    stderr,
    /^grade: sheet.csv:3: participant 4711 is 'Bob OBrien' here, and 'Ada Lovelace' in this round; download the worksheet of its/,
  );
});

test('who somebody is the worksheet knows, where names are two people’s or turned round', () => {
  const room = host();
  room.handOut({
    'Ada Lovelace_4711_assignsubmission_file/one.h': '// score 10\n',
    'Ada Lovelace_4712_assignsubmission_file/one.h': '// score 4\n',
    'C. Cy_4713_assignsubmission_file/one.h': '// score 0\n',
  });
  const sheet = worksheet
    .replace("Bob O'Brien", 'Ada Lovelace')
    .replace('Cy, C.', 'C. Cy')
    .replace('Yes,-,-', 'Yes,"8 February 2020, 11:58 PM",-');
  room.write('sheet.csv', sheet);
  room.write('roster.csv', roster.replace("Bob,O'Brien", 'Ada,Lovelace').replace('bob@', 'BOB@'));
  room.collect('moodle', '--worksheet', 'sheet.csv');
  assert.match(
    room.read('to/people.csv'),
    /^folder,name,id,email\r\nAda Lovelace_4711_assignsubmission_file,Ada Lovelace,,ada@example.org\r\n/,
  );
  assert.equal(room.gradeCourse({ times: undefined, roster: 'roster.csv' }).status, 0);
  assert.deepEqual(room.points(), { 'ada@example.org': [10, 0], 'BOB@example.org': [4, 0], 'cy@example.org': [0, 0] });
  assert.match(room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1').stdout, /^3 marks/);
  assert.match(room.read('results/week-1/moodle.csv'), /^"Participant 4712","Ada Lovelace",bob@[^\n]*,4,20.00/m);
});

test('while a folder is nobody’s, nobody has a zero by it, and no mark goes out', () => {
  const room = host();
  room.handOut({ ...handedIn, 'Eve_4799_assignsubmission_file/one.h': '// score 10\n' });
  room.write('sheet.csv', worksheet);
  room.write('roster.csv', roster);
  room.collect('moodle');
  const course = { roster: 'roster.csv' };
  const { status, stdout, stderr } = room.gradeCourse(course);
  assert.equal(status, 2);
  assert.match(stdout, /^Not graded, since on no line of the roster: Eve_4799_assignsubmission_file$/m);
  assert.match(stderr, /^grade: 1 folder of nobody on the roster; [^\n]* guests = \["FOLDER"\]\n$/);
  assert.match(room.read('results/grades.csv'), /^cy@example.org,Cy C.,,,,\r?$/m);
  const back = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.equal(back.status, 2);
  assert.match(back.stderr, /^grade: no marks go out while [^\n]*'Eve_4799_assignsubmission_file'[^\n]*\n$/);
  assert.ok(!room.has('results/week-1/moodle.csv'));
  assert.equal(room.gradeCourse({ ...course, guests: ['Eve_4799_assignsubmission_file'] }).status, 0);
  assert.match(room.read('results/grades.csv'), /^cy@example.org,Cy C.,0,0,0,20\r?$/m);
  assert.match(room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1').stdout, /^3 marks/);
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

test('a worksheet in German with semicolons is filled in', () => {
  const room = host();
  room.handOut(handedIn);
  room.write(
    'sheet.csv',
    'ID;"Vollständiger Name";E-Mail-Adresse;Bewertung;"Zuletzt geändert (Abgabe)";"Feedback als Kommentar"\n' +
      'Teilnehmer/in4711;"Ada Lovelace";ada@example.org;;"Samstag, 8. Februar 2020, 23:58";\n' +
      'Teilnehmer/in4712;Bob OBrien;bob@example.org;;"Sonntag, 1. März 2020, 00:59";\n',
  );
  assert.match(room.collect('moodle', '--worksheet', 'sheet.csv').stdout, /to\/times.csv/);
  assert.equal(
    room.read('to/times.csv'),
    'student,exercise,time\r\n' +
      'Ada Lovelace_4711_assignsubmission_file,1-first/one,2020-02-08T23:58\r\n' +
      'Ada Lovelace_4711_assignsubmission_file,1-first/two,2020-02-08T23:58\r\n' +
      'Bob OBrien_4712_assignsubmission_file,1-first/one,2020-03-01T00:59\r\n',
  );
  room.gradeCourse({ times: undefined });
  room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.match(room.read('results/week-1/moodle.csv'), /^Teilnehmer\/in4711;"Ada Lovelace";ada@example.org;14;/m);
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

test('the worksheet is never written over, and what is in the way is not ours', () => {
  const room = host();
  room.handOut(handedIn);
  room.collect('moodle');
  room.gradeCourse();
  room.write('results/week-1/moodle.csv', worksheet);
  const over = room.run('hand-back', 'moodle', 'results/week-1/moodle.csv', 'results/week-1');
  assert.match(over.stderr, /is what was filled in; name the table/);
  assert.equal(over.status, 2);
  rmSync(room.path('results/week-1/moodle.csv'));
  room.write('sheet.csv', worksheet);
  symlinkSync(room.path('victim'), room.path('results/week-1/moodle.csv'));
  const link = room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1');
  assert.match(link.stderr, /'results\/week-1\/moodle.csv' is not the grader's own/);
  assert.ok(!room.has('victim'));
  writeFileSync(room.path('sheet.csv'), worksheet);
});
