// The cards of the methods: everywhere the same, where a reader looks for them, and the only place for times.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { readRecords } from '../../book/weave/csv.mjs';
import { folder, kind, pages, parse } from './book.mjs';

const text = e => e.text().replace(/\s+/g, ' ').trim();
const headers = pages.filter(page => kind(page) === 'api' && parse(page)('h1 .kicker').text() === 'code/integrate');

// Every card of the book: the page, the method, what it says.
const cards = pages.flatMap(page => {
  const $ = parse(page);
  return $('.card:not(.promises)')
    .map((_, card) => ({
      page,
      method: $(card).find('.sources a').first().text().replace('.csv', ''),
      says: text($(card).find('.parts')),
    }))
    .get();
});

test('a function that moves x on has a card below its signature', () => {
  let stepping = 0;
  for (const page of headers) {
    const $ = parse(page);
    $('section.member')
      .filter((_, e) => /\((Position|Vec)& x,/.test($(e).find('.signature').first().text()))
      .each((_, e) => {
        ++stepping;
        const method = text($(e).find('h2 code').first());
        assert.equal($(e).find('.card .sources a').first().text(), `${method}.csv`, page);
      });
  }
  assert.ok(stepping > 25, `${stepping} functions`);
});

test('the card of a method says the same on each page', () => {
  const chapters = cards.filter(({ page }) => kind(page) === 'chapter');
  assert.ok(chapters.length > 0);
  for (const { page, method, says } of chapters) {
    const reference = cards.find(card => card.method === method && kind(card.page) === 'api');
    assert.equal(says, reference.says, `${method} in ${page}`);
  }
});

test('a card with limits says that they are rounded down', () => {
  for (const page of pages) {
    const $ = parse(page);
    $('.card').each((_, card) => {
      if (/stable up to/i.test($(card).find('.parts').text()))
        assert.match($(card).find('.note').text(), /^Limits are rounded down\./, page);
    });
  }
});

test('the list of methods leads to each card and agrees with it', () => {
  const $ = parse('snippets.html');
  const rows = $('.methods tbody tr')
    .get()
    .map(row => ({
      method: text($(row).find('th code').first()),
      href: $(row).find('th a').attr('href'),
      limits: ['drag: ch up to', 'spring: hω up to'].map(head =>
        text(
          $(row)
            .find('td')
            .filter((_, cell) => text($(cell).find('.head')) === head)
            .clone()
            .find('.head')
            .remove()
            .end(),
        ),
      ),
    }));
  assert.deepEqual(rows.map(({ method }) => method).sort(), [...new Set(cards.map(({ method }) => method))].sort());
  for (const {
    method,
    href,
    limits: [drag, spring],
  } of rows) {
    const card = cards.find(({ page, method: name }) => name === method && href.startsWith(`${page}#`));
    assert.ok(card, `${method} leads to ${href}`);
    if (drag === '–') continue;
    assert.ok(card.says.includes(`drag, ch${drag}`), `${method}: ${drag} in ${card.says}`);
    assert.ok(card.says.includes(`undamped spring, hω${spring}`), `${method}: ${spring} in ${card.says}`);
  }
});

const shelf = pages.filter(page => kind(page) === 'api' && parse(page)('h1 .kicker').text() === 'code/shelf');

test('each header of the shelf stands in the index, and its page says what was measured of each promise', () => {
  const $ = parse('snippets.html');
  const listed = $('#things')
    .nextAll('dl')
    .first()
    .find('dt a')
    .get()
    .map(e => $(e).attr('href'));
  assert.deepEqual([...listed].sort(), [...shelf].sort());
  assert.ok(shelf.length >= 8);
  for (const page of shelf) {
    const $ = parse(page);
    const name = $('h1 > code').text().replace('.h', '');
    const rows = readRecords(join(folder, 'data/shelf', `${name}.csv`));
    assert.equal($('.card.promises').length, 1, page);
    assert.equal($('.card.promises dt').length, rows.length, page);
    assert.ok(
      rows.every(({ kept }) => kept === 'yes'),
      page,
    );
    const prose = $('main').clone();
    prose.find('pre').remove();
    assert.doesNotMatch(prose.text(), /Promises:/, page);
  }
});

test('the page of a header has all its lines to copy, above its card', () => {
  for (const page of [...headers, ...shelf]) {
    const $ = parse(page);
    const name = $('h1 > code').text();
    const whole = $('#all-of-it');
    assert.equal(
      whole.find('pre').text().trimEnd(),
      readFileSync(join(folder, 'headers', name), 'utf8').trimEnd(),
      page,
    );
    assert.equal(whole.prevAll('.card').length, 0, page);
  }
});

test('the page of a header begins with the file to take and an example that includes it', () => {
  assert.ok(headers.length > 15);
  for (const page of [...headers, ...shelf]) {
    const $ = parse(page);
    const header = $('h1 > code').text();
    assert.equal($('.take a[download]').attr('href'), `headers/${header}`, page);
    assert.ok($('.codebox').first().text().startsWith(`#include "${header}"\n`), page);
    assert.ok($('.codebox').first().prevAll('section').length === 0, page);
  }
});

test('nanoseconds stand on cards, of which the first of a page names the machine, in the list that names it too, and nowhere else', () => {
  let count = 0;
  for (const page of pages.filter(name => kind(name) !== 'source')) {
    const $ = parse(page);
    const timed = $('.card').filter((_, card) => /[\d)]\u202fns/.test($(card).text()));
    timed.each((n, card) =>
      assert.match(
        $(card).find('.times').text(),
        n && kind(page) === 'chapter'
          ? /^$/
          : /^Medians of \d+ runs in turn, recorded on .+ at .+ with .+, \d{4}-\d\d-\d\d/,
        page,
      ),
    );
    count += timed.length;
    const outside = $('main').clone();
    outside.find('.card, pre, script').remove();
    assert.doesNotMatch(outside.text(), /\d[\s\u202f]ns\b/, page);
  }
  assert.ok(count > 30, `only ${count} cards with a time`);
  const $ = parse('snippets.html');
  assert.match($('main > .times').text(), /^Medians of \d+ runs in turn, recorded on /);
});
