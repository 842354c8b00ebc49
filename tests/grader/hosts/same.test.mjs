// The same answers by every way into a class get the same points, by the real grader and one seed:
//   node same.test.mjs GRADE LIKE_DOCKER SOURCE
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { chmodSync, existsSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { test } from 'node:test';
import { host, time } from './hosts.mjs';
import { commit } from './repository.mjs';

const [grade, likeDocker, source] = process.argv.slice(2);
const build = dirname(dirname(grade));
const exercise = '2-euler/orbit-drift';
const answer = name => readFileSync(join(source, 'exercises', exercise, name), 'utf8');
const wrong = name => readFileSync(join(build, 'exercises', exercise, 'wrong', `${name}.h`), 'utf8');
const spoilt = answer('solution.h').replace(';', '');
const inTime = '2020-02-08T22:00:00Z';
const late = '2020-02-09T12:00:00Z';

// Who handed in what, and when; nothing is a student who handed in another file.
const twelve = {
  ada: [answer('solution.h')],
  bob: [answer('right/by-component.h')],
  cy: [wrong('symplectic')],
  dan: [wrong('rounded-down')],
  eve: [answer('starter.h')],
  fay: [spoilt],
  gus: [undefined],
  hal: [answer('solution.h'), late],
  ida: [wrong('old-clock')],
  jon: [wrong('position-first')],
  kim: ['not \0 a header'],
  lea: [wrong('one-radian'), late],
};
const students = Object.entries(twelve).map(([name, [text, at]], i) => ({
  name,
  text,
  at: at ?? inTime,
  number: 4700 + i,
}));
const file = one => (one.text === undefined ? 'notes.h' : 'orbit-drift.h');
const text = one => one.text ?? '// nothing\n';

const worksheet =
  'Identifier,"Full name",Grade,"Last modified (submission)","Feedback comments"\n' +
  students
    .map(
      one =>
        `Participant ${one.number},${one.name},,"${one.at === late ? '9 February 2020, 1:00 PM' : '8 February 2020, 11:00 PM'}",\n`,
    )
    .join('');

// Each leaves the submissions in `to`, with their times; those of plain folders are told in times.csv.
const ways = {
  'plain folders': room => {
    for (const one of students) room.handOut({ [`${one.name}/2-euler/${file(one)}`]: text(one) });
    room.collect('folders');
    const rows = students.map(one => `${one.name},${exercise},${one.at}\n`);
    room.write('times.csv', `student,exercise,time\n${rows.join('')}`);
  },
  'Moodle in folders': room => {
    for (const one of students)
      room.handOut({ [`${one.name}_${one.number}_assignsubmission_file/${file(one)}`]: text(one) });
    room.write('sheet.csv', worksheet);
    room.collect('moodle', '--worksheet', 'sheet.csv');
  },
  'Moodle without folders': room => {
    for (const one of students)
      room.handOut({ [`${one.name}_${one.number}_assignsubmission_file_${file(one)}`]: text(one) });
    room.write('sheet.csv', worksheet);
    room.collect('moodle', '--worksheet', 'sheet.csv');
  },
  'Canvas': room => {
    for (const one of students)
      room.handOut({ [`${one.name}${one.at === late ? '_LATE' : ''}_${one.number}_98765_${file(one)}`]: text(one) });
    room.collect('canvas', '--until', '2020-02-08T23:59:00+01:00');
    room.write('to/times.csv', room.read('to/times.csv').replaceAll(/,\r/g, `,${late}\r`));
  },
  'git': room => {
    for (const one of students) commit(room.path(`from/${one.name}`), { [`2-euler/${file(one)}`]: text(one) }, one.at);
    room.collect('git');
  },
};

const whose = key => students.find(one => key === one.name || key.includes(String(one.number))).name;

// What the tests gave, and what counts: [earned, points] by student.
function marksBy(way) {
  const room = host(grade);
  ways[way](room);
  room.write('seed', '20\n');
  chmodSync(room.path('seed'), 0o600);
  const run = room.gradeCourse({
    times: room.has('times.csv') ? 'times.csv' : undefined,
    assignment: [
      {
        name: 'week-1',
        exercises: [exercise],
        due: time('2020-02-08T23:59:00'),
        seed_file: 'seed',
        late: { points_a_day: 3 },
      },
    ],
  });
  assert.deepEqual([run.status, run.stderr], [0, ''], way);
  return Object.fromEntries(
    room
      .marks()
      .students.map(one => [whose(one.student), [one.marks[0].earned, one.marks[0].points]])
      .sort(),
  );
}

let first;
for (const way of Object.keys(ways))
  test(`by ${way}`, () => {
    const marks = marksBy(way);
    first ??= marks;
    assert.deepEqual(Object.keys(marks).sort(), students.map(one => one.name).sort());
    assert.deepEqual(marks, first);
    assert.deepEqual([marks.ada, marks.eve, marks.hal, marks.gus[1]], [[10, 10], [0, 0], [10, 7], 0]);
    assert.ok(marks.cy[1] > 0 && marks.cy[1] < 10);
  });

test('by Gradescope', { skip: process.getuid() !== 0 && 'only root can become another user' }, () => {
  const room = host(grade);
  room.write('seed', '20\n');
  const zip = room.path('a.zip');
  const make = ['--build', build, '--exercise', exercise, '--seed-file', room.path('seed'), '--out', zip];
  assert.equal(spawnSync(join(source, 'exercises/hosts/gradescope/make.sh'), make).status, 0);
  const at = room.path('autograder');
  mkdirSync(join(at, 'source'), { recursive: true });
  assert.equal(spawnSync('cmake', ['-E', 'tar', 'xf', zip], { cwd: join(at, 'source') }).status, 0);
  for (const one of students) {
    for (const name of ['submission', 'results']) {
      rmSync(join(at, name), { recursive: true, force: true });
      mkdirSync(join(at, name));
    }
    writeFileSync(join(at, 'submission', file(one)), text(one));
    const env = { ...process.env, AUTOGRADER: at };
    const ran = spawnSync(likeDocker, ['bash', join(at, 'source/run_autograder')], { env, encoding: 'utf8' });
    assert.deepEqual([ran.status, ran.stdout], [0, ''], one.name);
    assert.equal(
      JSON.parse(readFileSync(join(at, 'results/results.json'), 'utf8')).score,
      first[one.name][0],
      one.name,
    );
  }
});
