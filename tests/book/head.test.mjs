// What a page says of itself to search engines and messengers.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { kind, pages, parse } from './book.mjs';

const shown = pages.filter(page => kind(page) !== 'source');
const content = ($, selector) => $(`head ${selector}`).attr('content') ?? '';

test('each page but a source says what it is about, in words that a list of hits shows whole', () => {
  for (const page of shown) {
    const $ = parse(page);
    const about = content($, 'meta[name=description]');
    assert.ok(about.length >= 10 && about.length <= 170, `${page}: "${about}"`);
    assert.doesNotMatch(about, /[\ue000-\uf8ff\\<]/, page);
    assert.equal(content($, 'meta[property="og:title"]'), $('head > title').text(), page);
  }
});

test('no two pages with prose say the same of themselves', () => {
  const told = shown.filter(page => !['api', '404'].includes(kind(page)));
  const abouts = told.map(page => content(parse(page), 'meta[name=description]'));
  assert.deepEqual(
    abouts.filter((about, i) => abouts.indexOf(about) !== i),
    [],
  );
});

test('no two pages have one title, and that of a chapter has the words that are searched', () => {
  const titleOf = page => parse(page)('head > title').text();
  const titles = shown.map(titleOf);
  assert.deepEqual(
    titles.filter((title, i) => titles.indexOf(title) !== i),
    [],
  );
  assert.match(titleOf('2-euler.html'), /explicit Euler/i);
  assert.match(titleOf('6-symplectic.html'), /semi-implicit/i);
  assert.match(titleOf('index.html'), /numerical integration/);
});

test('sources are not for search engines, and all else is', () => {
  for (const page of pages)
    assert.equal(content(parse(page), 'meta[name=robots]'), kind(page) === 'source' ? 'noindex' : '', page);
});

test('the first page describes the book in the words of schema.org', () => {
  const book = JSON.parse(parse('index.html')('script[type="application/ld+json"]').text());
  assert.equal(book['@type'], 'Book');
  assert.match(book.version, /^\d+\.\d+\.\d+$/);
});

test('the page about this copy says how to cite it, and where to tell of a mistake', () => {
  const $ = parse('about.html');
  assert.match($('pre').text(), /^@book\{/);
  assert.ok($('#report-a-mistake + p').text().length > 40);
  for (const page of shown) assert.equal(parse(page)('main > footer a').attr('href'), 'about.html', page);
});
