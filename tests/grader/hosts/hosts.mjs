// A course whose submissions come from a system, in a folder of its own, graded by the stand-in.
import { spawnSync } from 'node:child_process';
import {
  chmodSync,
  existsSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  statSync,
  utimesSync,
  writeFileSync,
} from 'node:fs';
import { dirname, join } from 'node:path';
import { GRADE, scratch } from '../class/classroom.mjs';
import { courseFile, time } from '../course/course.mjs';

export { time };

// When an archive was made, and with it all that is in it.
export const madeAt = new Date('2020-03-01T12:00:00Z');

export function host(grade = GRADE) {
  const folder = scratch();
  const path = name => join(folder, name);
  const room = {
    path,
    folder,
    // files: what stands in which, below the folder `from`.
    handOut(files, from = 'from') {
      for (const [name, text] of Object.entries(files)) {
        mkdirSync(dirname(path(`${from}/${name}`)), { recursive: true });
        writeFileSync(path(`${from}/${name}`), text);
        utimesSync(path(`${from}/${name}`), madeAt, madeAt);
      }
    },
    write(name, text) {
      mkdirSync(dirname(path(name)), { recursive: true });
      writeFileSync(path(name), text);
    },
    run: (...words) => spawnSync(grade, words, { encoding: 'utf8', cwd: folder, timeout: 60000 }),
    collect: (kind, ...more) => room.run('collect', kind, 'from', 'to', ...more),
    read: name => readFileSync(path(name), 'utf8'),
    has: name => existsSync(path(name)),
    mode: name => statSync(path(name)).mode & 0o777,
    modified: name => statSync(path(name)).mtime.toISOString(),
    close: name => chmodSync(path(name), 0),
    // All files below, by their paths.
    files(below = 'to') {
      const all = readdirSync(path(below), { withFileTypes: true }).flatMap(one =>
        one.isDirectory() ? room.files(`${below}/${one.name}`) : [`${below}/${one.name}`],
      );
      return all.filter(name => !/^to\/(\.collected|times\.csv|people\.csv)$/.test(name)).sort();
    },
    // By the times of the files; `times: undefined` by those that the collection knows.
    gradeCourse(more = {}, words = []) {
      room.write(
        'course.toml',
        courseFile({
          name: 'Numerical integration',
          time_zone: 'Europe/Berlin',
          submissions: 'to',
          results: 'results',
          times: 'files',
          assignment: [{ name: 'week-1', exercises: ['1-first/one', '1-first/two'], due: time('2020-02-08T23:59:00') }],
          ...more,
        }),
      );
      return room.run('class', 'course.toml', '--round', 'week-1', '--jobs', '2', ...words);
    },
    marks: () => JSON.parse(room.read('results/week-1/marks.json')),
    // student: [points of each exercise]
    points: () =>
      Object.fromEntries(room.marks().students.map(one => [one.student, one.marks.map(mark => mark.points)])),
  };
  mkdirSync(path('from'));
  return room;
}
