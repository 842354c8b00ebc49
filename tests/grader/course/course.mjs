// A course in a folder of its own, graded by the stand-in.
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readFileSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { GRADE, rows, scratch } from '../class/classroom.mjs';

export { rows };

// As a lecturer writes it: text in quotes, times without.
function toml(value) {
  if (value instanceof Time) return value.text;
  if (Array.isArray(value)) return `[${value.map(toml).join(', ')}]`;
  if (typeof value === 'object')
    return `{ ${Object.entries(value)
      .map(([key, one]) => `${key} = ${toml(one)}`)
      .join(', ')} }`;
  return JSON.stringify(value);
}

export class Time {
  constructor(text) {
    this.text = text;
  }
  toJSON() {
    return this.text;
  }
}
export const time = text => new Time(text);

const isTables = (key, value) => ['assignment', 'extension'].includes(key) && Array.isArray(value);

export function courseFile(course) {
  const above = Object.entries(course).filter(([key, value]) => value !== undefined && !isTables(key, value));
  const lines = above.map(([key, value]) => `${key} = ${toml(value)}`);
  for (const name of ['assignment', 'extension'])
    for (const one of isTables(name, course[name]) ? course[name] : [])
      lines.push('', `[[${name}]]`, ...Object.entries(one).map(([key, value]) => `${key} = ${toml(value)}`));
  return `${lines.join('\n')}\n`;
}

// What every course here has; `more` replaces parts of it.
export const usual = more => ({
  name: 'Numerical integration',
  time_zone: 'Europe/Berlin',
  submissions: 'submissions',
  results: 'results',
  assignment: [{ name: 'week-1', exercises: ['1-first/one'], due: time('2020-02-08T23:59:00') }],
  ...more,
});

export const onTime = '2020-02-08T22:00:00Z';

// handedIn: what stands in which file below the course, and when it came: ['// score 10', '2020-02-08T22:00:00Z'].
export function classOf(course, handedIn = {}) {
  const folder = scratch();
  const path = name => join(folder, name);
  const room = {
    path,
    write(name, text) {
      mkdirSync(dirname(path(name)), { recursive: true });
      writeFileSync(path(name), text);
    },
    describe: described => room.write('course.toml', courseFile(described)),
    handIn(name, text, at = onTime) {
      room.write(`${name}.h`, `${text}\n`);
      utimesSync(path(`${name}.h`), new Date(at), new Date(at));
    },
    read: name => readFileSync(path(`results/${name}`), 'utf8'),
    has: name => existsSync(path(`results/${name}`)),
    marks: assignment => JSON.parse(room.read(`${assignment}/marks.json`)),
    // Grades, and says what was graded in this run.
    grade(more = [], settings = {}) {
      rmSync(path('log'), { force: true });
      const run = spawnSync(GRADE, ['class', 'course.toml', '--jobs', '2', ...more], {
        encoding: 'utf8',
        cwd: folder,
        env: { ...process.env, STAND_IN_LOG: path('log'), ...settings },
        timeout: 60000,
      });
      const log = existsSync(path('log')) ? readFileSync(path('log'), 'utf8') : '';
      return { ...run, graded: log.split('\n').filter(Boolean).sort() };
    },
  };
  mkdirSync(path('submissions'));
  room.describe(course);
  for (const [name, what] of Object.entries(handedIn)) room.handIn(name, ...[what].flat());
  return room;
}
