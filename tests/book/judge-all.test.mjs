// Exercises in the page, from disk, by the page's own compiler: the solution has full marks, and a wrong way is told what it is.
// The first of each chapter; with `all` every one, which takes three minutes.
//   node judge-all.test.mjs BUILD SOURCE [all]
import assert from 'node:assert/strict';
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { openTab, visit } from './browser.mjs';

const [build, source, all] = process.argv.slice(2);
const tab = await openTab();
const chapters = readdirSync(join(source, 'exercises')).filter(name => /^\d/.test(name));

// The first of the edits whose mistake the judges know, and not one that crashes: of that each world speaks in its own way.
function wrongOf(exercise) {
  const folder = join(build, 'exercises', exercise, 'wrong');
  const texts = readdirSync(folder)
    .sort()
    .map(file => readFileSync(join(folder, file), 'utf8'));
  const text = texts.find(one => /^\/\/ Says: (?!.* past the end)/m.test(one) && !/^\/\/ Known: /m.test(one));
  return { text, says: /^\/\/ Says: (.*)$/m.exec(text)[1] };
}

async function judged(section, text) {
  await section.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
  await section.getByRole('button', { name: 'Judge', exact: true }).click();
  const report = section.locator('.report .headline');
  await report.waitFor({ timeout: 120_000 }); // other tests run beside it
  return section.locator('.report').textContent();
}

for (const chapter of chapters) {
  const tasks = readdirSync(join(source, 'exercises', chapter))
    .filter(name => !name.includes('.'))
    .slice(0, all ? Infinity : 1);
  test(chapter, async () => {
    await visit(tab, `${chapter}.html`);
    for (const task of tasks) {
      const exercise = `${chapter}/${task}`;
      const section = tab.locator(`.exercise:has([data-exercise="${exercise}"])`);
      await section.getByRole('button', { name: `Write it here: ${task}` }).click();
      await section.locator('.cm-content').waitFor();
      const { text, says } = wrongOf(exercise);
      const failed = await judged(section, text);
      assert.ok(failed.includes(says), `${exercise}: ${says}\n${failed}`);
      const solution = readFileSync(join(source, 'exercises', exercise, 'solution.h'), 'utf8');
      assert.match(await judged(section, solution), /^ACCEPTED, (\d+) of \1 points/, exercise);
    }
    assert.deepEqual(tab.faults, []);
  });
}
