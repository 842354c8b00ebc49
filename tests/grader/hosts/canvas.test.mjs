// Canvas, there and back, from files named as its sources name them:   node canvas.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { host } from './hosts.mjs';

const handedIn = {
  'lovelaceada_4711_98765_one.h': '// score 10\n',
  'lovelaceada_4711_98766_two.h': '// score 4\n',
  'agent_LATE_12_98767_one-2.h': '// score 4\n',
  'anon_x1Y2z_98768_one.h': '// score 0\n',
  'LATE_anon_a1B2c_98769_one.h': '// score 0\n',
  'ä_ß_77_98770_one.h': '// score 10\n',
};
const gradebook =
  '\ufeffStudent,ID,SIS Login ID,Section,week 1 (123),week 2 (124),Final Score\n' +
  ',,,,Manual Posting,,\n' +
  '    Points Possible,,,,20.00,20.00,(read only)\n' +
  '"Lovelace, Ada",4711,ada,"A and B",,3.00,\n' +
  '"Agent, 7",12,agent,A,,"N/A",\n' +
  '"Student, Test",99,test,A,,,\n';

test('files are taken by the number of their student, and who is late is said', () => {
  const room = host();
  room.handOut(handedIn);
  const { status, stdout, stderr } = room.collect('canvas');
  assert.deepEqual([status, stderr], [0, '']);
  assert.match(
    stdout,
    /^Note: 12: one-2.h is taken for one.h\nLate: 12\nLate: anon_a1B2c\nto\/times.csv: fill in the times of 6 files\n/,
  );
  assert.match(stdout, /\n6 files of 5 students, in to\n$/);
  assert.deepEqual(
    room.files(),
    ['12/one.h', '4711/one.h', '4711/two.h', '77/one.h', 'anon_a1B2c/one.h', 'anon_x1Y2z/one.h'].map(x => `to/${x}`),
  );
});

test('a name that could be two students is nobody’s', () => {
  const room = host();
  room.handOut({
    'eve_42_99_4711_5_one.h': '// score 10\n',
    'eve_42_99_x_4711_5_one.h': '// score 10\n',
    'agent_7_42_99_one.h': '// score 10\n',
    'eve_one.h': '',
    'eve_42_one.h': '',
    'bob_43_99_5_one.h': '// score 10\n',
    'cy_44_100_one.h': '// score 10\n',
  });
  const { stdout } = room.collect('canvas');
  assert.equal(stdout.match(/^Not taken: [^\n]* it could be another student's; /gm).length, 4);
  assert.equal(stdout.match(/^Not taken: [^\n]* it is not called as Canvas calls/gm).length, 2);
  assert.deepEqual(room.files(), ['to/44/one.h']);
});

test('whoever was in time is so by the end, and the late ones’ times are asked for', () => {
  const room = host();
  room.handOut(handedIn);
  const { stdout } = room.collect('canvas', '--until', '2020-02-08T23:59:00+01:00');
  assert.match(stdout, /^to\/times.csv: fill in the times of 2 files$/m);
  assert.match(room.read('to/times.csv'), /^4711,1-first\/one,2020-02-08T22:59Z\r$/m);
  assert.match(room.read('to/times.csv'), /^12,1-first\/one,\r$/m);
  const asked = room.gradeCourse({ times: undefined });
  assert.equal(asked.status, 2);
  assert.match(asked.stderr, /^grade: to\/times.csv: when did '12' hand in 1-first\/one\? Fill it in/);
  fillIn(room);
  assert.equal(room.gradeCourse({ times: undefined, late: { points_a_day: 1 } }).status, 0);
  assert.deepEqual(room.points()['12'], [3, 0]);
  assert.deepEqual(room.points()['4711'], [10, 4]);
});

const fillIn = room =>
  room.write('to/times.csv', room.read('to/times.csv').replaceAll(/one,\r/g, 'one,2020-02-09T00:59\r'));

test('what was filled in stays when all is collected again, unless another file has come', () => {
  const room = host();
  room.handOut(handedIn);
  room.collect('canvas', '--until', '2020-02-08T23:59:00+01:00');
  fillIn(room);
  room.handOut({ 'LATE_anon_a1B2c_98769_one.h': '// score 4\n' });
  const { stdout } = room.collect('canvas', '--until', '2020-02-08T23:59:00+01:00');
  assert.match(stdout, /^to\/times.csv: fill in the times of 1 file$/m);
  assert.match(room.read('to/times.csv'), /^12,1-first\/one,2020-02-09T00:59\r$/m);
  assert.match(room.read('to/times.csv'), /^anon_a1B2c,1-first\/one,\r$/m);
});

test('a time that is not known stops nobody else, where its student takes no part', () => {
  const room = host();
  room.handOut(handedIn);
  room.collect('canvas', '--until', '2020-02-08T23:59:00+01:00');
  room.write('roster.csv', 'student\n4711\n');
  const guests = ['12', '77', 'anon_a1B2c', 'anon_x1Y2z'];
  assert.equal(room.gradeCourse({ times: undefined, roster: 'roster.csv', guests }).status, 0);
  assert.deepEqual(room.points(), { 4711: [10, 4] });
});

test('the gradebook is filled in, in one column and nowhere else', () => {
  const room = host();
  room.handOut(handedIn);
  room.write('book.csv', gradebook);
  room.collect('canvas');
  room.gradeCourse({ roster: 'book.csv', guests: ['77', 'anon_a1B2c', 'anon_x1Y2z'] });
  const { status, stdout, stderr } = room.run(
    'hand-back',
    'canvas',
    'book.csv',
    'results/week-1',
    '--column',
    'week 1 (123)',
  );
  assert.deepEqual([status, stderr], [0, '']);
  assert.equal(stdout, '3 marks of week-1 filled in: results/week-1/canvas.csv\n');
  const filled = gradebook
    .replace('"A and B",,3', '"A and B",14,3')
    .replace('agent,A,,', 'agent,A,4,')
    .replace('test,A,,', 'test,A,0,');
  assert.equal(room.read('results/week-1/canvas.csv'), filled);
});

test('a column out of another sum than the round is not filled in', () => {
  const room = host();
  room.handOut(handedIn);
  room.write('book.csv', gradebook.replace('20.00', '100.00'));
  room.collect('canvas');
  room.gradeCourse({ roster: 'book.csv', guests: ['77', 'anon_a1B2c', 'anon_x1Y2z'] });
  const words = ['hand-back', 'canvas', 'book.csv', 'results/week-1', '--column', 'week 1 (123)'];
  const { status, stderr } = room.run(...words);
  assert.equal(status, 2);
  assert.match(
    stderr,
    /^grade: book.csv:3: the assignment is out of 100.00 there, and this round out of 20; set it to 20 /,
  );
  assert.ok(!room.has('results/week-1/canvas.csv'));
});

test('a key of one’s own is found in the other columns that name a student', () => {
  const room = host();
  room.handOut({ 'ada/one.h': '// score 10\n' });
  room.write('book.csv', gradebook);
  room.collect('folders');
  room.gradeCourse();
  room.run('hand-back', 'canvas', 'book.csv', 'results/week-1', '--column', 'week 2 (124)');
  assert.match(room.read('results/week-1/canvas.csv'), /^"Lovelace, Ada",4711,ada,"A and B",,10,$/m);
});

for (const [says, table, ...words] of [
  [/there is no column 'week 1'; did you mean 'week 1 \(123\)'\?/, gradebook, '--column', 'week 1'],
  [/has a column ID; export it there/, 'Student,Nummer\n', '--column', 'x'],
  [/name the assignment's column/, gradebook],
])
  test(`refuses ${words.join(' ')}: ${says}`, () => {
    const room = host();
    room.handOut({ 'ada/one.h': '// score 10\n' });
    room.write('book.csv', table);
    room.collect('folders');
    room.gradeCourse();
    const { status, stderr } = room.run('hand-back', 'canvas', 'book.csv', 'results/week-1', ...words);
    assert.match(stderr, /^grade: [^\n]+\n$/);
    assert.match(stderr, says);
    assert.equal(status, 2);
    assert.ok(!room.has('results/week-1/canvas.csv'));
  });

for (const [says, ...words] of [
  [/--until takes a time with its offset/, '--until', '2020-02-08T23:59:00'],
  [/--worksheet is Moodle's/, '--worksheet', 'x.csv'],
])
  test(`refuses ${words.join(' ')}: ${says}`, () => {
    const room = host();
    room.handOut(handedIn);
    const { status, stderr } = room.collect('canvas', ...words);
    assert.match(stderr, says);
    assert.equal(status, 2);
    assert.ok(!room.has('to'));
  });
