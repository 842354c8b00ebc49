// The rope that hangs from the reader's hand: by mouse, by touch and by keyboard.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openTab, pageOf } from './browser.mjs';
import { figures, hold, open } from './live.mjs';

const NAME = 'rope-to-drag';
const figure = figures.find(({ name }) => name === NAME);
const tab = await openTab();
const phone = await openTab('dark');

async function openRope(reader) {
  const live = await (pageOf(reader) === figure.page ? hold : open)(reader, figure);
  await live.press('reset');
  const handle = live.stage.locator('.handle');
  // Away from the bar at the top of a phone's page, under which a scroll may have left it.
  await handle.evaluate(element => element.scrollIntoView({ block: 'center' }));
  const middle = async () => {
    const { x, y, width, height } = await handle.boundingBox();
    return [x + width / 2, y + height / 2];
  };
  const metre = () => reader.evaluate(name => globalThis.Live.opened[name].pen.metre, NAME);
  // Where the rope begins, once it has moved there.
  const holds = async (x, y) => {
    await reader.waitForFunction(
      ([name, wanted]) => {
        const { now, taken } = globalThis.Live.opened[name].run;
        return taken > 5 && Math.hypot(now.x[0] - wanted[0], now.y[0] - wanted[1]) < 0.02;
      },
      [NAME, [x, y]],
    );
  };
  return { ...live, handle, middle, metre, holds };
}

test('a mouse drags the rope, and sets it in motion', async () => {
  const { middle, metre, holds, playing } = await openRope(tab);
  const [x, y] = await middle();
  await tab.mouse.move(x, y);
  await tab.mouse.down();
  await tab.mouse.move(x + 40, y - 30, { steps: 4 });
  await tab.mouse.up();
  const scale = await metre();
  await holds(40 / scale, 30 / scale);
  const moved = await middle();
  assert.ok(Math.hypot(moved[0] - x - 40, moved[1] - y + 30) < 1, `${moved}`);
  assert.equal(await playing(), true);
  await tab.mouse.move(x, y);
  assert.deepEqual(await middle(), moved, 'it follows a mouse that has let go');
  assert.deepEqual(tab.faults, []);
});

test('a finger drags the rope and does not scroll the page', async () => {
  const { middle, metre, holds } = await openRope(phone);
  const scrolled = () => phone.evaluate(() => scrollY);
  const [x, y] = await middle(),
    scroll = await scrolled();
  const client = await phone.context().newCDPSession(phone);
  const touch = (type, ...points) =>
    client.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([px, py]) => ({ x: px, y: py })) });
  await touch('touchStart', [x, y]);
  for (let part = 1; part <= 5; ++part) await touch('touchMove', [x - 6 * part, y + 5 * part]);
  await touch('touchEnd');
  const scale = await metre();
  await holds(-30 / scale, -25 / scale);
  assert.equal(await scrolled(), scroll);
  assert.deepEqual(phone.faults, []);
});

test('the arrow keys move the hand, say where it is, and stop at the edge; Reset brings it back', async () => {
  const { handle, holds, press, now } = await openRope(tab);
  const { x, y, by } = figure.handle;
  const said = () => handle.getAttribute('aria-valuetext');
  const first = await said();
  await handle.focus();
  await tab.keyboard.press('ArrowRight');
  await tab.keyboard.press('ArrowUp');
  await holds(by, by);
  assert.notEqual(await said(), first);
  for (let i = 0; i < 50; ++i) await tab.keyboard.press('ArrowLeft');
  for (let i = 0; i < 50; ++i) await tab.keyboard.press('ArrowDown');
  await holds(x.from, y.from);
  await press('reset');
  assert.equal(await said(), first);
  assert.deepEqual([(await now()).x[0], (await now()).y[0]], [x.start, y.start]);
});

test('a knob that is moved while the rope swings says so, and the rope swings on', async () => {
  const { control, stage, press, now, playing } = await openRope(tab);
  await press('play');
  await tab.waitForFunction(name => globalThis.Live.opened[name].run.taken > 20, NAME);
  const { t } = await now();
  const value = control('iterations').locator('.value');
  const [said, code] = [await value.textContent(), await stage.locator('.listing:visible b').textContent()];
  await control('iterations').locator('input').focus();
  await tab.keyboard.press('ArrowRight');
  assert.notEqual(await value.textContent(), said);
  await control('method').locator('[value=uneven]').check();
  assert.notEqual(await stage.locator('.listing:visible b').textContent(), code);
  assert.ok((await now()).t >= t && (await playing()));
  await press('play');
  await control('method').locator('[value=even]').check();
});

test('the live handle has no end: the chart goes along and keeps the last seconds', async () => {
  await openRope(tab);
  const { ended, t, kept, from, until } = await tab.evaluate(async name => {
    const opened = globalThis.Live.opened[name],
      { run, chart } = opened;
    while (run.now.t < 2.5 * opened.description.seconds) run.step();
    opened.draw();
    await new Promise(requestAnimationFrame);
    const { min, max } = chart.plot.scales.x;
    return { ended: run.ended, t: run.now.t, kept: run.trace.t.length, from: min, until: max };
  }, NAME);
  assert.equal(ended, false);
  assert.ok(Math.abs(until - t) < 1e-9 && Math.abs(from - (t - figure.seconds)) < 1e-9, `${from} to ${until} at ${t}`);
  assert.ok(kept >= 60 * figure.seconds && kept <= 60 * figure.seconds + 3, `${kept}`);
});
