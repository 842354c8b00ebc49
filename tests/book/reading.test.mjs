// What a reader does on a page: light and dark, copying, values under the mouse, hints, the next page, printing.
//   node reading.test.mjs BUILD [others]
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test as register } from 'node:test';
import { chapters, parse } from './book.mjs';
import { addressOf, bringIntoView, come, openTab, pageOf, visit } from './browser.mjs';

// What the tier `thorough` does besides is the last of the tests alone.
const others = process.argv.includes('others');
const test = (name, body) => others || register(name, body);
const tab = await openTab();
const phone = await openTab('dark');
const chapter = chapters.at(-1);

const colours = () => {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(
    [...style].filter(name => name.startsWith('--')).map(name => [name, style.getPropertyValue(name)]),
  );
};
const paper = page => page.evaluate(() => getComputedStyle(document.body).backgroundColor);

test('the theme button turns the page dark, figures too, and the next page remembers', async () => {
  await visit(tab, chapter);
  const line = () =>
    tab.evaluate(() => getComputedStyle(document.querySelector('.plot svg [style*="stroke:var(--plot-"]')).stroke);
  const [light, lightLine] = [await paper(tab), await line()];
  await tab.locator('button.theme').click();
  const dark = await paper(tab);
  assert.notEqual(dark, light);
  assert.notEqual(await line(), lightLine);
  // What a page stores reaches the browser's next process a little later, on a busy machine a little later still.
  let patience = 20;
  do await tab.reload();
  while ((await paper(tab)) !== dark && --patience);
  assert.equal(await paper(tab), dark);
  await visit(tab, 'index.html');
  assert.equal(await paper(tab), dark);
});

test('dark by the button has the colours of dark by the system', async () => {
  await visit(tab, chapter);
  await visit(phone, chapter);
  assert.equal(await tab.evaluate(() => document.documentElement.dataset.theme), 'dark');
  assert.deepEqual(await tab.evaluate(colours), await phone.evaluate(colours));
  await tab.locator('button.theme').click();
  assert.notDeepEqual(await tab.evaluate(colours), await phone.evaluate(colours));
});

test('the copy button copies the lines of the source, and no line numbers', async () => {
  await come(tab, chapter);
  const listing = tab.locator('figure.listing:visible').first();
  await listing.locator('button').click();
  await listing.locator('button', { hasText: 'Copied' }).waitFor();
  const copied = (await tab.evaluate(() => navigator.clipboard.readText())).replace(/\n$/, '').split('\n');
  const [page] = (await listing.locator('a.file').getAttribute('href')).split('#');
  const numbers = await listing.locator('[data-n]').evaluateAll(marks => marks.map(mark => Number(mark.dataset.n)));
  const source = parse(page)('pre').text().split('\n');
  const places = parse(page)('pre [data-n]')
    .toArray()
    .map(mark => Number(mark.attribs['data-n']));
  const lines = numbers.map(n => source[places.indexOf(n)]);
  const indent = Math.min(...lines.filter(line => line.trim()).map(line => line.search(/\S/)));
  assert.deepEqual(
    copied,
    lines.map(line => line.slice(indent)),
  );
});

test('a hint is closed, and opens', async () => {
  await come(tab, chapter);
  const hint = tab.locator('details.hint').first();
  assert.ok(await hint.locator('> :not(summary)').first().isHidden());
  await hint.locator('summary').click();
  assert.ok(await hint.locator('> :not(summary)').first().isVisible());
});

const way = [
  'index.html',
  'two-minutes.html',
  'preface.html',
  ...chapters,
  'pick-a-method.html',
  'cast.html',
  'engines.html',
  'my-thing-does-this.html',
  'forces.html',
  'two-machines.html',
  'checked.html',
  'talks.html',
  'teaching.html',
  'glossary.html',
  'references.html',
];

test('next leads from the first page to the last, and the other link of each page back', async () => {
  await visit(tab, way[0]);
  for (const [i, page] of way.slice(1).entries()) {
    await tab.locator('a[rel=next]').click();
    assert.equal(pageOf(tab), page);
    assert.equal(await tab.locator('a[rel=prev]').getAttribute('href'), way[i]);
  }
});

test('figures have a shape for a desktop and one for a phone', async () => {
  for (const [reader, shown, hidden] of [
    [tab, '.wide', '.narrow'],
    [phone, '.narrow', '.wide'],
  ]) {
    await come(reader, chapter);
    for (const figure of await reader.locator('figure.plot:not([data-live]):not(:has(iframe))').all()) {
      await figure.scrollIntoViewIfNeeded();
      await figure.locator(`${shown} svg`).waitFor();
    }
    const figures = await reader.evaluate(
      sizes => {
        const isVisible = part => {
          if (!part) return false; // not made yet
          const { width, height } = part.getBoundingClientRect();
          return width > 0 && height > 0 && getComputedStyle(part).visibility === 'visible';
        };
        return [...document.querySelectorAll('figure.plot:not([data-live]):not(:has(iframe))')].map(figure => [
          figure.id,
          ...sizes.map(size => isVisible(figure.querySelector(`${size} svg`))),
        ]);
      },
      [shown, hidden],
    );
    assert.ok(figures.length);
    for (const [id, first, second] of figures) {
      assert.ok(first, `${id}: no ${shown}`);
      assert.ok(!second, `${id}: ${hidden} as well`);
    }
  }
});

test('a browser that cannot run the live figures keeps their still pictures', async () => {
  const old = await openTab();
  await old.addInitScript(() => {
    WebAssembly.compile = async () => {
      throw new WebAssembly.CompileError('too new');
    };
  });
  await old.goto(addressOf(chapter));
  const figure = old.locator('figure[data-live]').first();
  await old.evaluate(() => Promise.all(globalThis.Live.started));
  assert.ok(await figure.locator('.still svg:visible').count());
  assert.deepEqual(old.faults, []);
});

test('a chapter prints on white, without menus, with its hints and without its answers', async () => {
  await visit(phone, chapter);
  await phone.emulateMedia({ media: 'print' });
  await phone.evaluate(() => dispatchEvent(new Event('beforeprint')));
  assert.match(await paper(phone), /^rgba?\((255, 255, 255|0, 0, 0, 0\))/);
  const box = await phone.evaluate(() => getComputedStyle(document.querySelector('.listing pre')).backgroundColor);
  assert.ok(
    box
      .match(/\d+/g)
      .slice(0, 3)
      .every(part => part > 200),
    `code is printed on ${box}`,
  );
  for (const menu of ['nav.side', 'button.copy'])
    assert.ok(await phone.locator(menu).first().isHidden(), `${menu} is printed`);
  assert.ok(await phone.locator('details.hint > :not(summary)').first().isVisible());
  assert.ok((await phone.locator('details.answer').count()) > 0);
  assert.equal(await phone.locator(':is(details.answer, details.starter):visible').count(), 0);
  const pdf = await phone.pdf({ format: 'A4' });
  const sheets = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length;
  assert.ok(sheets >= 1 && sheets < 28, `${sheets} sheets`);
});

test('a check mark stands on the line that its sentence ends on, none covers another, and both light up together', async () => {
  for (const page of [chapter, 'index.html']) {
    await visit(tab, page);
    const faults = await tab.evaluate(() => {
      const marks = [...document.querySelectorAll('main :is(p, li) .claim')].filter(e => e.getClientRects().length);
      const boxes = marks.map(e => e.getBoundingClientRect());
      const apart = (a, b) => a.right <= b.left || b.right <= a.left || a.bottom <= b.top || b.bottom <= a.top;
      const off = marks.filter((mark, i) => {
        const range = document.createRange();
        range.setStart(mark.closest('p, li'), 0);
        range.setEndBefore(mark);
        const { top, bottom } = [...range.getClientRects()].filter(r => r.width > 1).at(-1);
        return Math.abs((top + bottom) / 2 - (boxes[i].top + boxes[i].bottom) / 2) > 14;
      });
      const covered = boxes.filter((a, i) => boxes.slice(i + 1).some(b => !apart(a, b)));
      return { off: off.map(e => e.getAttribute('aria-label')), covered: covered.length, marks: marks.length };
    });
    assert.ok(faults.marks > 3);
    assert.deepEqual([faults.off, faults.covered], [[], 0], page);
  }
  await visit(tab, chapter);
  const mark = tab.locator('main > p .claim').first();
  await bringIntoView(tab, mark);
  await mark.hover();
  const lit = () => tab.evaluate(() => [...CSS.highlights.get('claimed')].map(String).join(''));
  assert.match(await lit(), /^\S.{20,}/s);
  await tab.mouse.move(2, 2);
  assert.equal(await lit(), '');
});

test('the menu opens without scripts, and has the sections of the page', async () => {
  const plain = await openTab('dark', { javaScriptEnabled: false });
  await plain.goto(addressOf(chapter));
  const section = plain.locator('.menu .within a').first();
  assert.ok(!(await section.isVisible()));
  await plain.locator('.menu summary').click();
  assert.ok(await section.isVisible());
  assert.ok(!(await plain.locator('.search').isVisible()), 'a search that does nothing');
  await plain.context().close();
});

test('on a phone the bar stays and says the section, and the front page leads back to it', async () => {
  const reader = await openTab('dark');
  await visit(reader, chapter);
  await reader.evaluate(() => document.querySelectorAll('h2')[3].scrollIntoView());
  const bar = reader.locator('.side .place');
  await reader.waitForFunction(() => document.querySelector('.side .place').textContent);
  const section = await bar.textContent();
  assert.ok((await bar.boundingBox()).y < 60);
  await visit(reader, 'index.html');
  const back = reader.locator('.go-on a');
  assert.equal(await back.textContent(), section);
  assert.match(await back.getAttribute('href'), new RegExp(`^${chapter}#`));
  await reader.context().close();
});

test('what the theme button chose is given back to the system', async () => {
  await visit(tab, chapter);
  const light = await paper(tab);
  await tab.locator('.theme').click();
  assert.notEqual(await paper(tab), light);
  await tab.locator('.system').click();
  assert.equal(await paper(tab), light);
  assert.ok(!(await tab.locator('.system').isVisible()));
});

test('the page of all exercises has each of them once, and keeps what was ticked off', async () => {
  const listed = parse('exercises.html')('.tasks th[scope=row] a')
    .map((_, a) => a.attribs.href)
    .get();
  const there = chapters.flatMap(page =>
    parse(page)('section.exercise')
      .map((_, e) => `${page}#${e.attribs.id}`)
      .get(),
  );
  assert.deepEqual(listed, there);
  await visit(tab, 'exercises.html');
  const box = tab.locator('.tasks input').nth(3);
  await box.check();
  await visit(tab, 'exercises.html');
  assert.ok(await box.isChecked());
  await box.uncheck();
  assert.deepEqual(tab.faults, []);
});

if (others)
  register('previous leads from the last page to the first', async () => {
    await visit(tab, way.at(-1));
    for (const page of way.slice(0, -1).reverse()) {
      await tab.locator('a[rel=prev]').click();
      assert.equal(pageOf(tab), page);
    }
  });
