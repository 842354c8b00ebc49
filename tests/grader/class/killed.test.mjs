// What others see of a class while it is graded, and what is left when it is killed:   node killed.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { test } from 'node:test';
import { setTimeout as sleep } from 'node:timers/promises';
import { classroom } from './classroom.mjs';

function processesAbout(folder) {
  return readdirSync('/proc')
    .filter(name => /^\d+$/.test(name))
    .flatMap(id => {
      try {
        const command = readFileSync(`/proc/${id}/cmdline`, 'utf8').split('\0');
        return command.some(word => word.includes(folder)) ? [command.join(' ')] : [];
      } catch {
        return []; // it has ended
      }
    });
}

async function until(condition) {
  for (let i = 0; i < 200 && !condition(); ++i) await sleep(50);
  assert.ok(condition());
}

const handedIn = () =>
  Object.fromEntries(
    ['a', 'b', 'c', 'd', 'e', 'f'].map((name, i) => [`${name}/1-first/one`, i < 2 ? '// score 4' : '// slow']),
  );

test('killed half-way, nothing runs on, and the next run grades the rest', async () => {
  const room = classroom(handedIn());
  const run = room.start();
  await until(() => room.has('c/1-first/one/report.json') && room.has('d/1-first/one/report.json'));
  const ended = new Promise(resolve => run.on('exit', resolve));
  run.kill('SIGKILL');
  await ended;
  await until(() => processesAbout(room.submissions).length === 0);
  assert.equal(room.report('a/1-first/one').verdict, 'PARTIAL');
  assert.equal(room.report('c/1-first/one').verdict, 'GRADER_ERROR');
  assert.match(room.report('c/1-first/one').why, /stopped before it came to a verdict/);
  assert.ok(!room.has('grades.csv'));
  const { status, graded } = room.grade([], { STAND_IN_SECONDS: '0' });
  assert.equal(status, 0);
  assert.deepEqual(
    graded,
    ['c', 'd', 'e', 'f'].map(name => `${name} 1-first/one`),
  );
});

test('asked to end, it ends with all that it started, and says how to go on', async () => {
  for (const signal of ['SIGINT', 'SIGTERM']) {
    const room = classroom(handedIn());
    const run = room.start();
    await until(() => room.has('c/1-first/one/report.json'));
    const ended = new Promise(resolve => run.on('exit', code => resolve(code)));
    run.kill(signal);
    assert.equal(await ended, 75);
    assert.deepEqual(processesAbout(room.submissions), []);
  }
});

test('the seed in a file is in no list of processes', async () => {
  const room = classroom(handedIn());
  const secret = '90210902109021';
  writeFileSync(room.path('seed'), `${secret}\n`);
  const run = room.start(['--seed-file', room.path('seed')]);
  const ended = new Promise(resolve => run.on('exit', resolve));
  await until(() => room.has('c/1-first/one/report.json'));
  const seen = processesAbout(room.submissions);
  run.kill('SIGKILL');
  await ended;
  assert.ok(seen.length >= 2, seen.join('\n'));
  assert.ok(seen.every(command => !command.includes(secret)));
  assert.equal(room.report('a/1-first/one').seed, secret);
  assert.ok(existsSync(room.path('seed')));
});
