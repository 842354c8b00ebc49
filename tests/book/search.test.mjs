// For each chapter, a word that stands only there: the search finds it and leads there.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chapters, pages, prose, read } from './book.mjs';
import { openTab, pageOf, visit } from './browser.mjs';

const words = page =>
  prose(page)
    .toLowerCase()
    .match(/(?<![\p{L}\p{N}’'-])[a-z]{6,}(?![\p{L}\p{N}’'-])/gu) ?? [];

const texts = new Map(
  pages.map(page => [
    page,
    read(page)
      .replace(/<[^>]*>/g, '')
      .toLowerCase(),
  ]),
);

function wordOnlyIn(chapter) {
  const elsewhere = pages
    .filter(page => page !== chapter)
    .map(page => texts.get(page))
    .join(' ');
  const own = [...new Set(words(chapter))].filter(word => !elsewhere.includes(word));
  return own.sort((a, b) => b.length - a.length || (a < b ? -1 : 1))[0];
}

const tab = await openTab();

for (const chapter of chapters) {
  const word = wordOnlyIn(chapter);
  test(`"${word}" is found in ${chapter}`, async () => {
    await visit(tab, 'index.html');
    await tab.keyboard.press('/');
    await tab.keyboard.type(word);
    const first = tab.locator('.search li a').first();
    await first.waitFor();
    await first.click();
    await tab.waitForURL(url => !url.pathname.endsWith('index.html'));
    assert.equal(pageOf(tab), chapter);
    const fragment = decodeURIComponent(new URL(tab.url()).hash.slice(1));
    const section = await tab.evaluate(sectionText, fragment);
    assert.ok(section.toLowerCase().includes(word), `"${word}" does not stand in the section #${fragment}`);
    assert.deepEqual(tab.faults, []);
  });
}

// From a heading to the next one of its level; without a fragment, from the title to the first heading.
function sectionText(fragment) {
  const main = document.querySelector('main');
  const headings = [...main.querySelectorAll('h1, h2[id], h3[id], h4[id]')];
  const start = fragment ? headings.find(h => h.id === fragment) : headings[0];
  if (!start) return '';
  const later = headings.slice(headings.indexOf(start) + 1);
  const end = later.find(h => h.tagName <= start.tagName || start.tagName === 'H1');
  const range = document.createRange();
  range.setStartBefore(start);
  if (end) range.setEndBefore(end);
  else range.setEndAfter(main);
  return range.toString();
}

test('a word with a slip in it finds what is spelt nearly so', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').fill('symplektic');
  const first = tab.locator('.search li a').first();
  await first.waitFor();
  assert.match(await first.innerText(), /symplectic/i);
});

test('a word that stands nowhere finds nothing', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').fill('qqxzyy');
  await tab.locator('.search li').first().waitFor();
  assert.equal(await tab.locator('.search li a').count(), 0);
});
