// For each chapter, a word that stands only there: the search finds it and leads there. And what readers type: for nine queries in
// ten of search-queries.json one of the places named there is among the first three.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
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
  // No plural: to the search it is its singular, which may stand in another section.
  const own = [...new Set(words(chapter))].filter(word => !word.endsWith('s') && !elsewhere.includes(word));
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
  if (!start) return document.getElementById(fragment)?.textContent ?? ''; // an exercise is a box by itself
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

test('a word that stands nowhere finds nothing, and is told where else to look', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').fill('qqxzyy');
  await tab.locator('.search li').first().waitFor();
  const offered = await tab.locator('.search li a').evaluateAll(links => links.map(a => a.getAttribute('href')));
  assert.deepEqual(offered, ['pick-a-method.html', 'glossary.html', 'snippets.html']);
});

async function hitsOf(query) {
  await tab.waitForFunction(() => window.findInBook);
  return tab.evaluate(
    text => window.findInBook(text).map(({ url, kind, place, title }) => ({ url, kind, place, title })),
    query,
  );
}

test('arrows lead through the hits, and Enter in the box to the first', async () => {
  await visit(tab, 'index.html');
  await tab.keyboard.press('/');
  await tab.keyboard.type('leapfrog');
  await tab.locator('.search li a').nth(2).waitFor();
  const focused = () =>
    tab.evaluate(() => [...document.querySelectorAll('.search li a')].indexOf(document.activeElement));
  const walked = [];
  for (const key of ['ArrowDown', 'ArrowDown', 'ArrowUp', 'ArrowUp']) {
    await tab.keyboard.press(key);
    walked.push(await focused());
  }
  assert.deepEqual(walked, [0, 1, 0, -1]);
  const [first] = await hitsOf('leapfrog');
  await tab.keyboard.press('Enter');
  await tab.waitForURL(url => !url.pathname.endsWith('index.html'));
  assert.ok(tab.url().endsWith(first.url), `${tab.url()} instead of ${first.url}`);
});

test('what readers type finds its place among the first three', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').focus();
  const queries = Object.entries(JSON.parse(readFileSync(new URL('search-queries.json', import.meta.url), 'utf8')));
  const missed = [];
  for (const [query, places] of queries) {
    const hits = (await hitsOf(query)).slice(0, 3).map(({ url }) => url);
    if (!hits.some(url => places.includes(url))) missed.push(`${query}: ${hits.join(', ')}`);
  }
  const said = `${queries.length - missed.length} of ${queries.length} hold; not these:\n${missed.join('\n')}`;
  console.log(said);
  assert.ok(queries.length >= 104 && missed.length <= queries.length / 10, said);
});

test('each hit says where it is, and the reference comes last', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').focus();
  for (const query of ['spring', 'rk4', 'cloth', 'damping', 'energy', 'leapfrog']) {
    const hits = await hitsOf(query);
    const kinds = hits.map(({ kind }) => kind);
    assert.ok(hits.length > 0 && hits.every(({ place, title }) => place && title), query);
    assert.ok(kinds.filter(kind => kind === 'name').length <= 3, `${query}: ${kinds}`);
    assert.ok(kinds.filter(kind => kind === 'claim').length <= 2, `${query}: ${kinds}`);
    assert.ok(!kinds.some((kind, i) => kind === 'name' && kinds.slice(i).some(later => later !== 'name')), query);
  }
});

test('an exercise is found by its number', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').focus();
  for (const query of ['exercise 4 of chapter 3', 'exercise 3.4', '3.4']) {
    const [first] = await hitsOf(query);
    assert.match(first.place, /^Exercise 3\.4\b|^Section 3\.4\b/, query);
  }
});

test('what is called just what was typed is first or second, and each hit shows where it is', async () => {
  await visit(tab, 'index.html');
  await tab.locator('.search input').fill('stiff');
  await tab.locator('.search li a').first().waitFor();
  const hits = await hitsOf('stiff');
  assert.ok(hits.slice(0, 2).some(({ kind }) => kind === 'word'));
  assert.ok(await tab.locator('.search li .place').first().isVisible());
});
