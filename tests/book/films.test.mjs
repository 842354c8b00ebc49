// The films: node films.test.mjs BUILD SOURCE. Each plays, stops, and can be moved by hand; and their colours are the book's.
import assert from 'node:assert/strict';
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { folder } from './book.mjs';
import { openTab, visit } from './browser.mjs';
import { readPalette } from './palette.mjs';

const [, , build, source] = process.argv;
const films = readdirSync(join(folder, 'films'));
const time = tab => tab.locator('input').inputValue().then(Number);
const picture = tab => tab.locator('canvas').evaluate(canvas => canvas.toDataURL());

test('there is a film for each chapter', () => assert.ok(films.length > 0));

for (const film of films) {
  test(`${film} plays, stops, and goes where the slider is put`, async () => {
    const tab = await openTab('light', { reducedMotion: 'no-preference' });
    await visit(tab, `films/${film}`);
    assert.ok((await time(tab)) < 3, 'it starts in the middle');
    await tab.locator('input').fill('0'); // which stops it
    const start = await picture(tab);
    await tab.locator('button').click();
    await tab.waitForFunction(() => document.querySelector('input').value > 0.3);
    assert.ok((await picture(tab)) !== start, 'nothing moves');
    await tab.locator('button').click();
    const at = await time(tab);
    await tab.waitForTimeout(300);
    assert.equal(await time(tab), at, 'it goes on after Stop');
    await tab.locator('input').fill('0');
    assert.ok((await picture(tab)) === start, 'the slider at its start shows another picture');
    await tab.locator('input').evaluate(slider => {
      slider.value = slider.max - 0.1;
    });
    await tab.locator('button').click();
    await tab.waitForFunction(() => document.querySelector('button').textContent === 'Play');
    assert.deepEqual(tab.faults, []);
    await tab.context().close();
  });
}

test('who wants no motion sees the last picture, and may play it', async () => {
  const tab = await openTab('dark');
  await visit(tab, `films/${films[0]}`);
  const at = await time(tab);
  assert.ok(at > 0.999 * Number(await tab.locator('input').getAttribute('max')));
  await tab.waitForTimeout(300);
  assert.equal(await time(tab), at);
  await tab.locator('button').click();
  await tab.waitForFunction(end => document.querySelector('input').value < end, at);
  assert.deepEqual(tab.faults, []);
  await tab.context().close();
});

test('a film has the colours that the book has', async () => {
  const { methods, others, value } = readPalette(source, build);
  const names = Object.fromEntries([
    ...[...methods, { ...others.EXACT, name: 'true' }, { ...others.CONTEXT, name: 'scenery' }].map(style => [
      style.name,
      `plot-${style.colour}`,
    ]),
    ['paper', 'paper'],
    ['ink', 'ink'],
  ]);
  const tab = await openTab();
  await visit(tab, `films/${films[0]}`);
  const colours = await tab.evaluate('colours');
  for (const [scheme, table] of Object.entries(colours))
    for (const [name, shade] of Object.entries(table))
      assert.equal(shade, value(scheme, names[name]), `${scheme}: ${name}`);
  await tab.context().close();
});
