// A step that a reader writes where methods are ranked: it stands in the place of one, in table, scene, chart and list.
//   node edit-ranking.test.mjs BUILD
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openTab, visit } from './browser.mjs';
import { RK4 } from './typed.mjs';

const NAMED = /Order 4 in place of 1\. Its steps are those of RK4/;

const tab = await openTab();
await visit(tab, '7-which-to-use.html');

// Opens the lines of a method in a figure that shows them, and writes others.
async function write(name, text) {
  const stage = tab.locator(`[data-live="${name}"] .stage`);
  await stage.locator('.edit').click();
  await stage.locator('.compiled', { hasText: 'Compiled in' }).waitFor({ timeout: 60000 });
  await stage.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
  await stage.locator('.examined', { hasText: NAMED }).waitFor({ timeout: 20000 });
  await tab.waitForFunction(of => globalThis.Live.opened[of].mistakes.run, name);
  return stage;
}
const nowOf = name => tab.evaluate(of => ({ ...globalThis.Live.opened[of].run.now }), name);
const close = (a, b, what) => assert.ok(Math.abs(a / b - 1) < 1e-6, `${what}: ${a}, ${b}`);

test('in the table of the level it has a row, with the errors of the method that it is', async () => {
  const stage = tab.locator('[data-live="level"] .stage');
  await stage.locator('[data-control=method] [value=euler]').check();
  await write('level', RK4);
  const { errors } = await nowOf('level');
  const { method } = await tab.evaluate(() => globalThis.Live.opened.level.run.module.settings);
  for (let thing = 0; thing < 6; ++thing) {
    const at = name => errors[10 * thing + method.indexOf(name)];
    if (at('rk4') > 1e-9 && at('rk4') < Infinity) close(at('euler'), at('rk4'), `thing ${thing}`);
    else assert.equal(at('euler') > 1e-9 && at('euler') < Infinity, false, `thing ${thing}`);
  }
  assert.match(await stage.locator('.readout').textContent(), /Yours has the shuttle/);
});

test('in the ranking it has its errors, and the price of its evaluations', async () => {
  const name = 'speed-against-accuracy';
  const stage = tab.locator(`[data-live="${name}"] .stage`);
  await stage.locator('[data-control=thing] [value=shuttle]').check();
  await stage.locator('.ranked [data-name=euler]').click();
  await write(name, RK4);
  const now = await nowOf(name);
  assert.equal(now['euler evaluations'], 4);
  Object.values(now['euler errors']).forEach((error, i) => close(error, now['rk4 errors'][i], `rung ${i}`));
  const row = stage.locator('.ranked tr', { hasText: 'Yours' });
  const timeOf = one => one.locator('td').last().textContent();
  const rk4 = await timeOf(stage.locator('.ranked tr:has([data-name=rk4])'));
  assert.equal(await timeOf(row), `≈\u202f${rk4}`);
  assert.match(await stage.locator('.ranked p').textContent(), /≈: as RK4 takes for as many evaluations/);
  // Another method's row is watched meanwhile, and the reader's lines stay.
  await stage.locator('.ranked [data-name=yoshida4]').click();
  assert.equal(await stage.locator('.listing.edited:visible').count(), 1);
  await stage.getByRole('button', { name: 'Back to the book’s' }).click();
  assert.equal(await stage.locator('.ranked tr', { hasText: 'Yours' }).count(), 0);
});

test('on the reader’s own spring it stands in the map of its place', async () => {
  const stage = tab.locator('[data-live="your-spring"] .stage');
  await stage.locator('[data-control=method] [value=euler]').check();
  await write('your-spring', RK4);
  const now = await nowOf('your-spring');
  close(now.euler, now.rk4, 'stretch');
  assert.match(await stage.locator('.readout').textContent(), /Yours has/);
});

test('in the shears the cat is carried by it', async () => {
  await visit(tab, '6-symplectic.html');
  const stage = tab.locator('[data-live="shears"] .stage');
  await stage.locator('[data-control=method] [value=euler]').check();
  const euler = await nowOf('shears');
  await write('shears', RK4);
  const { area } = await nowOf('shears');
  assert.ok(euler.area > 150, `${euler.area}`);
  assert.ok(area > 80 && area < 120, `${area}`);
  assert.deepEqual(tab.faults, []);
});
