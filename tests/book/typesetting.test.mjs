// What a careful printer would see to: what belongs together stands together, and what is cut shows it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chapters, kind, pages, parse, prose } from './book.mjs';
import { openTab, visit } from './browser.mjs';

const looks = [
  ['desktop', await openTab()],
  ['phone', await openTab('dark')],
];

// Runs within a page.
async function faults() {
  await document.fonts.ready;
  const all = (selector, root = document) =>
    [...root.querySelectorAll(selector)].filter(e => e.getClientRects().length);
  const found = [];
  const wide = innerWidth > 820;
  const within = (text, mark) =>
    text.left < mark.right - 1 &&
    mark.left < text.right - 1 &&
    text.top < mark.bottom - 1 &&
    mark.top < text.bottom - 1;
  for (const mark of all('main a.claim')) {
    const block = mark.closest('p, li, td');
    const [line, at] = [block, mark].map(element => element.getBoundingClientRect());
    if (block.matches('td, .wall *')) {
      if (at.left - line.left < 10) found.push(`the check mark #${mark.id} starts a line`);
      continue;
    }
    if (wide && at.left < line.right) found.push(`the check mark #${mark.id} is not in the margin`);
    const text = document.createRange();
    text.selectNodeContents(block);
    if ([...text.getClientRects()].some(rect => rect.width > 20 && within(rect, at)))
      found.push(`the check mark #${mark.id} lies on its text`);
    for (const other of all('a.claim', block))
      if (other !== mark && within(other.getBoundingClientRect(), at))
        found.push(`the check marks #${mark.id} and #${other.id} lie on each other`);
  }
  for (const formula of all('main .nowrap .katex-html')) {
    const lefts = all(':scope > .base', formula).map(part => part.getBoundingClientRect().left);
    if (lefts.some((left, i) => left < lefts[i - 1])) found.push(`a short formula is torn: ${formula.textContent}`);
  }
  for (const svg of all('.plot svg')) {
    if (svg.getBoundingClientRect().width > svg.viewBox.baseVal.width + 1)
      found.push(`${svg.closest('figure').id} is drawn larger than it is`);
  }
  for (const box of all('pre, .tablescroll, .math-block')) {
    const cut = box.scrollWidth > box.clientWidth + 1;
    if (cut !== (getComputedStyle(box).maskImage !== 'none'))
      found.push(
        `${cut ? 'nothing shows that this is cut' : 'this fades, though it is whole'}: ${box.textContent.trim().slice(0, 40)}`,
      );
  }
  return found;
}

for (const page of pages.filter(name => !['api', 'source'].includes(kind(name)))) {
  for (const [look, tab] of looks) {
    test(`${page} on a ${look}`, async () => {
      await visit(tab, page);
      assert.deepEqual(await tab.evaluate(faults), []);
    });
  }
}

test('a fade goes where there is nothing more to see', async () => {
  const [, tab] = looks[1];
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
