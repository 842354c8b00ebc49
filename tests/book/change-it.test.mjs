// "Change it": each press shows the changed program's film, its lines in the listings and what it prints, and takes them back.
//   node change-it.test.mjs BUILD [others]
// The presses of the first two chapters; with "others", those of the others.
import assert from 'node:assert/strict';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessibility } from './accessibility.mjs';
import { chapters, folder, parse } from './book.mjs';
import { openTab, visit } from './browser.mjs';

const tab = await openTab('dark', { reducedMotion: 'no-preference' });

const apply = title => tab.getByRole('button', { name: `Apply: ${title}` });

// What a change is about, on the page as it stands: the listings, what is printed, and where the film comes from.
const shown = () =>
  tab.evaluate(() => ({
    listings: [...document.querySelectorAll('.listing code')].map(e => e.innerHTML),
    prints: [...document.querySelectorAll('[data-printed-by]')].map(e => e.textContent),
    films: [...document.querySelectorAll('.film iframe')].map(e => e.getAttribute('src')),
  }));

const withChanges = chapters.filter(page => parse(page)('.change').length);
const others = process.argv.includes('others');
for (const page of withChanges) {
  const $ = parse(page);
  const boxes = $('.change')
    .map((_, box) => ({
      title: $(box).find('.label').text(),
      name: $(box).attr('id'),
      program: $(box).attr('data-program'),
      film: $(box).attr('data-film'),
      put: $(box)
        .find('.diff ins')
        .map((_, e) => $(e).text().slice(1).trim())
        .get(),
      prints: $(box).find('.codebox:not(.diff) code').text(),
    }))
    .get();

  test(`${page}: three changes, each with its film`, () => {
    assert.equal(boxes.length, 3);
    for (const { film } of boxes) assert.ok(existsSync(join(folder, film)), film);
  });

  if (withChanges.indexOf(page) >= 2 !== others) continue;
  test(`${page}: each change is applied and taken back`, async () => {
    await visit(tab, page);
    const before = await shown();
    for (const box of boxes) {
      const outcome = tab.locator(`#${box.name} details .codebox`);
      assert.equal(await outcome.isVisible(), false, 'what it does is told before anybody can guess');
      await apply(box.title).click();
      assert.equal(await outcome.isVisible(), true);
      const now = await shown();
      const listed = now.listings.join('\n');
      for (const line of box.put)
        assert.ok(
          await tab.locator('figure.listing ins', { hasText: line }).count(),
          `${box.title}: no listing shows ${line} in ${listed.length} letters`,
        );
      const quoted = tab.locator(`[data-printed-by="${box.program}"] code`);
      assert.equal(await quoted.textContent(), box.prints);
      assert.equal(now.films.filter(src => src.startsWith(box.film)).length, 2, 'its film, here and there');
      await tab.locator(`#${box.name} iframe`).scrollIntoViewIfNeeded();
      await tab.frameLocator(`#${box.name} iframe`).locator('canvas').waitFor();
      const film = await (await tab.locator(`#${box.name} iframe`).elementHandle()).contentFrame();
      assert.ok(await film.evaluate('behind.pictures.length > 1 && reel.pictures.length > 1'), 'two films in one');
    }
    assert.equal(await tab.locator('.change .film').count(), new Set(boxes.map(box => box.program)).size);
    assert.deepEqual(tab.faults, []);
    await tab.evaluate(() => scrollTo({ top: 0, behavior: 'instant' })); // so that the bar lies over nothing to press
    assert.deepEqual(await accessibility(tab), []); // which knocks at the films' frames, and they don't answer
    for (const back of (await tab.getByRole('button', { name: /^Take it back: / }).all()).reverse()) await back.click();
    assert.deepEqual(await shown(), before);
  });
}

test('a listing with a change is copied as the changed program has it', async () => {
  await visit(tab, '2-euler.html');
  await apply('Four times the steps').click();
  const listing = tab.locator('figure.listing:has(ins)').first();
  await listing.evaluate(e => {
    for (let fold = e; (fold = fold.closest('details:not([open])'));) fold.open = true;
  });
  await listing.locator('.copy').click();
  const copied = await tab.evaluate(() => navigator.clipboard.readText());
  assert.match(copied, /^.*= 1 \/ 240\.0;$/m);
  assert.doesNotMatch(copied, /1 \/ 60\.0|^\s*\n\s*\n/);
});
