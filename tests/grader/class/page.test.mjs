// The summary page of a class, graded by the stand-in, in the browser:   node page.test.mjs STAND_IN
import assert from 'node:assert/strict';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { after, before, test } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { HtmlValidate } from 'html-validate';
import { openChromium } from '../../../book/paper/chromium.mjs';
import { classroom } from './classroom.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const room = classroom({
  'ada/1-first/one': '// score 10',
  'bob/1-first/one': '// score 4',
  'cy/1-first/one': 'no such thing',
  'new\nline % ?#/1-first/one': '// score 0',
  'ada/1-first/two': '// score 10',
  'ada/2-second/three': '// score 4',
  '<script>alert(1)<~script>/1-first/two': '// fails',
});
writeFileSync(room.path('assigned'), '1-first/one\n1-first/two\n2-second/three\n');
room.grade(['--assigned', room.path('assigned')]);
const page = room.path('results/summary.html');

let browser;
before(async () => {
  browser = await openChromium();
});
after(() => browser.close());

async function open(width, colorScheme) {
  const tab = await (await browser.newContext({ viewport: { width, height: 900 }, colorScheme })).newPage();
  tab.faults = [];
  tab.on('console', message => tab.faults.push(message.text()));
  tab.on('pageerror', error => tab.faults.push(error.message));
  tab.on('request', request => request.url().startsWith('file:') || tab.faults.push(request.url()));
  await tab.goto(pathToFileURL(page).href);
  return tab;
}

for (const [width, colours] of [
  [1280, 'light'],
  [1280, 'dark'],
  [390, 'light'],
  [390, 'dark'],
]) {
  test(`the summary page at ${width} pixels, ${colours}: nothing amiss, nothing loaded, no scrolling sideways`, async () => {
    const tab = await open(width, colours);
    await tab.evaluate(axe);
    const { violations } = await tab.evaluate(() => axe.run(document, { preload: false }));
    assert.deepEqual(
      violations.map(v => `${v.id}: ${v.help} ${v.nodes[0].target}`),
      [],
    );
    assert.deepEqual(tab.faults, []);
    assert.ok(await tab.evaluate(() => document.documentElement.scrollWidth <= document.documentElement.clientWidth));
  });
}

test('the HTML of the summary page is valid', async () => {
  const report = await new HtmlValidate({ extends: ['html-validate:recommended'], root: true }).validateFile(page);
  assert.deepEqual(
    report.results.flatMap(result => result.messages).map(m => `${m.line}: ${m.message}`),
    [],
  );
});

test('the links of the summary page lead to the feedback, whatever a student is called', async () => {
  const tab = await open(1280, 'light');
  const links = await tab.$$eval('a', all => all.map(a => a.href));
  assert.equal(links.length, 5 * 3);
  for (const link of links) assert.ok(existsSync(fileURLToPath(link)), link);
});

test('the summary page counts what the reports say', async () => {
  const tab = await open(1280, 'light');
  const first = await tab.$eval('section', section => section.innerText.replace(/\s+/g, ' '));
  assert.match(first, /^1-first\/one /);
  for (const part of [
    '1 ACCEPTED',
    '1 PARTIAL',
    '1 WRONG_ANSWER',
    '1 COMPILE_ERROR',
    '1 REJECTED',
    'the first test 4 2 of 4',
    'the second test 6 1 of 4',
  ]) {
    assert.ok(first.includes(part), `${part} in ${first}`);
  }
  const row = await tab.$eval('.students tbody tr', tr => tr.innerText.replace(/\s+/g, ' '));
  assert.match(row, /no grade GRADER_ERROR/);
});
