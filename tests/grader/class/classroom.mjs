// A class in a folder of its own, graded by the stand-in.
import { spawn, spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { after } from 'node:test';

export const GRADE = process.argv[2];
const folders = [];
after(() => folders.forEach(folder => rmSync(folder, { recursive: true, force: true })));

export function scratch() {
  folders.push(mkdtempSync(join(tmpdir(), 'class-')));
  return folders.at(-1);
}

// handedIn: what stands in which file, as 'ada/1-first/one': '// score 10'. A name may be a Buffer only by write().
export function classroom(handedIn) {
  const folder = scratch();
  const path = name => join(folder, name);
  const room = {
    path,
    submissions: path('submissions'),
    results: path('results'),
    write(name, text) {
      const file = path(`submissions/${name}.h`);
      mkdirSync(dirname(file), { recursive: true });
      writeFileSync(file, `${text}\n`);
    },
    read: name => readFileSync(path(`results/${name}`), 'utf8'),
    has: name => existsSync(path(`results/${name}`)),
    report: name => JSON.parse(room.read(`${name}/report.json`)),
    arguments: more => ['--class', room.submissions, '--out', room.results, '--jobs', '2', ...more],
    environment: settings => ({ ...process.env, STAND_IN_LOG: path('log'), ...settings }),
    // Grades, and says what was graded in this run.
    grade(more = [], settings = {}) {
      rmSync(path('log'), { force: true });
      const run = spawnSync(GRADE, room.arguments(more), {
        encoding: 'utf8',
        env: room.environment(settings),
        timeout: 60000,
      });
      const log = existsSync(path('log')) ? readFileSync(path('log'), 'utf8') : '';
      return { ...run, graded: log.split('\n').filter(Boolean).sort() };
    },
    start: (more = [], settings = {}) =>
      spawn(GRADE, room.arguments(more), { stdio: 'ignore', env: room.environment(settings) }),
  };
  mkdirSync(room.submissions);
  for (const [name, text] of Object.entries(handedIn)) room.write(name, text);
  return room;
}

export const rows = csv => csv.trimEnd().split('\r\n');
