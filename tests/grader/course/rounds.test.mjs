// Whole rounds of a course, graded by the stand-in:   node rounds.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv/dist/2020.js';
import { classOf, onTime, rows, time, usual } from './course.mjs';

const roster = 'student,name\nada,Ada Lovelace\nbob,Bob\ncy,Cy\n';
const far = time('2999-02-08T23:59:00');
const week = (n, exercises, more) => ({ name: `week-${n}`, exercises, due: time('2020-02-08T23:59:00'), ...more });

// A class with a roster.
function rostered(course, handedIn) {
  const room = classOf(usual({ roster: 'roster.csv', ...course }), handedIn);
  room.write('roster.csv', roster);
  return room;
}

test('who is on the roster has a row, also who handed in nothing, and nobody else is graded', () => {
  const room = rostered(
    { guests: ['zed'], assignment: [week(1, ['1-first/one', '1-first/two'])] },
    { 'submissions/ada/1-first/one': '// score 10', 'submissions/zed/1-first/one': '// score 10' },
  );
  const { status, stderr, stdout, graded } = room.grade();
  assert.deepEqual([status, stderr], [0, '']);
  assert.doesNotMatch(stdout, /Not graded/);
  assert.match(room.read('week-1/summary.html'), /<h1>Numerical integration, week-1<\/h1>/);
  assert.ok(!existsSync(room.path('results/week-1/grades.csv')), 'marks stand in one table');
  assert.deepEqual(graded, ['ada 1-first/one', 'ada 1-first/two']);
  assert.deepEqual(rows(room.read('grades.csv')), [
    'student,name,week-1 1-first/one,week-1 1-first/two,week-1,week-1 of',
    'ada,Ada Lovelace,10,0,10,20',
    'bob,Bob,0,0,0,20',
    'cy,Cy,0,0,0,20',
  ]);
});

test('nothing is zero before it is due, and what is there by then has its points', () => {
  const room = rostered(
    { assignment: [week(1, ['1-first/one', '1-first/two'], { due: far })] },
    { 'submissions/ada/1-first/one': '// score 4' },
  );
  assert.deepEqual(room.grade().graded, ['ada 1-first/one']);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), ['ada,Ada Lovelace,4,,4,10', 'bob,Bob,,,,', 'cy,Cy,,,,']);
});

test('an assignment that has not opened is not graded, and has no column', () => {
  const room = rostered(
    {
      assignment: [
        week(1, ['1-first/one']),
        week(2, ['2-second/three'], { opens: time('2999-02-01T08:00:00'), due: far }),
      ],
    },
    { 'submissions/ada/2-second/three': '// score 4' },
  );
  const { stdout, graded } = room.grade();
  assert.match(stdout, /^week-2 opens on 2999-02-01 08:00$/m);
  assert.deepEqual(graded, ['ada 1-first/one']);
  assert.match(rows(room.read('grades.csv'))[0], /week-1 of$/);
  assert.deepEqual(room.grade(['--round', 'week-2']).graded, ['ada 2-second/three']);
});

test('being late takes a point for each day begun, after the grace, until nothing counts', () => {
  const due = minutes => new Date(Date.parse('2020-02-08T22:59:00Z') + 60000 * minutes).toISOString();
  const room = classOf(usual({ late: { grace_minutes: 15, points_a_day: 1, days: 3 } }), {
    'submissions/a-grace/one': ['// score 10', due(15)],
    'submissions/b-late/one': ['// score 10', due(16)],
    'submissions/c-later/one': ['// score 10', due(24 * 60 + 1)],
    'submissions/d-few/one': ['// score 0', due(16)],
    'submissions/e-over/one': ['// score 10', due(3 * 24 * 60 + 1)],
  });
  assert.equal(room.grade().status, 0);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), [
    'a-grace,,10,10,10',
    'b-late,,9,9,10',
    'c-later,,8,8,10',
    'd-few,,0,0,10',
    'e-over,,0,0,10',
  ]);
  assert.deepEqual(rows(room.read('week-1/late.csv')), [
    'student,name,exercise,due,handed in,late,days begun,earned,taken,points,of',
    'b-late,,1-first/one,2020-02-08 23:59,2020-02-09 00:15,16 min,1,10,1,9,10',
    'c-later,,1-first/one,2020-02-08 23:59,2020-02-10 00:00,1 day 1 min,2,10,2,8,10',
    'd-few,,1-first/one,2020-02-08 23:59,2020-02-09 00:15,16 min,1,0,0,0,10',
    'e-over,,1-first/one,2020-02-08 23:59,2020-02-12 00:00,3 days 1 min,4,10,10,0,10',
  ]);
  const mark = room.marks('week-1').students[2].marks[0];
  assert.deepEqual([mark.earned, mark.taken, mark.points, mark.days_late], [10, 2, 8, 2]);
});

test('without a rule what is late counts in full, and is named', () => {
  const room = classOf(usual(), { 'submissions/ada/one': ['// score 10', '2020-03-08T22:00:00Z'] });
  room.grade();
  assert.equal(rows(room.read('grades.csv'))[1], 'ada,,10,10,10');
  assert.match(rows(room.read('week-1/late.csv'))[1], /^ada,,1-first\/one,.*,28 days 23 h 1 min,29,10,0,10,10$/);
});

test('an extension is for its student and its assignment alone', () => {
  const late = ['// score 10', '2020-02-10T12:00:00Z'];
  const room = rostered(
    {
      late: { points_a_day: 5 },
      assignment: [week(1, ['1-first/one']), week(2, ['1-first/two']), week(3, ['2-second/three'], { due: far })],
      extension: [
        { student: 'ada', assignment: 'week-1', due: time('2020-02-11T23:59:00') },
        { student: 'cy', assignment: 'week-2', due: far },
      ],
    },
    Object.fromEntries(
      ['ada', 'bob'].flatMap(name => ['one', 'two'].map(x => [`submissions/${name}/1-first/${x}`, late])),
    ),
  );
  assert.equal(room.grade().status, 0);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), [
    'ada,Ada Lovelace,10,10,10,0,0,10,,,',
    'bob,Bob,0,0,10,0,0,10,,,',
    'cy,Cy,0,0,10,,,,,,',
  ]);
});

test('without a roster an extension of somebody who has no folder is named', () => {
  const extension = ['ada', 'aad'].map(student => ({ student, assignment: 'week-1', due: far }));
  const { stdout } = classOf(usual({ extension }), { 'submissions/ada/one': '// score 10' }).grade();
  assert.deepEqual(stdout.match(/^An extension of nobody.*$/gm), ['An extension of nobody who has a folder: aad']);
});

test('what was never handed in is not late, whatever a table of times says of its assignment', () => {
  const room = rostered(
    { times: 'times.csv', assignment: [week(1, ['1-first/one', '1-first/two'])] },
    { 'submissions/ada/one': '// score 10' },
  );
  room.write('times.csv', 'student,assignment,time\nada,week-1,2021-01-01T00:00:00Z\n');
  room.grade();
  assert.deepEqual(
    room.marks('week-1').students[0].marks.map(mark => mark.days_late),
    [328, 0],
  );
});

test('a table of times is believed in place of the files, and what it does not say is not guessed', () => {
  const room = rostered(
    {
      times: 'times.csv',
      late: { points_a_day: 1 },
      assignment: [week(1, ['1-first/one', '1-first/two']), week(2, ['2-second/three'])],
    },
    { 'submissions/ada/one': ['// score 10', '2030-01-01T00:00:00Z'], 'submissions/ada/two': '// score 10' },
  );
  room.write('times.csv', 'student,assignment,exercise,time\nada,,1-first/one,2020-02-08T23:59:01+02:00\n');
  const { status, stderr, graded } = room.grade();
  assert.deepEqual([status, graded], [2, []]);
  assert.match(stderr, /^grade: times.csv: when did 'ada' hand in 1-first\/two\? Fill it in, [^\n]*\n$/);
  room.write(
    'times.csv',
    [
      'student,assignment,exercise,time',
      'ada,week-1,,2020-02-09 23:59',
      'ada,,1-first/one,2020-02-08T23:58:59-01:00',
      'ada,,1-first/one,2020-02-08T12:00:00',
      'ada,week-2,,2021-01-01T00:00:00Z',
      '',
    ].join('\n'),
  );
  assert.equal(room.grade().stderr, '');
  assert.deepEqual(
    room.marks('week-1').students[0].marks.map(mark => [mark.handed_in, mark.taken]),
    [
      ['2020-02-09 01:58:59', 1],
      ['2020-02-09 23:59', 1],
    ],
  );
});

for (const [what, line, says] of [
  ['no time', 'ada,week-1,yesterday', /^grade: times\.csv:2: 'yesterday' is no time; write it as /],
  [
    'a time that is none',
    'ada,week-1,2020-03-29T02:30',
    /times\.csv:2: there is no 2020-03-29 02:30 in Europe\/Berlin/,
  ],
  ['nobody', ',week-1,2020-02-08T12:00', /times\.csv:2: whose time is this/],
  [
    'what is not in the course',
    'ada,week-1,2020-02-08T12:00\nada,wek-1,2020-02-08T12:00',
    /times\.csv:3: there is no exercise and no assignment 'wek-1'; did you mean 'week-1'\?/,
  ],
]) {
  test(`a table of times with ${what} is refused with its line`, () => {
    const room = rostered({ times: 'times.csv' }, { 'submissions/ada/one': '// score 10' });
    room.write('times.csv', `student,assignment,time\n${line}\n`);
    const { status, stderr } = room.grade();
    assert.equal(status, 2);
    assert.match(stderr, says);
  });
}

test('one round graded again leaves all others as they are', () => {
  const room = rostered(
    {
      assignment: [
        week(1, ['1-first/one'], { seed_file: 'one' }),
        week(2, ['1-first/one', '1-first/two'], { seed_file: 'two' }),
      ],
    },
    { 'submissions/ada/1-first/one': '// score 10', 'submissions/bob/1-first/two': '// score 4' },
  );
  for (const [name, seed] of Object.entries({ one: 7, two: 8 }))
    writeFileSync(room.path(name), `${seed}\n`, { mode: 0o600 });
  assert.equal(room.grade().stderr, '');
  const report = n => JSON.parse(room.read(`week-${n}/ada/1-first/one/report.json`));
  assert.deepEqual([report(1).seed, report(2).seed], ['7', '8']);
  const before = room.read('week-1/marks.json');
  room.handIn('submissions/ada/1-first/one', '// score 4', '2020-02-20T00:00:00Z');
  rmSync(room.path('submissions/bob'), { recursive: true });
  const { graded } = room.grade(['--round', 'week-2'], { STAND_IN_VERSION: 'new' });
  assert.deepEqual(graded, ['ada 1-first/one', 'ada 1-first/two']);
  assert.equal(room.read('week-1/marks.json'), before);
  assert.deepEqual(rows(room.read('grades.csv')), [
    'student,name,week-1 1-first/one,week-1,week-1 of,week-2 1-first/one,week-2 1-first/two,week-2,week-2 of',
    'ada,Ada Lovelace,10,10,10,4,0,4,20',
    'bob,Bob,0,0,10,0,0,0,20',
    'cy,Cy,0,0,10,0,0,0,20',
  ]);
});

test('graded again, only what changed is graded', () => {
  const room = rostered({}, { 'submissions/ada/one': '// score 10', 'submissions/bob/one': '// score 4' });
  assert.equal(room.grade().graded.length, 2);
  assert.equal(room.grade().graded.length, 0);
  room.handIn('submissions/bob/one', '// score 10');
  assert.deepEqual(room.grade().graded, ['bob 1-first/one']);
  assert.equal(rows(room.read('grades.csv'))[2], 'bob,Bob,10,10,10');
});

test('who has left keeps the row, behind those of the roster', () => {
  const room = rostered(
    { guests: ['ada'], assignment: [week(1, ['1-first/one']), week(2, ['1-first/two'])] },
    { 'submissions/ada/one': '// score 10' },
  );
  room.grade();
  room.write('roster.csv', 'student\ncy\ndee\n');
  room.grade(['--round', 'week-2']);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), [
    'cy,,0,0,10,0,0,10',
    'dee,,,,,0,0,10',
    'ada,Ada Lovelace,10,10,10,,,',
    'bob,Bob,0,0,10,,,',
  ]);
});

test('each assignment may have a folder of its own, and one that is not there yet is passed over', () => {
  const room = rostered({
    assignment: [
      week(1, ['1-first/one'], { submissions: 'collected/week-1' }),
      week(2, ['1-first/one'], { submissions: 'collected/week-2', due: far }),
    ],
  });
  room.handIn('collected/week-1/ada/one', '// score 4');
  const { status, stdout } = room.grade();
  assert.equal(status, 0);
  assert.match(stdout, /^week-2: nothing is collected yet, since there is no folder 'collected\/week-2'$/m);
  assert.match(rows(room.read('grades.csv'))[0], /week-1 of$/);
  const named = room.grade(['--round', 'week-2']);
  assert.equal(named.status, 3);
  assert.match(named.stderr, /^grade: week-2: can't read the folder 'collected\/week-2': [^\n]*\n$/);
});

test("folders as Moodle calls them are matched by the students' names", () => {
  const room = classOf(usual({ roster: 'participants.csv' }), {
    'submissions/Ada Lovelace_4711_assignsubmission_file/one': '// score 10',
    'submissions/Bob_12_assignsubmission_file_/one': '// score 4',
  });
  room.write(
    'participants.csv',
    '\ufeff"First name","Last name","Email address"\r\nAda,Lovelace,ada@example.org\r\nBob,,bob@example.org\r\n',
  );
  assert.equal(room.grade().stderr, '');
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), [
    'ada@example.org,Ada Lovelace,10,10,10',
    'bob@example.org,Bob,4,4,10',
  ]);
});

test('a submission on which the grader fails has no mark, and is tried again', () => {
  for (const [fate, code] of [
    ['again', 75],
    ['fails', 42],
  ]) {
    const room = rostered({}, { 'submissions/ada/one': `// ${fate}`, 'submissions/bob/one': '// score 4' });
    assert.equal(room.grade().status, code);
    assert.deepEqual(rows(room.read('grades.csv')).slice(1, 3), ['ada,Ada Lovelace,,,', 'bob,Bob,4,4,10']);
    room.handIn('submissions/ada/one', '// score 10');
    assert.equal(room.grade().status, 0);
    assert.equal(rows(room.read('grades.csv'))[1], 'ada,Ada Lovelace,10,10,10');
  }
});

test('a mark of an older text does not stand for a newer one that could not be graded', () => {
  const room = rostered({}, { 'submissions/ada/one': '// score 10', 'submissions/bob/one': '// score 4' });
  room.grade();
  room.handIn('submissions/ada/one', '// score 4');
  assert.equal(room.grade([], { STAND_IN_UNSAFE: '1' }).status, 42);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1, 3), ['ada,Ada Lovelace,,,', 'bob,Bob,4,4,10']);
});

test('names of students do no harm', () => {
  const names = [
    'new\nline',
    '-rf',
    '=1+1',
    '"q"',
    'a,b',
    '<i>',
    '##[x]',
    ' ',
    '..x',
    'n'.repeat(255),
    '../..',
    '\u202e',
  ];
  const folders = names.filter(name => !name.includes('/') && !name.startsWith('.'));
  const room = classOf(usual(), Object.fromEntries(folders.map(name => [`submissions/${name}/one`, '// score 10'])));
  const latin = Buffer.concat([Buffer.from(`${room.path('submissions')}/`), Buffer.from([0xff, 0xfe])]);
  renameSync(room.path('submissions/-rf'), latin);
  const { status, stdout, stderr } = room.grade();
  assert.deepEqual([status, stderr], [0, '']);
  const lines = rows(room.read('grades.csv'));
  assert.equal(lines.length, folders.length + 1);
  for (const line of ["'=1+1,,10,10,10", 'new\\x0aline,,10,10,10', '\\xff\\xfe,,10,10,10', '"a,b",,10,10,10'])
    assert.ok(lines.includes(line), line);
  assert.doesNotMatch(stdout + room.read('grades.csv'), /##\[|\u202e/);
});

test('a key that is a path leads nowhere', () => {
  const room = classOf(usual({ roster: 'roster.csv' }), { 'submissions/ada/one': '// score 10' });
  room.write('roster.csv', 'student\n../..\n/etc\nada\n');
  assert.equal(room.grade().status, 0);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), ['../..,,0,0,10', '/etc,,0,0,10', 'ada,,10,10,10']);
});

test('links are not followed: not as a folder, not as a file, not in the results', () => {
  const room = rostered({}, { 'submissions/ada/one': '// score 10', 'elsewhere/one': '// score 10' });
  symlinkSync(room.path('elsewhere'), room.path('submissions/bob'));
  mkdirSync(room.path('submissions/cy'));
  symlinkSync(room.path('elsewhere/one.h'), room.path('submissions/cy/one.h'));
  assert.equal(room.grade().status, 0);
  assert.deepEqual(rows(room.read('grades.csv')).slice(1), [
    'ada,Ada Lovelace,10,10,10',
    'bob,Bob,0,0,10',
    'cy,Cy,0,0,10',
  ]);
  assert.match(room.read('week-1/late.csv'), /^cy,Cy,1-first\/one,/m); // by the link's own time
  for (const name of [
    'grades.csv',
    ...['marks.json', 'late.csv', 'equal.csv', 'pages.zip'].map(name => `week-1/${name}`),
  ]) {
    const kept = room.read(name);
    rmSync(room.path(`results/${name}`));
    symlinkSync(room.path('roster.csv'), room.path(`results/${name}`));
    const { status, stderr } = room.grade();
    assert.equal(status, 2, name);
    assert.match(stderr, /^grade: [^\n]*not the grader's own[^\n]*\n$/);
    rmSync(room.path(`results/${name}`));
    room.write(`results/${name}`, kept);
  }
});

test("a table of yours, or a class's, is not lost", () => {
  for (const table of ['grades.csv', 'summary.html']) {
    const room = rostered({}, { 'submissions/ada/one': '// score 10' });
    room.write(`results/${table}`, 'of last year');
    const { status, stderr } = room.grade();
    assert.equal(status, 2);
    assert.match(stderr, new RegExp(`'results' holds a ${table} that is of no course; name another folder`));
    assert.equal(room.read(table), 'of last year');
  }
});

test('equal work is listed for a look, but not what is right, or the starter, and on no page', () => {
  const own = '// score 4\n// got 0.12345678901234567';
  const room = rostered(
    {},
    {
      'submissions/ada/one': `${own}\n// my own words`,
      'submissions/bob/one': `${own}\n// and mine`,
      'submissions/cy/one': '// score 4\n// got 0.12345678901234568',
    },
  );
  const { status, stderr, stdout } = room.grade();
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(stdout, /^Equal work in 1 place, to look at: see results\/week-1\/equal\.csv$/m);
  const head = 'exercise,equal,how many,students,where';
  assert.deepEqual(rows(room.read('week-1/equal.csv')), [
    head,
    '1-first/one,wrong numbers,2,"ada; bob",the second test',
  ]);
  assert.doesNotMatch(room.read('week-1/pages/ada.html'), /bob|equal/i);
  room.handIn('submissions/cy/one', `${own}\n// and mine`);
  room.grade();
  assert.deepEqual(rows(room.read('week-1/equal.csv')).slice(1), [
    '1-first/one,file,2,"bob; cy",PARTIAL',
    '1-first/one,wrong numbers,3,"ada; bob; cy",the second test',
  ]);
  room.write('exercises/1-first/one/starter.h', own);
  const exercises = { STAND_IN_EXERCISES: room.path('exercises') };
  const broken = room.grade([], { ...exercises, STAND_IN_BROKEN: '1-first/one' });
  assert.match(broken.stderr, /^grade: equal numbers are not listed, since the grader gives its own solution/);
  assert.deepEqual(rows(room.read('week-1/equal.csv')).slice(1), ['1-first/one,file,2,"bob; cy",PARTIAL']);
  assert.deepEqual(room.grade([], exercises).graded, ['starter.h 1-first/one']);
  assert.deepEqual(rows(room.read('week-1/equal.csv')).slice(1), ['1-first/one,file,2,"bob; cy",PARTIAL']);
  assert.deepEqual(room.grade([], exercises).graded, []);
  for (const name of ['ada', 'bob', 'cy']) room.write(`submissions/${name}/one.h`, own.replaceAll('\n', '\r\n'));
  room.grade([], exercises);
  assert.deepEqual(rows(room.read('week-1/equal.csv')), [head]);
});

test('marks.json is what its schema says, whatever became of a submission', () => {
  const schema = JSON.parse(
    readFileSync(fileURLToPath(new URL('../../../exercises/grader/course/marks.schema.json', import.meta.url)), 'utf8'),
  );
  const isMarks = new Ajv({ allErrors: true, allowUnionTypes: true }).compile(schema);
  const room = rostered(
    { late: { points_a_day: 1 }, assignment: [week(1, ['1-first/one', '1-first/two'])] },
    {
      'submissions/ada/one': ['// score 10', '2020-02-10T12:00:00Z'],
      'submissions/ada/two': '// fails',
      'submissions/bob/two': 'no such thing',
    },
  );
  room.grade();
  const marks = room.marks('week-1');
  assert.ok(isMarks(marks), JSON.stringify(isMarks.errors));
  for (const spoil of [
    one => delete one.students[0].marks[0].points,
    one => (one.students[0].marks[0].verdict = 'FINE'),
    one => (one.students[0].extra = 1),
    one => (one.students[0].marks[1].points = 1.5),
  ]) {
    const spoilt = structuredClone(marks);
    spoil(spoilt);
    assert.ok(!isMarks(spoilt), `${spoil}`);
  }
});

test('marks are for nobody else to read', () => {
  const room = rostered({}, { 'submissions/ada/one': '// score 10' });
  room.grade();
  for (const file of [
    'grades.csv',
    'week-1/marks.json',
    'week-1/late.csv',
    'week-1/equal.csv',
    'week-1/pages.zip',
    'week-1/pages/ada.html',
  ])
    assert.equal(statSync(room.path(`results/${file}`)).mode & 0o077, 0, file);
});

test('two graders do not work on one course', () => {
  const room = rostered({}, { 'submissions/ada/one': '// score 10' });
  room.grade();
  const held = ['flock', '-x', room.path('results/.lock'), process.argv[2], 'class', room.path('course.toml')];
  let status = 0;
  try {
    execFileSync(held[0], held.slice(1), { stdio: 'pipe' });
  } catch (error) {
    status = error.status;
    assert.match(`${error.stderr}`, /another grader is at work in '.*results'; wait for it/);
  }
  assert.equal(status, 75);
});

test('parts of a round are the whole, and a last run without them writes marks and tables', () => {
  const handedIn = {
    'submissions/ada/one': '// score 10',
    'submissions/bob/one': '// score 4',
    'submissions/cy/one': '// score 0',
  };
  const room = rostered({}, handedIn);
  const parts = [1, 2].map(i => room.grade(['--shard', `${i}/2`]));
  assert.deepEqual(
    parts.map(({ graded }) => graded.length),
    [2, 1],
  );
  for (const name of ['grades.csv', 'week-1/marks.json', 'week-1/pages.zip'])
    assert.ok(!existsSync(room.path(`results/${name}`)), name);
  assert.deepEqual(room.grade().graded, []);
  const whole = rostered({}, handedIn);
  whole.grade();
  assert.equal(room.read('grades.csv'), whole.read('grades.csv'));
});

test('120 students with four exercises take no two seconds beyond the grading', () => {
  const exercises = ['1-first/one', '1-first/two', '2-second/three'];
  const names = Array.from({ length: 120 }, (_, n) => `s${n}`);
  const room = classOf(
    usual({ roster: 'roster.csv', assignment: [week(1, exercises)] }),
    Object.fromEntries(names.flatMap(name => exercises.map(one => [`submissions/${name}/${one}`, '// score 4']))),
  );
  room.write('roster.csv', 'student\ns0\n');
  assert.equal(room.grade().graded.length, 3);
  for (const name of names.slice(1))
    cpSync(room.path('results/week-1/s0'), room.path(`results/week-1/${name}`), { recursive: true });
  room.write('roster.csv', `student\n${names.join('\n')}\n`);
  const begin = process.hrtime.bigint();
  const { graded, status } = room.grade();
  const seconds = Number(process.hrtime.bigint() - begin) / 1e9;
  assert.deepEqual([graded, status], [[], 0]);
  assert.ok(seconds < 2, `${seconds} s`);
});
