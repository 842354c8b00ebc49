// What is wrong in the file of a course, and in what it names:   node file.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import Ajv from 'ajv/dist/2020.js';
import { classOf, courseFile, time, usual } from './course.mjs';

const schema = JSON.parse(
  readFileSync(fileURLToPath(new URL('../../../exercises/grader/course/course.schema.json', import.meta.url)), 'utf8'),
);
const accepted = new Ajv({ allErrors: true, allowUnionTypes: true }).compile(schema);

const week = more => ({ name: 'week-1', exercises: ['1-first/one'], due: time('2020-02-08T23:59:00'), ...more });
const extension = more => ({ student: 'ada', assignment: 'week-1', due: time('2020-02-11T23:59:00'), ...more });
const without = (course, key) => Object.fromEntries(Object.entries(course).filter(([name]) => name !== key));

function roomOf(course) {
  const room = classOf(course, { 'submissions/ada/one': '// score 10' });
  room.write('roster.csv', 'student,Number\nada,1\n');
  room.write('times.csv', 'student,assignment,time\nada,week-1,2020-02-08T12:00:00Z\n');
  room.write('seed', '7\n');
  return room;
}

const bySchema = course => accepted(JSON.parse(JSON.stringify(course)));

// Every key is here, in every form.
const whole = {
  ...usual({
    roster: { file: 'roster.csv', key: 'student' },
    guests: ['Eve_4711_assignsubmission_file'],
    times: 'times.csv',
    show_seed: false,
    late: { grace_minutes: 15, points_a_day: 1, days: 3 },
    assignment: [
      week({
        opens: time('2020-02-01T08:00:00Z'),
        seed_file: 'seed',
        submissions: 'submissions',
        late: { points_a_day: 2 },
      }),
    ],
    extension: [extension()],
  }),
};

for (const [what, course] of [
  ['as it is usual', usual()],
  ['with every key', whole],
  ['with a roster by its file alone', { ...whole, roster: 'roster.csv' }],
  ['with the times of the files', { ...whole, times: 'files' }],
  ['with a late rule of nothing', usual({ late: {} })],
  ['with one exercise in two assignments', usual({ assignment: [week(), week({ name: 'again' })] })],
  ['with times that have an offset', usual({ assignment: [week({ due: time('2020-02-08T23:59:00+01:00') })] })],
  ['with a time that comes twice', usual({ assignment: [week({ due: time('2020-10-25T02:30:00') })] })],
]) {
  test(`a course ${what} is taken, and its schema says so`, () => {
    assert.ok(bySchema(course), JSON.stringify(accepted.errors));
    const { status, stderr } = roomOf(course).grade();
    assert.deepEqual([status, stderr.replace(/.*others can read the seed.*\n/, '')], [0, '']);
  });
}

test('the test of every key has every key of the schema', () => {
  const keys = part => Object.keys(part.properties).sort();
  const has = value => Object.keys(value).sort();
  const { assignment, extension, late, roster } = schema.$defs;
  assert.deepEqual(has(whole), keys(schema));
  assert.deepEqual(has(whole.assignment[0]), keys(assignment));
  assert.deepEqual(has(whole.extension[0]), keys(extension));
  assert.deepEqual(has(whole.late), keys(late));
  assert.deepEqual(has(whole.roster), keys(roster));
});

// By `schema: false`: the schema can't know it.
function refuses(what, course, says, { schema: known = true } = {}) {
  test(`a course ${what} is refused in one line`, () => {
    const { status, stderr, stdout, graded } = roomOf(course).grade();
    assert.match(stderr, /^grade: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.deepEqual([status, graded, stdout], [2, [], '']);
    assert.equal(bySchema(course), !known);
  });
}

for (const [key, table] of [
  ['name', course => course],
  ['time_zone', course => course],
  ['results', course => course],
]) {
  refuses(`without ${key}`, without(table(usual()), key), new RegExp(`course\\.toml:\\d+:\\d+: '${key}' is missing`));
}
refuses(
  'without an assignment',
  without(usual(), 'assignment'),
  /no assignment stands here; begin one with a line \[\[assignment\]\]/,
);
refuses(
  'with no key of that name',
  usual({ rooster: 'roster.csv' }),
  /course\.toml:\d+:1: there is no key 'rooster'; did you mean 'roster'\?/,
);
refuses(
  'with a key like no other',
  usual({ weights: 'yes' }),
  /there is no key 'weights' here; known are name, time_zone, /,
);
refuses(
  'with an unknown key of an assignment',
  usual({ assignment: [week({ dues: 'x' })] }),
  /:\d+:1: there is no key 'dues'; did you mean 'due'\?/,
);
refuses(
  'with an unknown key of the late rule',
  usual({ late: { points_per_day: 1 } }),
  /there is no key 'points_per_day'/,
);
refuses(
  'with an unknown key of an extension',
  usual({ extension: [extension({ until: 'x' })] }),
  /there is no key 'until'/,
);
refuses(
  'with an unknown key of the roster',
  usual({ roster: { file: 'roster.csv', keys: 'x' } }),
  /no key 'keys'; did you mean 'key'/,
);
for (const key of ['name', 'time_zone', 'submissions', 'results', 'times'])
  for (const value of [1, true, ['x'], ''])
    refuses(
      `whose ${key} is ${JSON.stringify(value)}`,
      usual({ [key]: value }),
      new RegExp(`:\\d+:\\d+: '${key}' must be one line of text in quotes`),
    );
refuses('whose roster is a number', usual({ roster: 1 }), /'roster' must be one line of text in quotes/);
refuses('whose show_seed is text', usual({ show_seed: 'yes' }), /'show_seed' must be true or false, without quotes/);
refuses('whose late rule is a number', usual({ late: 1 }), /'late' must be a table: late = { ... }/);
for (const [key, value] of [
  ['grace_minutes', -1],
  ['grace_minutes', 1441],
  ['points_a_day', 1.5],
  ['points_a_day', '1'],
  ['days', -1],
  ['days', 367],
])
  refuses(
    `with ${key} ${JSON.stringify(value)}`,
    usual({ late: { [key]: value } }),
    new RegExp(`'${key}' must be a whole number from 0 to \\d+`),
  );
refuses(
  'whose assignment is no table',
  usual({ assignment: 'week-1' }),
  /'assignment' must be written as \[\[assignment\]\]/,
);
for (const key of ['name', 'exercises', 'due'])
  refuses(
    `with an assignment without ${key}`,
    usual({ assignment: [without(week(), key)] }),
    new RegExp(`course\\.toml:6:1: '${key}' is missing here`),
  );
for (const name of ['a/b', '../x', '.x', '-x', 'week 1', 'ü', 'n'.repeat(101), 'grades.csv'])
  refuses(
    `with an assignment called ${name}`,
    usual({ assignment: [week({ name })] }),
    /:7:8: (an assignment's name becomes a folder|a table is called)/,
  );
refuses(
  'with two assignments of one name',
  usual({ assignment: [week(), week()] }),
  /'week-1' is another assignment's name already; take another/,
  { schema: false },
);
refuses(
  'whose exercises are no list',
  usual({ assignment: [week({ exercises: '1-first/one' })] }),
  /'exercises' must be a list/,
);
refuses('whose exercises are none', usual({ assignment: [week({ exercises: [] })] }), /'exercises' must be a list/);
refuses(
  'whose exercises are numbers',
  usual({ assignment: [week({ exercises: [1] })] }),
  /'exercises' must hold texts in quotes/,
);
refuses(
  'with an exercise that there is not',
  usual({ assignment: [week({ exercises: ['1-first/onee'] })] }),
  /course\.toml:8:\d+: there is no exercise '1-first\/onee'; did you mean '1-first\/one'\?/,
  { schema: false },
);
refuses(
  'with an exercise twice',
  usual({ assignment: [week({ exercises: ['1-first/one', '1-first/one'] })] }),
  /'1-first\/one' stands here twice/,
);
refuses(
  'with a due in quotes',
  usual({ assignment: [week({ due: '2020-02-08T23:59:00 ' })] }),
  /'due' must be a time without quotes, such as 2027/,
);
refuses(
  'with a due that is a day',
  usual({ assignment: [week({ due: time('2020-02-08') })] }),
  /'due' is a day; write the time of the day too, such as T23:59:00/,
);
refuses(
  'that is due before it opens',
  usual({ assignment: [week({ opens: time('2020-02-09T08:00:00') })] }),
  /:9:7: this is due before it opens, on 2020-02-09 08:00; name a later time/,
  { schema: false },
);
refuses(
  'with a time that there is not',
  usual({ assignment: [week({ due: time('2020-03-29T02:30:00') })] }),
  /there is no 2020-03-29 02:30 in Europe\/Berlin, since the clocks are put forward/,
  { schema: false },
);
refuses('without submissions', without(usual(), 'submissions'), /where are this assignment's submissions\?/, {
  schema: false,
});
refuses(
  'whose results lie within the submissions',
  usual({ results: 'submissions/results' }),
  /'results' lies within these submissions/,
  { schema: false },
);
refuses(
  'in a time zone that there is not',
  usual({ time_zone: 'Europe/Berln' }),
  /course\.toml:2:13: there is no time zone 'Europe\/Berln'; did you mean 'Europe\/Berlin'\?/,
  { schema: false },
);
refuses(
  'whose seed file is not there',
  usual({ assignment: [week({ seed_file: 'none' })] }),
  /can't read the seed file 'none'; make one by/,
  { schema: false },
);
refuses('whose roster is not there', usual({ roster: 'none.csv' }), /there is no table 'none\.csv'/, { schema: false });
refuses(
  'whose roster lacks the key',
  usual({ roster: { file: 'roster.csv', key: 'Numbre' } }),
  /roster\.csv:1: there is no column 'Numbre'; did you mean 'Number'\?/,
  { schema: false },
);
refuses('whose times are not there', usual({ times: 'none.csv' }), /there is no table 'none\.csv'/, { schema: false });
refuses(
  'with an extension of no assignment',
  usual({ extension: [extension({ assignment: 'week-2' })] }),
  /there is no assignment 'week-2'; did you mean 'week-1'\?/,
  { schema: false },
);
refuses(
  'with an extension that is none',
  usual({ extension: [extension({ due: time('2020-02-08T23:59:00') })] }),
  /this is no extension, since all have until 2020-02-08 23:59/,
  { schema: false },
);
refuses(
  'with two extensions of one student',
  usual({ extension: [extension(), extension()] }),
  /'ada' has an extension of week-1 already/,
  { schema: false },
);
refuses(
  'with an extension of nobody',
  usual({ roster: 'roster.csv', extension: [extension({ student: 'adda' })] }),
  /course\.toml:\d+:1: 'adda' is not on the roster; did you mean 'ada'\?/,
  { schema: false },
);

test('what is no TOML is refused with its place, and so is no file', () => {
  const room = roomOf(usual());
  for (const [text, says] of [
    ['name = "a"\nname = "b"\n', /^grade: course\.toml:2:\d+: this is no TOML: [^\n]+\n$/],
    ['name = a\n', /^grade: course\.toml:1:\d+: this is no TOML: [^\n]+\n$/],
    ['\u0000', /^grade: course\.toml:1:\d+: this is no TOML: [^\n]+\n$/],
    [`a = ${'['.repeat(100000)}`, /^grade: course\.toml:1:\d+: this is no TOML: [^\n]+\n$/],
    ['', /^grade: course\.toml:\d+:\d+: 'name' is missing here/],
  ]) {
    room.write('course.toml', text);
    const { status, stderr } = room.grade();
    assert.match(stderr, says);
    assert.equal(status, 2);
  }
});

test('a mark that editors begin a file with does not matter', () => {
  const room = roomOf(usual());
  room.write('course.toml', `\ufeff${courseFile(usual())}`.replace(/\n/g, '\r\n'));
  assert.equal(room.grade().stderr, '');
});

test('paths are seen from the file of the course', () => {
  const room = roomOf(usual());
  const { status, stderr } = room.grade([], {});
  assert.deepEqual([status, stderr], [0, '']);
});

test('a command line that makes no sense of a course is refused', () => {
  const room = roomOf(usual());
  for (const [words, says] of [
    [['--round', 'week-2'], /course\.toml: there is no assignment 'week-2'; did you mean 'week-1'\?/],
    [['--out', 'x'], /its file names them/],
    [['--class', 'x'], /requires/],
    [['--class', 'x', '--out', 'x'], /its file names them/],
    [['--seed', '1'], /its file names them/],
    [['--seed-file', 'seed'], /no seed; its file names them/],
    [['1-first/one'], /grade class takes no EXERCISE/],
    [['--sandbox', 'none'], /sandbox only/],
    [['--exit-status', 'verdict'], /for one submission/],
    [['--round', ''], /--round needs a value/],
  ]) {
    const { status, stderr, graded } = room.grade(words);
    assert.match(stderr, /^grade: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.deepEqual([status, graded], [2, []]);
  }
  const { stderr } = room.grade(['class', 'none.toml']);
  assert.match(stderr, /^grade: [^\n]+\n$/);
});
