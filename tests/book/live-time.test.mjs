// The time of a live figure is the reader's: in the chart, while a knob is held, and from words in the prose.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { frames, openTab } from './browser.mjs';
import { figureOf, open } from './live.mjs';

const figure = figureOf('drone-spiral');
const tab = await openTab();
const live = await open(tab, figure);
const moment = live.stage.locator('.moment');
const t = async () => (await live.now()).t;
const near = (seconds, wanted) =>
  assert.ok(Math.abs(seconds - wanted) < 0.02 * figure.seconds, `${seconds}, not ${wanted}`);

test('the figure is a group with its name', async () => {
  const caption = await tab.locator(`[data-live="${figure.name}"] figcaption b`).textContent();
  assert.equal(await live.stage.getAttribute('aria-label'), caption);
});

test('the chart goes to a moment, by a click, by a drag back, and by keys', async () => {
  const { x, y, width, height } = await live.stage.locator('.u-over').boundingBox();
  await tab.mouse.click(x + 0.4 * width, y + height / 2);
  near(await t(), 0.4 * figure.seconds);
  const scene = await live.scene();
  await tab.mouse.move(x + 0.4 * width, y + height / 2);
  await tab.mouse.down();
  await tab.mouse.move(x + 0.2 * width, y + height / 2, { steps: 3 });
  await tab.mouse.up();
  near(await t(), 0.2 * figure.seconds);
  assert.notEqual(await live.scene(), scene);
  await moment.focus();
  await tab.keyboard.press('ArrowRight');
  near(await t(), 0.21 * figure.seconds);
  near(Number(await moment.getAttribute('aria-valuenow')), await t());
  await tab.keyboard.press('End');
  near(await t(), figure.seconds);
  await tab.keyboard.press('Home');
  assert.equal(await t(), 0);
});

test('a knob that is held leaves the time where it is, and shows the whole run, which goes when it is let go', async () => {
  await live.reopen();
  const { x, y, width, height } = await live.stage.locator('.u-over').boundingBox();
  await tab.mouse.click(x + 0.25 * width, y + height / 2);
  const before = await t();
  const knob = await live.control('rate').locator('input').boundingBox();
  await tab.mouse.move(knob.x + 0.625 * knob.width, knob.y + knob.height / 2);
  await tab.mouse.down();
  await tab.mouse.move(knob.x + 0.4 * knob.width, knob.y + knob.height / 2, { steps: 3 });
  near(await t(), before);
  const held = await live.scene();
  await tab.mouse.up();
  await frames(tab, 2);
  assert.notEqual(await live.scene(), held);
  near(await t(), before);
  assert.match(await tab.evaluate(of => globalThis.Live.opened[of].chart.before.words, figure.name), /^before: 60/);
  await live.press('reset');
  assert.equal(await tab.evaluate(of => globalThis.Live.opened[of].chart.before, figure.name), undefined);
});

test('a run that is played goes on from where it is when a setting changes', async () => {
  await live.press('reset');
  await live.press('play');
  await tab.waitForFunction(of => globalThis.Live.opened[of].run.now.t > 4, figure.name);
  await live.control('rate').locator('input').focus();
  await tab.keyboard.press('ArrowRight');
  assert.ok((await t()) > 3.5 && (await live.playing()));
  await live.press('play');
});

test('words in the prose set it, as often as they are clicked, and the figure comes into sight', async () => {
  const words = tab.locator(`a.set[href="#figure-${figure.name}"]`).last();
  const wanted = Number(new URLSearchParams(await words.getAttribute('data-set')).get('rate'));
  const rate = () => tab.evaluate(of => globalThis.Live.opened[of].values.rate, figure.name);
  for (let i = 0; i < 2; ++i) {
    await words.click();
    assert.equal(await rate(), wanted);
    await live.control('rate').locator('input').focus();
    await tab.keyboard.press('ArrowRight');
    assert.notEqual(await rate(), wanted);
  }
  assert.deepEqual(tab.faults, []);
});

test('what is held in the picture of a run with an end is a setting: the time stays, and a link has it', async () => {
  const ball = figureOf('thrown-ball');
  const thrown = await open(tab, ball, 'throw%20x=5&throw%20y=8&rate=60');
  const { x } = await thrown.now();
  assert.ok(Math.abs(x - 10) < 1e-9, `${x}`);
  const chart = await thrown.stage.locator('.u-over').boundingBox();
  await tab.mouse.click(chart.x + chart.width / 2, chart.y + chart.height / 2);
  const { t: before } = await thrown.now();
  const handle = thrown.stage.locator('.handle');
  const box = await handle.boundingBox();
  await tab.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await tab.mouse.down();
  await tab.mouse.move(box.x + box.width / 2 - 20, box.y + box.height / 2 - 10, { steps: 3 });
  await tab.mouse.up();
  const slow = await thrown.now();
  assert.equal(slow.t, before);
  assert.ok(slow.x < 5 * slow.t, `${slow.x}`);
  assert.equal(await thrown.playing(), false);
  await handle.focus();
  await tab.keyboard.press('ArrowLeft');
  assert.ok((await thrown.now()).x < slow.x);
  await thrown.press('link');
  assert.match(tab.url(), /throw%20x=\d.*throw%20y=\d/);
  assert.deepEqual(tab.faults, []);
});

test("where a step is a frame of the reader's screen, it is as long as the frame was", async () => {
  await open(tab, figureOf('runner'));
  const lengths = await tab.evaluate(() => {
    const { clock, run, values } = globalThis.Live.opened.runner;
    run.start(values);
    clock.restart();
    return [1000, 1012, 1019, 1019, 1500].map(now => {
      const { t } = run.now;
      clock.frame(now, run);
      return Math.round(1e6 * (run.now.t - t));
    });
  });
  assert.deepEqual(lengths, [0, 12e3, 7e3, 0, 100e3]);
  assert.deepEqual(tab.faults, []);
});

test('a machine that is clicked while it jumps has its late frame now, and the ledge is held up and down alone', async () => {
  const machines = await open(tab, figureOf('four-machines'));
  const values = () => tab.evaluate(() => globalThis.Live.opened['four-machines'].values);
  const handle = machines.stage.locator('.handle');
  const middle = async () => {
    const { x, y, width, height } = await handle.boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const [x, y] = await middle();
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 30, y - 20, { steps: 3 });
  await tab.mouse.up();
  const moved = await middle();
  assert.ok(Math.abs(moved[0] - x) < 0.1 && Math.abs(moved[1] - y + 20) < 1, `${moved}`);
  const raised = (await values()).ledge;
  assert.ok(raised > 1.34, `${raised}`);
  await handle.focus();
  await tab.keyboard.press('ArrowRight');
  await tab.keyboard.press('ArrowDown');
  assert.ok(Math.abs((await values()).ledge - raised + 0.01) < 1e-9);
  assert.match(await handle.getAttribute('aria-valuetext'), /^1\.\d\d.m up$/);

  const canvas = await machines.stage.locator('canvas.scene').boundingBox();
  const click = part => tab.mouse.click(canvas.x + part * canvas.width, canvas.y + canvas.height / 2);
  await click(0.8);
  assert.deepEqual([(await values()).late, (await values()).at], ['d', 0.2], 'nothing moves: it is late where it was');
  await machines.press('reset');
  await machines.press('play');
  await tab.waitForFunction(() => globalThis.Live.opened['four-machines'].run.now.t > 0.25);
  await click(0.1);
  await machines.press('play');
  const { late, at } = await values();
  assert.ok(late === 'a' && at >= 0.24 && at <= (await machines.now()).t, `${late} at ${at}`);
  assert.deepEqual(tab.faults, []);
});
