// What a careful printer would see to in the whole book. What one sees page by page, the test of the pages looks at.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chapters, kind, pages, parse, prose } from './book.mjs';
import { openTab, visit } from './browser.mjs';

test('a fade goes where there is nothing more to see', async () => {
  const tab = await openTab('dark');
  await visit(tab, chapters.at(-1));
  const box = tab.locator('pre.cut').first();
  await box.evaluate(e => {
    e.scrollLeft = e.scrollWidth;
  });
  await tab.waitForFunction(() =>
    [...document.querySelectorAll('pre')].some(e => e.scrollLeft > 0 && !e.classList.contains('cut')),
  );
});

test('the code reference starts with a list of every namespace', () => {
  const spaces = pages.filter(page => kind(page) === 'api' && /^namespace \w+$/.test(parse(page)('h1 .kicker').text()));
  const listed = parse('reference.html')('h2 a')
    .map((_, e) => e.attribs.href)
    .get();
  assert.ok(spaces.length >= 4);
  assert.deepEqual(listed.sort(), spaces.sort());
});

test('no page shows a backtick or doubled quotes, as marks do that were not understood', () => {
  const found = pages
    .filter(name => kind(name) !== 'source')
    .flatMap(page =>
      [...prose(page).matchAll(/.{0,40}(?:`|''|‘‘|’’|\ue002).{0,40}/g)].map(([words]) => `${page}: ${words.trim()}`),
    );
  assert.deepEqual(found, []);
});
