// Back into Moodle: whose work it was, and the worksheet:   node moodle_back.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { rmSync, symlinkSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { host } from './hosts.mjs';
import { flat, handedIn, roster, worksheet } from './moodle_files.mjs';

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

// What becomes of a round, by the times of the files, that goes back into this worksheet.
function handedBack(sheet) {
  const room = host();
  room.handOut(handedIn);
  room.write('sheet.csv', sheet);
  room.collect('moodle');
  room.gradeCourse();
  return { room, ...room.run('hand-back', 'moodle', 'sheet.csv', 'results/week-1') };
}

for (const most of ['10.00', '100.00'])
  test(`a round is not handed back into an assignment out of ${most}`, () => {
    const { room, status, stderr } = handedBack(worksheet.replaceAll('20.00', most));
    assert.equal(status, 2);
    assert.match(
      stderr,
      new RegExp(`^grade: sheet.csv:2: the assignment is out of ${most} there, and this round out of 20; [^\\n]*\\n$`),
    );
    assert.ok(!room.has('results/week-1/moodle.csv'));
  });

test('the worksheet of another assignment is refused, in which the numbers are others’', () => {
  const { status, stderr } = handedBack(worksheet.replace('4711', '9').replace('4712', '4711'));
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
