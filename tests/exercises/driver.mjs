// Texts of ours as submissions of an exercise: many in one driver, outside the cage, or one as a student's is graded.
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, realpathSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { driverOf } from './ways.mjs';

const most = 150; // in one driver, for which the compiler takes up to 600 MB
const tries = 4; // to compile a driver, each without those that the compiler refused before

function inFolder(use) {
  const folder = realpathSync(mkdtempSync(join(tmpdir(), 'driver-')));
  try {
    return use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

// The grader's answer to this text, in the cage.
export function graded(exercise, text, { grade, limits }) {
  return inFolder(folder => {
    const file = join(folder, `${basename(exercise)}.h`);
    writeFileSync(file, text);
    const words = [exercise, file, '--exit-status', 'verdict', '--limits', limits];
    return spawnSync(grade, words, { encoding: 'utf8' });
  });
}

// The headers that the compiler's errors are about. One in a library's file is about the header that led there.
function blamed(said, headers) {
  const guilty = new Set();
  let user = null;
  for (const line of said.split('\n')) {
    const [, file, kind] = line.match(/^([^\s:]+):(?:\d+:)*\s*(fatal error|error|warning|note)?/) ?? [];
    if (!kind && headers.includes(file)) user = file;
    if (!/error$/.test(kind)) continue;
    guilty.add(headers.includes(file) ? file : user);
    user = null;
  }
  guilty.delete(null);
  return guilty;
}

// Makes a driver of those headers that compile, which it answers.
function compile(driver, harness, headers, [compiler, ...flags]) {
  let left = headers;
  for (let n = 0; n < tries; ++n) {
    writeFileSync(`${driver}.cpp`, driverOf(harness, left));
    const { status, stderr } = spawnSync(compiler, [...flags, `${driver}.cpp`, '-o', driver], {
      env: { ...process.env, LC_ALL: 'C' },
      encoding: 'utf8',
      maxBuffer: 1 << 28,
    });
    if (status === 0) return left;
    const bad = blamed(stderr, left);
    if (bad.size === 0) throw new Error(`a driver does not compile:\n${stderr.slice(0, 4000)}`);
    left = left.filter(header => !bad.has(header));
  }
  throw new Error(`a driver does not compile, not even without ${headers.length - left.length} of its headers`);
}

function ask(exercise, driver, headers, { grade, limits }) {
  const { status, stdout, stderr } = spawnSync(join(dirname(grade), 'grade_ways'), [exercise, driver, limits], {
    input: headers.join('\n'),
    encoding: 'utf8',
  });
  if (status !== 0 || stderr) throw new Error(`grade_ways: ${status}\n${stderr}`);
  const lines = [...stdout.matchAll(/^(\w+) (\d+)\/(\d+) (.*)$/gm)];
  return new Map(lines.map(([, verdict, score, points, path]) => [path, { verdict, full: score === points }]));
}

// The same of at most so many texts. The solution goes with them: if it has full marks, the driver works.
function someVerdicts(exercise, texts, { source, grade, limits }) {
  return inFolder(folder => {
    const home = join(source, 'exercises', exercise);
    const headers = [readFileSync(join(home, 'solution.h'), 'utf8'), ...texts].map((text, i) => {
      const header = join(folder, `${i}.h`);
      writeFileSync(header, text);
      return header;
    });
    const words = readFileSync(join(dirname(grade), 'compile_driver.txt'), 'utf8')
      .trim()
      .split('\n');
    const driver = join(folder, 'driver');
    const inside = compile(driver, join(home, 'harness.h'), headers, words);
    const found = ask(exercise, driver, inside, { grade, limits });
    if (found.size !== inside.length) throw new Error(`${exercise}: not all were judged`);
    const [solution, ...others] = headers.map(header => found.get(header) ?? { verdict: 'COMPILE_ERROR', full: false });
    if (!solution.full) throw new Error(`${exercise}: its solution has ${solution.verdict} in a driver`);
    return others;
  });
}

// Of each text its verdict, and whether that means full marks. What does not compile among the others would not alone.
export function verdicts(exercise, texts, options) {
  const found = [];
  for (let i = 0; i < texts.length; i += most) found.push(...someVerdicts(exercise, texts.slice(i, i + most), options));
  return found;
}
