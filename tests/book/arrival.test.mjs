// Where a link leads: to its target, for readers who like motion too, and nowhere else while a page comes to life.
//   node arrival.test.mjs BUILD [others]
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { chapters, parse, read } from './book.mjs';
import { addressOf, openTab, pageOf, visit } from './browser.mjs';

const liveChapters = chapters.filter(page => read(page).includes(' data-live='));
const last = (page, selector) => `${page}#${parse(page)(selector).last().attr('id')}`;
// Deep in each page, below its live figures
const deep = page => [last(page, 'main figure.plot:not([data-live])'), last(page, 'h2'), last(page, '[id^=cited-]')];

// Without scroll anchoring, as in browsers that have none, what grows above pushes down what is read.
const loose = () => {
  const sheet = new CSSStyleSheet();
  sheet.replaceSync('* { overflow-anchor: none !important; }');
  document.adoptedStyleSheets = [sheet];
};
// The live figures wait until the test lets them run.
const held = () => {
  const { compile } = WebAssembly;
  const released = new Promise(done => {
    globalThis.release = done;
  });
  WebAssembly.compile = async bytes => {
    await released;
    return compile(bytes);
  };
};

async function reader({ width, height, touch, anchored }) {
  const tab = await openTab('light', {
    viewport: { width, height },
    hasTouch: touch,
    isMobile: touch,
    reducedMotion: 'no-preference',
  });
  if (!anchored) await tab.addInitScript(loose);
  return tab;
}

// Nothing glides any more, and nothing is still to come: what glides does so in every frame. Figures that are held may come later.
async function settled(tab) {
  await tab.waitForFunction(
    () =>
      document.readyState === 'complete' &&
      document.fonts.status === 'loaded' &&
      (globalThis.release || [...document.querySelectorAll('[data-live]')].every(e => e.classList.contains('live'))),
  );
  await tab.evaluate(async () => {
    const place = () => `${scrollY} ${document.documentElement.scrollHeight}`;
    let before;
    for (let same = 0; same < 6;) {
      await new Promise(requestAnimationFrame);
      same = place() === before ? same + 1 : 0;
      before = place();
    }
  });
}

// At the top, but for the room that the style sheet leaves; or the page has no more to scroll.
async function assertAt(tab, id, how) {
  await settled(tab);
  const found = await tab.evaluate(of => {
    const root = document.documentElement;
    return {
      top: document.getElementById(of).getBoundingClientRect().top,
      room: parseFloat(getComputedStyle(root).scrollPaddingTop),
      below: root.scrollHeight - innerHeight - scrollY,
    };
  }, id);
  const { top, room, below } = found;
  assert.ok(
    Math.abs(top - room) < 3 || (top > 0 && below < 2),
    `${how}: ${pageOf(tab)}#${id} is ${top} px from the top, not ${room}`,
  );
}
const idOf = link => link.slice(link.indexOf('#') + 1);

// A place in the text, as a reader sees it, and where it is on the screen.
const placeRead = tab =>
  tab.evaluate(() => {
    const paragraphs = [...document.querySelectorAll('main p')].filter(p => !p.closest('figure, details'));
    const i = paragraphs.findIndex(p => p.getBoundingClientRect().top > 100);
    return { i, top: paragraphs[i].getBoundingClientRect().top };
  });
async function assertRead(tab, { i, top }, how) {
  await settled(tab);
  const now = await tab.evaluate(
    n =>
      [...document.querySelectorAll('main p')].filter(p => !p.closest('figure, details'))[n].getBoundingClientRect()
        .top,
    i,
  );
  assert.ok(Math.abs(now - top) < 3, `${how}: what was read at ${top} px is at ${now}`);
}

const readers = [
  ['a desktop', { width: 1440, height: 900, touch: false, anchored: true }],
  ['a phone', { width: 390, height: 844, touch: true, anchored: true }],
  ['a desktop without scroll anchoring', { width: 1440, height: 900, touch: false, anchored: false }],
  ['a phone without scroll anchoring', { width: 390, height: 844, touch: true, anchored: false }],
];
// The first and the last one differ in all; what is in between is for the tier `thorough`.
const between = process.argv.includes('others');
const asked = readers.filter((_, i) => between === (i === 1 || i === 2));
// Two readers at once: most of the time each waits for a page to come to rest.
describe('where links land', { concurrency: asked.length }, () => {
  for (const [name, look] of asked)
    describe(name, { concurrency: 1 }, () => {
      const page = liveChapters.at(-1),
        i = readers.findIndex(([other]) => other === name);
      let tab;
      before(async () => {
        tab = await reader(look);
      });

      test('a link from elsewhere to a figure, a heading or a claim lands there', async () => {
        for (const [n, chapter] of liveChapters.entries()) {
          const link = deep(chapter)[(i + n) % 3];
          await visit(tab, link);
          await assertAt(tab, idOf(link), 'opened');
        }
      });

      test('a citation on the page of claims, a word of the glossary and a search hit land where they point', async () => {
        const far = selector => tab.locator(selector).last();
        for (const [from, link] of [
          ['claims.html', far(`a[href^="${page}#cited-"]`)],
          ['glossary.html', far('main a[href*=".html#"]')],
        ]) {
          await visit(tab, from);
          const id = idOf(await link.getAttribute('href'));
          await link.click();
          await tab.waitForURL(url => url.hash === `#${id}`);
          await assertAt(tab, id, `from ${from}`);
        }
        await visit(tab, 'index.html');
        await tab.keyboard.press('/');
        const heading = parse(page)('main h2').eq(-2);
        await tab.keyboard.type(heading.contents().eq(1).text().trim());
        const hit = tab.locator(`.search a[href="${page}#${heading.attr('id')}"]`);
        await hit.waitFor();
        const id = idOf(await hit.getAttribute('href'));
        await hit.click();
        await tab.waitForURL(url => url.hash === `#${id}`);
        await assertAt(tab, id, 'a search hit');
      });

      test('a link within the page lands, back goes to where it was clicked, and forward to its target', async () => {
        await visit(
          tab,
          liveChapters.findLast(chapter => parse(chapter)('main > p a[href^="#eq-"]').length),
        );
        const link = tab.locator('main > p a[href^="#eq-"]').last();
        const id = idOf(await link.getAttribute('href'));
        await link.scrollIntoViewIfNeeded();
        await settled(tab);
        const read = await placeRead(tab);
        await link.click();
        await assertAt(tab, id, 'clicked');
        await tab.goBack();
        await assertRead(tab, read, 'back');
        await tab.goForward();
        await assertAt(tab, id, 'forward');
      });

      test('after a reload, and after another page and back, the reader is where they were', async () => {
        const [, heading] = deep(page);
        await visit(tab, heading);
        await settled(tab);
        await tab.evaluate(() => scrollBy({ top: -1500, behavior: 'instant' }));
        await settled(tab);
        const read = await placeRead(tab);
        await tab.reload();
        await assertRead(tab, read, 'reloaded');
        await visit(tab, 'glossary.html');
        await tab.goBack();
        await assertRead(tab, read, 'back from another page');
      });

      test('who scrolls before the live figures run is left where they are', async () => {
        const late = await reader(look);
        await late.addInitScript(held);
        const [figure] = deep(page);
        await late.goto(addressOf(figure));
        await settled(late);
        if (look.touch) await late.touchscreen.tap(200, 300);
        await late.mouse.wheel(0, -700);
        await settled(late);
        const read = await placeRead(late);
        await late.evaluate(() => {
          globalThis.release();
          delete globalThis.release;
        });
        await assertRead(late, read, 'once the figures run');
      });
    });
});
