// Twenty of the grader's hostile submissions, judged in the page: none is accepted, nothing leaves the disk, what the reader keeps stays,
// and the page goes on.  node hostile-code.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { openTab, visit } from './browser.mjs';

const source = process.argv[3];
const NAME = '2-euler/orbit-drift';
const HOSTILE = [
  '01-exit',
  '06-before-main',
  '07-atexit',
  '09-main',
  '12-macros',
  '13-own-test-case',
  '14-double-is-float',
  '16-equal-to-all',
  '17-std-overloads',
  '19-own-malloc',
  '20-own-answer',
  '21-plausible-numbers',
  '22-flood',
  '26-forged-report',
  '28-knows-the-grader',
  '31-includes-passwd',
  '40-timing',
  '45-all-memory',
  '47-recursion',
  '48-prints-without-end',
];
// Theirs is the same exercise with one function alone.
const OTHER_FUNCTION = '\ninline int steps_per_turn(double) {\n  return 1;\n}\n';

const tab = await openTab();
await visit(tab, '2-euler.html');
await tab.evaluate(() => localStorage.setItem('mine', 'kept'));
const section = tab.locator(`.exercise:has([data-exercise="${NAME}"])`);
await section.getByRole('button', { name: 'Write it here: orbit-drift' }).click();
await section.locator('.cm-content').waitFor();

async function judged(text) {
  await section.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
  await section.getByRole('button', { name: 'Judge', exact: true }).click();
  const status = () => document.querySelector('.program .compiled').textContent;
  await tab.waitForFunction(`/Compiling|Judging/.test((${status})())`);
  await tab.waitForFunction(`!/Compiling|Judging/.test((${status})())`, null, { timeout: 120_000 });
  return section.locator('.compiled').textContent();
}

for (const name of HOSTILE)
  test(`${name} hurts nobody`, async t => {
    const text = readFileSync(join(source, 'tests/grader/corpus/hostile', `${name}.h`), 'utf8');
    const said = await judged(text + OTHER_FUNCTION);
    t.diagnostic(said.slice(0, 100));
    assert.doesNotMatch(said, /^ACCEPTED/);
    assert.ok(said.length > 0);
    assert.deepEqual(tab.faults, []);
  });

test('the page goes on', async () => {
  assert.match(
    await judged(readFileSync(join(source, 'exercises', NAME, 'solution.h'), 'utf8')),
    /^ACCEPTED, 10 of 10 points$/,
  );
  assert.equal(await tab.evaluate(() => localStorage.getItem('mine')), 'kept');
  assert.equal(await tab.evaluate(() => document.querySelectorAll('[data-live].live').length > 0), true);
  assert.deepEqual(tab.faults, []);
});
