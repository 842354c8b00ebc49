// "Try it" on the page of a header and on the page to pick a method, from disk: the header's own example runs, can be changed, and
// comes back.  node try-it.test.mjs BUILD
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessibility } from './accessibility.mjs';
import { openTab, visit } from './browser.mjs';

const tab = await openTab();
const told = words =>
  tab.waitForFunction(
    expected => new RegExp(expected).test(document.querySelector('.program .compiled')?.textContent ?? ''),
    words,
    { timeout: 120_000 }, // other tests run beside it
  );
const printed = () => tab.locator('.printed').textContent();
const change = async (from, to) => {
  const text = (await tab.locator('.cm-line').allTextContents()).join('\n');
  assert.ok(text.includes(from), text);
  await tab.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text.replace(from, to));
};
const run = async words => {
  await tab.getByRole('button', { name: 'Run', exact: true }).click();
  await told('Compiling');
  await told(words);
};

test('the example over Euler’s method runs, and with shorter steps it comes nearer', async () => {
  await visit(tab, 'integrate-euler.html');
  await tab.getByRole('button', { name: 'Try it: euler.h' }).click();
  await told('^It ran\\.$');
  const [, x] = (await printed()).match(/^x is (-?[\d.]+), v is -?[\d.]+\n$/);
  await change(
    'for (int n = 0; n < 60; ++n) integrate::euler(x, v, n / 60.0, 1 / 60.0, spring);',
    'for (int n = 0; n < 6000; ++n) integrate::euler(x, v, n / 6000.0, 1 / 6000.0, spring);',
  );
  await run('^It ran\\.$');
  const [, nearer] = (await printed()).match(/^x is (-?[\d.]+)/);
  const w = Math.sqrt(9 - 0.25);
  const right = Math.exp(-0.5) * (Math.cos(w) + (0.5 / w) * Math.sin(w));
  assert.ok(Math.abs(nearer - right) < Math.abs(x - right) / 50, `${x}, ${nearer}, ${right}`);
  await change('integrate::euler', 'integrate::oyler');
  await run("^Line \\d+: no member named 'oyler' in namespace 'integrate'");
  await tab.getByRole('button', { name: 'Back to the example' }).click();
  await run('^It ran\\.$');
  assert.equal((await printed()).match(/^x is (-?[\d.]+)/)[1], x);
  assert.deepEqual(tab.faults, []);
  assert.deepEqual(await accessibility(tab), []);
});

test('where a method is picked, its example can be tried', async () => {
  await visit(tab, 'pick-a-method.html');
  for (const fold of await tab.locator('details').all()) await fold.evaluate(one => (one.open = true));
  await tab.getByRole('button', { name: 'Try it: yoshida4.h' }).first().click();
  await told('^It ran\\.$');
  assert.match(await printed(), /^x is -?[\d.]+, v is -?[\d.]+\n$/);
  assert.deepEqual(tab.faults, []);
});

test('a browser with too little memory for the compiler says so', async () => {
  await visit(tab, 'integrate-euler.html');
  await tab.evaluate(() => {
    let thread;
    const full = `WebAssembly.compile = WebAssembly.instantiate = async () => {
      throw new RangeError('WebAssembly.instantiate(): Out of memory');
    };\n`;
    const worker = { get: () => full + thread, set: text => (thread = text) };
    Object.defineProperty((globalThis.Compiled ??= {}), 'worker', worker);
  });
  await tab.getByRole('button', { name: 'Try it: euler.h' }).click();
  await told('^This browser has not enough memory for the compiler\\.$');
  tab.faults.length = 0;
});
