// The book on paper: each chapter by itself, and the PDF of the whole.   node tests/book/paper.test.mjs build
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { countSheets, sheetsOfPlaces } from '../../book/paper/destinations.mjs';
import { chapters, folder, parse } from './book.mjs';
import { openTab, visit } from './browser.mjs';
import { linksOf, sheetsOf, textOf } from './pdf.mjs';

const MARGIN = 60; // points, a little less than the style sheet leaves
const TEXT = 620; // pixels, what the margins leave of A4
const work = mkdtempSync(join(tmpdir(), 'paper-'));
after(() => rmSync(work, { recursive: true }));

const file = join(folder, 'one-step-at-a-time.pdf');
const pdf = readFileSync(file);
const sheets = countSheets(pdf);
const places = sheetsOfPlaces(pdf);
const pages = textOf(file).split('\f');
const letters = text => text.normalize('NFKC').replace(/[^\p{L}\d]/gu, '');
const title = page => parse(page)('main h1').clone().find('.kicker').remove().end().text().trim();

// The longest stretch of each answer without a formula or a number of the book's.
const answers = chapters.flatMap(page => {
  const $ = parse(page);
  return $('.exercise .answer > div')
    .get()
    .map(answer => {
      const bare = $(answer).clone();
      bare.find('.katex, code, .claim, data').replaceWith('\n');
      const stretches = bare.text().split('\n').map(letters);
      return stretches.sort((a, b) => b.length - a.length)[0];
    });
});

function assertWithinMargins(name, pages) {
  const out = pages.flatMap(({ width, words }, i) =>
    words
      .filter(({ xMin, xMax }) => xMin < MARGIN || xMax > width - MARGIN)
      .map(({ word }) => `${name}, ${i + 1}: ${word}`),
  );
  assert.deepEqual(out, []);
}

// Chromium sets a page smaller on paper whose widest part would not fit.
async function assertNothingTooWide(tab) {
  await tab.emulateMedia({ media: 'print' });
  await tab.setViewportSize({ width: TEXT, height: 900 });
  const wide = await tab.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(wide <= TEXT, `${wide} pixels wide`);
}

for (const page of chapters) {
  test(`${page} prints on fewer than 28 sheets, with heads, numbers and margins, and without answers`, async () => {
    const tab = await openTab();
    await visit(tab, page);
    const printed = join(work, 'chapter.pdf');
    const bytes = await tab.pdf({ format: 'A4', preferCSSPageSize: true });
    writeFileSync(printed, bytes);
    await assertNothingTooWide(tab);
    await tab.context().close();
    const count = countSheets(bytes);
    assert.ok(count > 10 && count < 28, `${count} sheets`);
    const own = textOf(printed).split('\f');
    const [head, number] = own[2].split('\n');
    assert.ok(head.startsWith(title('index.html')) && head.endsWith(title(page)), head);
    assert.equal(number, '3');
    const text = letters(own.join(''));
    assert.deepEqual(
      answers.filter(answer => text.includes(answer)),
      [],
    );
    assert.match(text, /Answersonthescreen/);
    assert.doesNotMatch(own.join('\n'), /^(Step|Reset|Copy)$/m);
    assertWithinMargins(page, sheetsOf(printed));
  });
}

test('the front page leads to the PDF, and says how many pages it has', () => {
  const line = parse('index.html')('main p.pdf');
  assert.equal(line.find('a').attr('href'), 'one-step-at-a-time.pdf');
  assert.ok(line.text().includes(` ${sheets} pages`), line.text());
  assert.ok(sheets > 100 && sheets < 250 && pdf.length < 15e6, `${sheets} pages, ${pdf.length} bytes`);
});

test('the contents name the page of each chapter and of each section', () => {
  const listed = new Map(
    pages[1].split('\n').map(line => [letters(line.replace(/ \d+$/, '')), Number(line.match(/\d+$/))]),
  );
  for (const page of chapters) {
    const $ = parse(page);
    const sections = $('main h2')
      .get()
      .map(h => $(h).clone().find('.anchor-link').remove().end().text());
    assert.ok(sections.length > 5);
    for (const heading of [title(page), ...sections]) {
      const number = heading === title(page) ? parseInt(page) : '';
      const sheet = listed.get(letters(`${number}${heading}`));
      assert.ok(sheet, `"${heading}" is not in the contents`);
      assert.ok(letters(pages[sheet - 1]).includes(letters(heading)), `"${heading}" is not on page ${sheet}`);
    }
  }
});

test('answers stand at the end, and nowhere else', () => {
  const start = places.get('answers');
  assert.ok(answers.length > 20 && answers.every(answer => answer.length > 8));
  const [before, appendix] = [pages.slice(0, start - 1), pages.slice(start - 1)].map(part => letters(part.join('')));
  assert.deepEqual(
    answers.filter(answer => before.includes(answer)),
    [],
  );
  assert.deepEqual(
    answers.filter(answer => !appendix.includes(answer)),
    [],
  );
  assert.equal(before.match(/Answerpage\d+/g).length, answers.length);
});

test('links lead within the book or to the web, and each part has a bookmark', () => {
  const { all, within, without, bookmarks } = linksOf(pdf);
  assert.equal(within.length + without.length, all);
  assert.ok(within.length > 500, `${within.length} links within`);
  assert.deepEqual(
    within.filter(name => !places.has(name)),
    [],
  );
  assert.deepEqual(
    without.filter(address => !/^https?:\/\//.test(address)),
    [],
  );
  for (const page of chapters)
    assert.ok(
      bookmarks.some(bookmark => bookmark.includes(title(page))),
      title(page),
    );
});

test('on no sheet but the one to pick a method does anything stand in the margin', () => {
  const wall = places.get('pick-a-method') - 1;
  assertWithinMargins(
    'whole',
    sheetsOf(file).map((sheet, i) => (i === wall ? { ...sheet, words: [] } : sheet)),
  );
});
