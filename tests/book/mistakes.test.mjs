// The mistakes that a live figure lets its reader make: each is seen, in code, scene and chart, beside the run without it; its order is
// said; and it is taken back.  node mistakes.test.mjs BUILD [others]
// Each is made in the first figure that has it; with "others", in the others.
import assert from 'node:assert/strict';
import { join } from 'node:path';
import { test } from 'node:test';
import '../../book/live/page/module.js';
import { readCsv } from '../../book/weave/csv.mjs';
import { readMistake } from '../../book/live/descriptions.mjs';
import { build } from './book.mjs';
import { openTab } from './browser.mjs';
import { figures, module, open } from './live.mjs';

const choicesOf = ({ controls }, wanted) => Object.keys(controls.find(({ name }) => name === wanted)?.choices ?? {});
const withMistakes = figures.filter(figure => choicesOf(figure, 'own').length);
const others = process.argv.includes('others');
const mistakes = [...new Set(withMistakes.flatMap(figure => choicesOf(figure, 'own')))].filter(name => name !== 'none');

// What each is known to do: the order that is left, and the method that it turns into.
const KNOWN = {
  'constant_acceleration/half-forgotten': [1, 'symplectic Euler'],
  'euler/position-with-new-velocity': [1, 'symplectic Euler'],
  'symplectic_euler/euler-under-its-name': [1, 'Euler'],
  'symplectic_euler/mean-velocity': [1, 'constant acceleration'],
  'midpoint/moves-with-the-old-velocity': [1, ''],
  'midpoint/whole-step-to-the-middle': [1, ''],
  'rk4/fourth-stage-at-the-second': [3, ''],
  'rk4/third-stage-from-the-first': [2, ''],
  'velocity_verlet/halves-and-wholes-swapped': [NaN, ''],
  'yoshida4/three-equal-parts': [2, ''],
};

// By which shares of what is right a step moves the place where nothing pushes, and changes the velocity under a constant push.
const SHARES = { 'velocity_verlet/halves-and-wholes-swapped': [0.5, 1.5] };

const tab = await openTab();

test('each mistake has the order that is known of it, and that its method has with drag', async () => {
  const compiled = await WebAssembly.compile(module);
  const [head, ...rows] = readCsv(join(build, 'cards/register/methods.csv'));
  const orders = new Map(rows.map(row => [row[head.indexOf('function')], Number(row[head.indexOf('drag_order')])]));
  assert.deepEqual(mistakes.sort(), Object.keys(KNOWN).sort());
  for (const name of mistakes) {
    const figure = await globalThis.Live.open(compiled, withMistakes[0].name);
    figure.set('own', name);
    figure.start();
    const { order, rightOrder, is, apart, ...found } = figure.examine();
    assert.deepEqual([order > 0.5 ? Math.round(order) : NaN, is], KNOWN[name], `${name}: ${order}`);
    assert.equal(Math.round(rightOrder), orders.get(readMistake(name).header), `${name}: ${rightOrder}`);
    assert.ok(!is || apart < 1e-15, `${name}: ${apart}`);
    const shares = SHARES[name] ?? [1, 1];
    [found.drifts, found.kicks].forEach((share, i) =>
      assert.ok(Math.abs(share - shares[i]) < 1e-12, `${name}: ${share}`),
    );
  }
});

const first = own => withMistakes.find(figure => choicesOf(figure, 'own').includes(own));
for (const figure of withMistakes) {
  const asked = choicesOf(figure, 'own').filter(own => own !== 'none' && (first(own) !== figure) === others);
  if (!asked.length) continue;
  test(`${figure.name}: each mistake is made, seen and taken back`, async () => {
    const live = await open(tab, figure);
    const chip = own => live.stage.locator(`.chips label:has([value="${own}"])`);
    const methods = choicesOf(figure, 'method');
    for (const own of asked) {
      const { header, words, why } = readMistake(own);
      if (methods.length) await live.control('method').locator(`[value=${header}]`).check();
      if (figure.timed) await live.stage.locator(`.ranked [data-name=${header}]`).click();
      const right = await live.scene();
      assert.equal(await live.stage.locator('.examined').textContent(), '');
      assert.equal(await chip(own).textContent(), ` ${words}`);
      await chip(own).click();
      const code = live.stage.locator('.listing:visible');
      assert.equal(await code.count(), 1);
      assert.ok((await code.locator('ins').count()) > 0, `${own}: the code has no new line`);
      const said = await live.stage.locator('.examined').textContent();
      assert.match(said, /^(Order \d|With shorter steps)/);
      assert.ok(why && said.endsWith(` ${why}`), `${own}: ${said}`);
      await tab.waitForFunction(name => globalThis.Live.opened[name].mistakes.run, figure.name);
      assert.ok((await live.scene()) !== right, `${own} is not seen in the scene`);
      const faint = await tab.evaluate(name => {
        const { mistakes, run } = globalThis.Live.opened[name];
        return [mistakes.run.now.t, run.now.t];
      }, figure.name);
      assert.equal(faint[0], faint[1], 'the run without the mistake is at another time');
      await chip('none').click();
      assert.ok((await live.scene()) === right, `${own} is not taken back`);
    }
    assert.deepEqual(tab.faults, []);
  });
}

test('another method takes the mistake back', async () => {
  const live = await open(
    tab,
    withMistakes.find(({ name }) => name === 'drone-spiral'),
    'method=euler&own=euler/position-with-new-velocity',
  );
  assert.match(await live.stage.locator('.examined').textContent(), /symplectic Euler/);
  await live.control('method').locator('[value=symplectic_euler]').check();
  assert.match(await live.query(), /own=none/);
});
