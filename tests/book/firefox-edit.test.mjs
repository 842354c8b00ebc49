// What is written in the page, in the distribution's Firefox, from disk: a step in a figure, and an exercise.
//   node firefox-edit.test.mjs BUILD FIREFOX SOURCE
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { openFirefox } from './firefox.mjs';
import { folder } from './book.mjs';

const source = process.argv[4];
const browser = await openFirefox(process.argv[3]);
after(() => browser.close());
const tab = await (
  await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: 'reduce' })
).newPage();
const faults = [];
tab.on('pageerror', error => faults.push(error.message));
await tab.goto(pathToFileURL(join(folder, '2-euler.html')).href);

const write = async (place, text) => {
  await place.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
};
const told = async (place, words) => {
  const line = place.filter({ hasText: words });
  await line.first().waitFor({ timeout: 120_000 }); // other tests run beside it
};

test('two lines swapped in a figure are symplectic Euler', async () => {
  const figure = tab.locator('[data-live="drone-spiral"]');
  await figure.locator('.edit').click();
  await told(figure.locator('.examined'), /Its steps are those of Euler, to the last bit/);
  await write(figure, 'const Vec a = acceleration(x, v, t);\nv = v + h * a;\nx = x + h * v;');
  await told(figure.locator('.examined'), /symplectic Euler/);
  assert.deepEqual(faults, []);
});

// What was written before is there again: so much text takes long to type here.
async function judged(text, words) {
  await tab.evaluate(written => localStorage.setItem('code 2-euler/orbit-drift', written), text);
  await tab.reload();
  const section = tab.locator('.exercise:has([data-exercise="2-euler/orbit-drift"])');
  await section.getByRole('button', { name: 'Go on writing: orbit-drift' }).click();
  await section.locator('.cm-content').waitFor();
  await section.getByRole('button', { name: 'Judge', exact: true }).click();
  await told(section.locator('.report'), words);
  assert.deepEqual(faults, []);
}
const solution = readFileSync(join(source, 'exercises/2-euler/orbit-drift/solution.h'), 'utf8');
const before = '  const Vec a = ';

test('an exercise is solved', () => judged(solution, /ACCEPTED, 10 of 10 points/));

test('a call without end hurts nobody', () =>
  judged(
    solution
      .replace(
        '/// One step',
        'inline double deep(double d) {\n  return d > 0 ? 1 + deep(d + 1) : d;\n}\n\n/// One step',
      )
      .replace(before, `  x.x = deep(1);\n${before}`),
    /called itself without end/,
  ));

test('nor does a loop', () =>
  judged(
    solution.replace(before, `  for (volatile unsigned n = 0;; n = n + 1) {\n  }\n${before}`),
    /did not come back/,
  ));
