// The figure that sets speed against accuracy: what it ranks, where it is taken hold of, and the times that it takes itself.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openTab } from './browser.mjs';
import { figureOf, hold, open } from './live.mjs';

const figure = figureOf('speed-against-accuracy');
const tab = await openTab();

// The list as the reader sees it.
const ranking = live =>
  live.stage.locator('.ranked tbody tr').evaluateAll(rows =>
    rows.map(row => {
      const [, method, steps, off, time] = [...row.cells].map(cell => cell.textContent);
      return { method, steps: Number(steps), off, microseconds: Number(time.match(/^[\d.]+/)[0]) };
    }),
  );

// What each method offers, worked out from what the module shows and the recorded times.
async function offers(live, thing) {
  const now = await live.now();
  const {
    method,
    thing: things,
    nanoseconds,
  } = await tab.evaluate(name => globalThis.Live.descriptions[name].tables['recorded-steps'], figure.name);
  const fitting = Object.entries(figure.methods).filter(([name]) => Object.values(now[`${name} errors`]).length);
  return fitting.map(([name, label]) => {
    const step = nanoseconds[method.findIndex((one, i) => one === name && things[i] === thing)];
    return {
      label,
      rungs: Object.values(now.tried).map((steps, i) => ({
        steps,
        time: steps * step,
        error: now[`${name} errors`][i],
      })),
    };
  });
}

test('the list has all methods for the thing, nearest first, within the price, and marks those near enough', async () => {
  for (const [thing, price, tolerance] of [
    ['suspension', 5, 3e-4],
    ['hatch', 20, 0.01],
    ['shuttle', 70, 1e-3],
    ['jump', 2, 0.01],
  ]) {
    const live = await open(tab, figure, `thing=${thing}&price=${price}&tolerance=${tolerance}`);
    const bounds = await tab.evaluate(name => globalThis.Live.opened[name].values, figure.name);
    assert.deepEqual([bounds.price, bounds.tolerance], [price, tolerance]);
    const rows = await ranking(live);
    const all = await offers(live, thing);
    assert.deepEqual(rows.map(({ method }) => method).sort(), all.map(({ label }) => label).sort());
    assert.ok(all.length >= 10 && all.some(({ label }) => label === 'BDF2'), thing);
    let last = 0;
    for (const { method, steps, off, microseconds } of rows) {
      const { rungs } = all.find(({ label }) => label === method);
      const paid = rungs.filter(({ time }) => time <= price);
      const where = `${thing}: ${method}, ${steps} steps`;
      assert.equal(off === 'too dear', paid.length === 0, where);
      const taken = rungs.find(rung => rung.steps === steps);
      assert.ok(Math.abs(microseconds / taken.time - 1) < 0.06, where);
      if (!paid.length) {
        last = Infinity;
        continue;
      }
      assert.ok(microseconds <= 1.06 * price, where);
      assert.ok(
        taken.error <= Math.min(...paid.map(({ error }) => error)) + 1e-9,
        `${where}: another number is nearer`,
      );
      assert.ok(Math.max(taken.error, 1e-9) >= last, `${where}: nearer than the one above`);
      assert.equal(off.includes('✓'), taken.error <= tolerance, where);
      last = Math.max(taken.error, 1e-9);
    }
  }
});

test('price and tolerance are taken hold of in the chart, and a method is picked there and in the list', async () => {
  const phone = await openTab('dark');
  for (const reader of [tab, phone]) {
    const live = await open(reader, figure);
    const price = () => reader.evaluate(name => globalThis.Live.opened[name].values.price, figure.name);
    const canvas = live.stage.locator('canvas.plot');
    const { width, height } = await canvas.boundingBox();
    const first = await price();
    await canvas.click({ position: { x: 0.6 * width, y: 0.98 * height } }); // below all dots
    const dearer = await price();
    assert.ok(dearer > first, `${dearer}`);
    const box = await canvas.boundingBox();
    await reader.mouse.move(box.x + 0.6 * width, box.y + height / 2);
    await reader.mouse.down();
    await reader.mouse.move(box.x + 0.3 * width, box.y + height / 2, { steps: 4 });
    await reader.mouse.up();
    assert.ok((await price()) < dearer);
    const chart = () =>
      reader.evaluate(name => {
        const { chart, drawing, values } = globalThis.Live.opened[name];
        const { picked, found, lines } = drawing;
        const last = found.all.find(({ name }) => name === 'euler').rungs[0];
        const { pen } = chart;
        return {
          picked,
          tolerance: values.tolerance,
          shown: found.three.map(({ name }) => name),
          line: pen.y(lines.tolerance),
          euler: { x: pen.x(Math.log10(last.time)), y: pen.y(Math.log10(last.error)) },
        };
      }, figure.name);
    const before = await chart();
    await reader.mouse.move(box.x + 0.1 * width, box.y + before.line);
    await reader.mouse.down();
    await reader.mouse.move(box.x + 0.2 * width, box.y + before.line + 0.2 * height, { steps: 4 });
    await reader.mouse.up();
    const tighter = await chart();
    assert.ok(tighter.tolerance < before.tolerance, `${tighter.tolerance}`);
    await canvas.click({ position: before.euler });
    assert.equal((await chart()).picked, 'euler');
    assert.ok((await chart()).shown.includes('euler'));
    await live.stage.locator('.ranked [data-name=symplectic_euler]').press('Enter');
    assert.ok((await chart()).shown.includes('symplectic_euler'));
    assert.equal(await canvas.evaluate(element => getComputedStyle(element).touchAction), 'pan-y');
    assert.deepEqual(reader.faults, []);
  }
});

test('the live choice takes its own times beside the page, and draws them over the recorded ones', async () => {
  const live = await open(tab, figure, 'thing=leaf&price=70');
  const [before, chart] = [await live.now(), await live.chart()];
  assert.match(await live.stage.locator('.ranked').textContent(), /as recorded/);
  await live.press('time');
  await live.stage.locator('.ranked', { hasText: /: taken in/ }).waitFor({ timeout: 120_000 });
  const times = await tab.evaluate(name => globalThis.Live.opened[name].run.times, figure.name);
  assert.deepEqual(Object.keys(times), Object.keys(figure.methods));
  const now = await live.now();
  for (const [name, time] of Object.entries(times)) {
    const fits = Object.values(now[`${name} errors`]).length > 0;
    assert.equal(time > 0 && Number.isFinite(time), fits, name);
  }
  assert.notEqual(await live.chart(), chart);
  assert.deepEqual(await live.now(), before);
  assert.deepEqual(tab.faults, []);
});

test('a place in a map is a spring for its method', async () => {
  const name = 'your-spring';
  const live = await hold(tab, { name });
  const canvas = live.stage.locator('canvas.scene');
  const { width, height } = await canvas.boundingBox();
  const first = await live.query();
  await canvas.click({ position: { x: 0.12 * width, y: 0.28 * height } });
  const { method, omega, zeta, rate } = await tab.evaluate(of => globalThis.Live.opened[of].values, name);
  assert.equal(method, 'rk4');
  assert.notEqual(await live.query(), first);
  // The map is 4 wide and 2 high, and has 37 % of a column's width and 65 % of a row's height.
  const right = (0.24 - 0.03) / 0.37;
  const up = (6 * 0.72 - 4 - 0.06) / 0.65;
  assert.ok(Math.abs(omega / rate / (4 * right) - 1) < 0.15, `${omega} of ${rate}`);
  assert.ok(Math.abs(zeta - 2 * up) < 0.06, `${zeta}`);
  assert.deepEqual(tab.faults, []);
});
