// The judges of the page beside those of the grader, over every way of doing an exercise: the verdict of each test and the diagnosis
// are equal, and so are numbers, to ten digits or to the order of rounding. Only code that crashes, never comes back or wants too
// much memory ends in other words, and does so in both.
//
//     node page.test.mjs GRADE_WAYS JUDGES BUILD EXERCISE...
//
// BUILD/exercises/EXERCISE has the ways as a driver, `ways`, and as a module, `ways.wasm`.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { Worker } from 'node:worker_threads';

const [grader, judges, build, ...exercises] = process.argv.slice(2);
const PATIENCE = 60_000; // with a test in the module [ms]: others run beside it
const BRIEF = 3_000; // with one that never ends for the grader
const LIMITS = '100,200,8,60'; // twice what any way takes that ends

// As ways.mjs has written them.
const headersOf = exercise =>
  [
    ...readFileSync(join(build, 'exercises', exercise, 'ways.cpp'), 'utf8').matchAll(
      /^ {4}\{"(.*)", way_\d+::answer\},$/gm,
    ),
  ].map(([, header]) => header);

function saidByGrader(exercise, headers) {
  const driver = join(build, 'exercises', exercise, 'ways');
  const { status, stdout, stderr } = spawnSync(grader, [exercise, driver, LIMITS, 'words'], {
    input: `${headers.join('\n')}\n`,
    encoding: 'utf8',
    maxBuffer: 1 << 30,
  });
  assert.equal(status, 0, stderr);
  return stdout
    .trim()
    .split('\n')
    .map(line => JSON.parse(line));
}

/** What the module's judges say of one way; null if it never came back and had said nothing of that. */
class Page {
  start(exercise) {
    const module = join(build, 'exercises', exercise, 'ways.wasm');
    this.worker = new Worker(new URL('page-judge.mjs', import.meta.url), { workerData: { judges, module, exercise } });
  }
  say(exercise, header, patience) {
    if (!this.worker) this.start(exercise);
    const { worker } = this;
    return new Promise((done, failed) => {
      let soFar = null;
      let late;
      const wait = () => {
        clearTimeout(late);
        late = setTimeout(() => end(soFar), patience);
      };
      const end = report => {
        clearTimeout(late);
        for (const event of ['error', 'message']) worker.removeAllListeners(event);
        if (report === soFar) this.stop();
        done(report);
      };
      worker.on('error', failed);
      worker.on('message', ({ report, told }) => {
        if (report) return end(report);
        soFar = told;
        wait();
      });
      wait();
      worker.postMessage(header);
    });
  }
  stop() {
    this.worker?.terminate();
    this.worker = null;
  }
}

const ENDED = ['RUNTIME_ERROR', 'TIME_LIMIT', 'MEMORY_LIMIT', 'OUTPUT_LIMIT', 'INCOMPLETE', 'PROTOCOL_ERROR'];
const NUMBER = /(?<![\w.])[-\u2212]?\d+(?:\.\d+)?(?:e[-+]?\d+)?/g;

const isNear = (one, other) => {
  if (one === other) return true;
  const [a, b] = [one, other].map(text => Number(text.replace('\u2212', '-')));
  const most = Math.max(Math.abs(a), Math.abs(b));
  return Math.abs(a - b) <= 1e-10 * most || most < 1e-9;
};

function isAlike(one, other) {
  if (one === other) return true;
  if (one.replace(NUMBER, '#') !== other.replace(NUMBER, '#')) return false;
  const numbers = other.match(NUMBER) ?? [];
  return (one.match(NUMBER) ?? []).every((number, i) => isNear(number, numbers[i]));
}

// Where rounding alone decides what comes, and whether it looks like a known mistake: [way, test], one of them empty for all.
const OF_ROUNDING = [
  ['edge-of-stability/wrong/exact-motion.h', ''], // compares the size of e^(iy), which is one, with one
  ['edge-of-stability/wrong/midpoint-polynomial.h', ''], // the same, where a step hardly stretches
  ['step-by-price/wrong/pass-in-the-middle.h', ''], // chooses its steps by an error that is rounding
  ['shuttle-on-a-budget/wrong/equal-rk4.h', ''], // each flight is as far off as the next by the judge's measure: which is in the middle?
  ['any-table/', 'any table is followed, whatever its rows and its weights add up to'], // which multiply it by a million millions
];
const isOfRounding = (header, test) => OF_ROUNDING.some(([way, name]) => header.includes(way) && test.startsWith(name));

function differences(header, ours, page) {
  const found = [];
  if (ours.verdict !== page.verdict) found.push(`${ours.verdict} is ${page.verdict}: ${page.why}`);
  ours.tests.forEach((test, i) => {
    const same = page.tests[i];
    if (test.name !== same.name || test.outcome !== same.outcome)
      found.push(`${test.name}: ${test.outcome}, ${same.outcome}`);
    if (isOfRounding(header, test.name)) return;
    const [lines, others] = [test, same].map(({ failed }) =>
      (failed?.lines ?? []).map(({ label, text }) => `${label}: ${text}`),
    );
    if (lines.length !== others.length) found.push(`${lines.join('\n')}\nis\n${others.join('\n')}`);
    else lines.forEach((line, k) => isAlike(line, others[k]) || found.push(`${line}\n  is ${others[k]}`));
  });
  return found;
}

for (const exercise of exercises) {
  test(exercise, async t => {
    assert.ok(existsSync(join(build, 'exercises', exercise, 'ways.wasm')));
    const headers = headersOf(exercise);
    const said = saidByGrader(exercise, headers);
    const page = new Page();
    let ended = 0;
    const wrong = [];
    for (const [i, header] of headers.entries()) {
      const ours = said[i];
      const report = await page.say(exercise, header, ours.verdict === 'TIME_LIMIT' ? BRIEF : PATIENCE);
      const bothEnd = [ours, report].every(one => ENDED.includes(one?.verdict));
      if (bothEnd) ++ended;
      const found = bothEnd ? [] : differences(header, ours, report);
      if (found.length) wrong.push(`${header.split('/').slice(-2).join('/')}\n${found.join('\n')}`);
    }
    page.stop();
    t.diagnostic(`${headers.length} ways, of which ${ended} end otherwise than by an answer`);
    assert.ok(headers.length >= 3);
    assert.deepEqual(wrong, []);
  });
}
