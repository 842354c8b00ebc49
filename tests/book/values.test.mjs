// Values under numbers and at the points of figures, by mouse, by touch and by keyboard; and marks and keys in the reader's own colours.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { chapters } from './book.mjs';
import { bringIntoView, come, openTab, visit } from './browser.mjs';
import { figures } from './live.mjs';

const tab = await openTab();
const phone = await openTab('dark');
const chapter = chapters.at(-1);

// Of a figure with values: how many there are, and where the one in the middle is on the screen, with what it says.
const middlePoint = drawing =>
  drawing.evaluate(async svg => {
    svg.scrollIntoView({ block: 'center', behavior: 'instant' });
    for (let n = 0; n < 2; ++n) await new Promise(requestAnimationFrame); // a scroll is told of a frame later, and hides what is shown
    const { says, wide, narrow, narrowSays } = JSON.parse(svg.closest('figure').querySelector('.values').textContent);
    const onPhone = svg.closest('.narrow') !== null;
    const [at, words] = onPhone ? [narrow, narrowSays ?? says] : [wide, says];
    const box = svg.getBoundingClientRect(),
      scale = box.width / svg.viewBox.baseVal.width;
    const i = Math.floor(words.length / 2);
    return {
      count: words.length,
      words: words[i],
      x: box.left + at[2 * i] * scale,
      y: box.top + at[2 * i + 1] * scale,
    };
  });
const valued = (reader, size) => reader.locator(`.plot:not([data-live]):has(script.values) ${size} svg`).first();
const tipOf = reader => reader.locator('.tip');

test('a point of a figure shows its value to a mouse that comes near', async () => {
  await come(tab, chapter);
  const { words, x, y } = await middlePoint(valued(tab, '.wide'));
  assert.match(words, /\d/);
  await tab.mouse.move(x, y);
  assert.equal(await tipOf(tab).textContent(), words);
  const ring = await tab.locator('.ring').boundingBox();
  assert.ok(Math.hypot(ring.x + ring.width / 2 - x, ring.y + ring.height / 2 - y) < 1);
  await tab.mouse.move(x + 4, y + 3);
  assert.ok(await tipOf(tab).isVisible(), 'not beside it');
  await tab.mouse.move(0, 0);
  assert.ok(await tipOf(tab).isHidden());
});

test('a finger finds it, too', async () => {
  await come(phone, chapter);
  const drawing = valued(phone, '.narrow');
  const figure = phone.locator('.plot:not([data-live]):has(script.values)').first();
  await figure.scrollIntoViewIfNeeded();
  await drawing.waitFor();
  const { words, x, y } = await middlePoint(drawing);
  await phone.touchscreen.tap(x, y);
  assert.equal(await tipOf(phone).textContent(), words);
});

test('by keyboard the arrows go from value to value, and each is told', async () => {
  await come(tab, chapter);
  const { count } = await middlePoint(valued(tab, '.wide'));
  const stop = tab.locator('.plot:not([data-live]):has(script.values) .wide .points').first();
  assert.match(await stop.getAttribute('aria-label'), /^Values of Figure/);
  await stop.focus();
  const told = async () => [await stop.getAttribute('aria-valuenow'), await stop.getAttribute('aria-valuetext')];
  const first = await told();
  await tab.keyboard.press('ArrowRight');
  const second = await told();
  assert.equal(second[0], '2');
  assert.notDeepEqual(first, second);
  assert.equal(await tipOf(tab).textContent(), second[1]);
  await tab.evaluate(() => scrollBy(0, 40));
  await tab.waitForFunction(words => document.querySelector('.tip:not([hidden])')?.textContent === words, second[1]);
  const height = () =>
    tab
      .locator('.ring')
      .boundingBox()
      .then(({ y }) => y);
  const before = await height();
  await tab.keyboard.press('ArrowUp');
  const above = await height();
  await tab.keyboard.press('ArrowDown');
  assert.ok(above < before || (await height()) > above, 'up and down go nowhere');
  await tab.keyboard.press('End');
  assert.equal((await told())[0], String(count));
  await tab.keyboard.press('ArrowRight');
  assert.equal((await told())[0], String(count));
  await tab.keyboard.press('Escape');
  assert.ok(await tipOf(tab).isHidden());
});

test('by keyboard the numbers of a paragraph are one stop, and the arrows go through all of the page', async () => {
  await come(tab, chapter);
  const stops = await tab.evaluate(() => {
    const homes = [...document.querySelectorAll('data.number')].map(number => [
      number.closest('p, li, td, th, dd, figcaption'),
      number.tabIndex,
    ]);
    return { homes: new Set(homes.map(([home]) => home)).size, stops: homes.filter(([, index]) => index === 0).length };
  });
  assert.equal(stops.stops, stops.homes);
  await tab.locator('data.number').first().focus();
  const first = await tipOf(tab).textContent();
  await tab.keyboard.press('ArrowRight');
  assert.notEqual(await tipOf(tab).textContent(), first);
  await tab.keyboard.press('ArrowLeft');
  assert.equal(await tipOf(tab).textContent(), first);
});

test('a number shows its full value', async () => {
  await come(tab, chapter);
  const number = tab.locator('data.number').first();
  await bringIntoView(tab, number);
  await number.hover();
  const tip = (await tab.locator('.tip').textContent()).replace(/\u202f/g, '').replace(/\u2212/g, '-');
  const [mantissa] = (await number.getAttribute('value')).split('e');
  assert.ok(tip.includes(` = ${mantissa}`), tip);
});

test('with colours of the reader’s own, marks are seen', async () => {
  await visit(tab, figures[0].page);
  await tab.emulateMedia({ forcedColors: 'active' });
  const unseen = await tab.evaluate(() => {
    const ground = getComputedStyle(document.body).backgroundColor;
    const marks = [...document.querySelectorAll('.claim')];
    return [marks.length, marks.filter(mark => getComputedStyle(mark).backgroundColor === ground).length];
  });
  await tab.emulateMedia({ forcedColors: null });
  assert.ok(unseen[0] > 0);
  assert.equal(unseen[1], 0);
});
