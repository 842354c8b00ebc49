// A step that a reader writes in a live figure, from disk: compiled, moved, named and judged by its order; and what cannot be compiled or
// would never end.  node edit-figure.test.mjs BUILD
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { accessibility } from './accessibility.mjs';
import { openTab, visit } from './browser.mjs';
import { RK4 } from './typed.mjs';

const PAGE = '2-euler.html';
const NAME = 'drone-spiral';
const tab = await openTab();
const figure = tab.locator(`[data-live="${NAME}"]`);
const seen = async (selector, words) => {
  const pattern = String(words.source ?? words);
  await tab.waitForFunction(
    ([of, what, expected]) =>
      new RegExp(expected).test(document.querySelector(`[data-live="${of}"] ${what}`)?.textContent),
    [NAME, selector, pattern],
    { timeout: 20000 },
  );
};
const write = async text => {
  await figure.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.keyboard.insertText(text);
};
const SWAPPED = 'const Vec a = acceleration(x, v, t);\nv = v + h * a;\nx = x + h * v;';

test('nothing of the compiler is there before somebody presses Edit', async () => {
  const asked = [];
  tab.on('request', request => asked.push(request.url()));
  await visit(tab, PAGE);
  assert.deepEqual(
    asked.filter(address => /\/compiler\//.test(address)),
    [],
  );
});

test('the book’s own lines, compiled in the page, are its method to the last bit', async () => {
  await figure.locator('.edit').click();
  await figure.locator('.comes progress').waitFor();
  await seen('.compiled', 'Compiled in');
  await seen('.examined', 'Order 1, as the book’s. Its steps are those of Euler, to the last bit.');
});

test('an RK4 of one’s own moves, and is named', async () => {
  await write(RK4);
  await seen('.examined', /Order 4 in place of 1\. Its steps are those of RK4, to (the last bit|1e-1[56])/);
  const { distance } = await tab.evaluate(name => globalThis.Live.opened[name].run.now, NAME);
  assert.ok(Math.abs(distance - 10) < 1e-3, `${distance} m`);
  assert.equal(await figure.locator('.listing:visible').count(), 1);
  assert.deepEqual(tab.faults, []);
  assert.deepEqual(await accessibility(tab), []); // which knocks at the frame of the film, and it doesn't answer
  tab.faults.length = 0;
});

test('a mistake stands under its line, and the last version goes on', async () => {
  await write('const Vec a = acceleration(x, v, t);\nx = x + h * b;\nv = c;');
  await seen('.said', 'use of undeclared identifier .b.');
  await seen('.said details', 'Line 3: use of undeclared identifier .c.');
  await seen('.compiled', 'Your last version goes on');
  await seen('.examined', 'RK4');
});

for (const [what, code] of [
  ['a step that never ends', 'while (x.x > -1e9) x = x + 0 * v;'],
  ['a loop with nothing in it', 'while (true) {}'],
  [
    'a step that calls itself for ever',
    'auto f = [](auto self, double y) -> double { return 1 + self(self, y + 1); };\nx.x = f(f, x.x);',
  ],
  ['a trap', '__builtin_trap();'],
])
  test(`${what} is stopped, and the page lives`, async () => {
    await write(code);
    await seen('.examined', 'Your step was stopped');
    await seen('.compiled', 'Your step was stopped');
    assert.equal(await tab.evaluate(() => 1 + 1), 2);
  });

for (const [what, code, words] of [
  [
    'half of each kick',
    'v = v + h / 2 * acceleration(x, v, t); x = x + h * v;',
    'changes the velocity by 0\\.5 times what it should',
  ],
  [
    'a drift twice',
    'v = v + h * acceleration(x, v, t); x = x + 2 * h * v;',
    'moves the place by 2 times what it should',
  ],
  [
    'a term that was doubled',
    'const Vec a = acceleration(x, v, t); x = x + h * v - h * h / 2 * a; v = v + h * a;',
    /^Order 1, as the book’s, and in the same short steps [\d.]+ times as far off\.$/,
  ],
])
  test(`${what} is told from others`, async () => {
    await write(code);
    await seen('.examined', words);
  });

test('what is not a number is drawn as nothing', async () => {
  await write('x = x / 0; x = x - x;');
  await seen('.examined', 'it has no order');
});

test('a megabyte of text is no step', async () => {
  await figure.locator('.cm-content').click();
  await tab.keyboard.press('Control+A');
  await tab.evaluate(text => navigator.clipboard.writeText(text), 'x = x;\n'.repeat(150_000));
  await tab.keyboard.press('Control+V');
  await seen('.compiled', 'No step has');
});

test('one press is back at the book’s', async () => {
  await figure.getByRole('button', { name: 'Back to the book’s' }).click();
  await seen('.examined', '^$');
  assert.equal(await tab.evaluate(name => globalThis.Live.opened[name].values.own, NAME), 'none');
});

test('a link brings what was written, and it runs once Edit is pressed', async () => {
  await figure.locator('.edit').click();
  await write(SWAPPED);
  await seen('.examined', 'symplectic Euler');
  await figure.locator('[data-do=link]').click();
  const address = await tab.evaluate(() => location.href);
  assert.ok(address.length < 600, `${address.length} letters`);
  const other = await openTab('light');
  await other.goto(address);
  const there = other.locator(`[data-live="${NAME}"]`);
  await there.locator('.examined', { hasText: 'This link brings a step of its own' }).waitFor();
  await there.locator('.edit').click();
  await there.locator('.examined', { hasText: 'symplectic Euler' }).waitFor({ timeout: 60000 });
  assert.deepEqual(other.faults, []);
  assert.deepEqual(tab.faults, []);
});
