// The live figures, driven by keyboard and by their buttons:  node live-figures.test.mjs BUILD [FIGURE | others]
// Without a name every one is, on a desktop, and the first on a phone and in motion, too; with "others", the others.
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { alive, browser, frames, openTab, pageOf } from './browser.mjs';
import { figures, firstOfEachKind, hold, open } from './live.mjs';

const others = process.argv[3] === 'others';
const only = others ? undefined : process.argv[3];
const asked = only ? figures.filter(({ name }) => name === only) : firstOfEachKind;
const inTurn = asked.filter((_, i) => only || i > 0 === others);
const looks = [
  ['light', 'on a desktop', others ? [] : asked],
  ['dark', 'on a phone', inTurn],
];
const come = (tab, figure) => (pageOf(tab) === figure.page ? hold(tab, figure) : open(tab, figure));
const blank = tab => assert.deepEqual(tab.faults, []);

test('the figure is there', () => assert.ok(asked.length));

// Three readers at once, with a tab of one browser each. A page is opened once by each, and put back to how it opened before
// each test.
describe('live figures', { concurrency: 3 }, () => {
  for (const [look, reader, all] of looks)
    describe(reader, { concurrency: 1 }, () => {
      let tab;
      before(async () => {
        tab = await openTab(look);
      });
      for (const figure of all) withoutMotion(figure, () => tab, `${figure.name}, ${reader}`, look === 'light');
    });
  describe('where the reader likes motion', { concurrency: 1 }, withMotion);
});

function withoutMotion(figure, reader, name, onDesktop) {
  let live, tab;
  const about = (sentence, body) =>
    test(`${name}: ${sentence}`, async () => {
      tab = reader();
      if (!live) live = await come(tab, figure);
      else await live.reopen();
      await body();
      blank(tab);
    });

  about('the whole run is shown and stays still', async () => {
    const { t, h } = await live.now();
    assert.ok(t > figure.seconds - 1.001 * h, `it ends at ${t}`);
    const scene = await live.scene();
    await frames(tab, 6);
    assert.equal(await live.scene(), scene);
    assert.equal(await live.playing(), false);
  });

  for (const control of figure.controls)
    about(`${control.name}, moved by keyboard, changes the picture and says so`, async () => {
      const { name, choices } = control;
      await live.reach(control);
      const shown = [await live.scene(), await live.chart()];
      const input = live.control(name).locator(choices ? 'input:checked' : 'input');
      const said = () => live.control(name).locator('input').first().getAttribute('aria-valuetext');
      const first = await said();
      await input.focus();
      await tab.keyboard.press('ArrowRight');
      assert.notDeepEqual([await live.scene(), await live.chart()], shown, `${name} changes nothing that is seen`);
      if (!choices) assert.notEqual(await said(), first, `${name} does not say where it stands`);
    });

  if (!onDesktop) {
    about('its longest sentence keeps its room, and nothing below moves', async () => {
      const room = () => live.stage.locator('.readout').evaluate(words => words.offsetHeight);
      const before = await room();
      await live.press('reset');
      assert.equal(await room(), before);
    });
    return;
  }

  about('the code beside it is that of the method chosen', async () => {
    const methods = Object.keys(figure.controls.find(({ name }) => name === 'method')?.choices ?? {});
    for (const method of methods) {
      await live.control('method').locator(`[value=${method}]`).check();
      const shown = live.stage.locator('.listing:visible');
      assert.equal(await shown.count(), 1);
      assert.equal(
        await shown.locator('.file').textContent(),
        figure.code?.[method]?.path ?? `code/integrate/${method}.h`,
      );
    }
  });

  about('Reset goes to the start, and Step on by one step', async () => {
    await live.press('reset');
    const start = await live.now();
    const scene = await live.scene();
    assert.equal(start.t, 0);
    await live.press('step');
    assert.equal((await live.now()).t, start.h);
    await live.press('step'); // the first one of Euler's method leaves what is at rest where it is
    assert.notEqual(await live.scene(), scene);
    await live.stage.locator('[role=status]', { hasText: /\d/ }).waitFor({ state: 'attached' });
  });

  about('a setting that is changed while it is held leaves it at its time', async () => {
    await live.press('reset');
    for (let i = 0; i < 4; ++i) await live.press('step');
    const held = await live.now();
    const [last] = figure.controls.slice(-1);
    const knob = last && live.control(last.name).locator(last.choices ? 'input:checked' : 'input');
    await (knob ?? live.stage.locator('.handle')).focus();
    await tab.keyboard.press('ArrowLeft');
    const { t, h } = await live.now();
    assert.ok(t > 0 && Math.abs(t - held.t) < 1.001 * h, `${held.t} became ${t}`);
  });

  about('picture and chart follow the theme button', async () => {
    const parts = figure.chart ? ['scene', 'chart'] : ['scene'];
    const shown = { scene: await live.scene(), chart: await live.chart() };
    const button = tab.locator('button.theme');
    await button.click();
    for (const part of parts) assert.notEqual(await live[part](), shown[part], part);
    await button.click();
    for (const part of parts) assert.equal(await live[part](), shown[part], part);
  });

  if (figure !== asked[0] && figure !== asked.at(-1)) return; // what follows is the engine's alone

  about('without scripts and on paper there is the still picture', async () => {
    const context = await browser.newContext({ javaScriptEnabled: false });
    const plain = await context.newPage();
    await plain.goto(tab.url(), { waitUntil: 'domcontentloaded' });
    await tab.emulateMedia({ media: 'print' });
    for (const reader of [plain, tab]) {
      const shown = reader.locator(`[data-live="${figure.name}"]`);
      assert.ok(await shown.locator('.still .wide svg').isVisible());
      assert.equal(await shown.locator('.stage:visible').count(), 0);
    }
    await tab.emulateMedia({ media: 'screen' });
    assert.ok(await tab.locator(`[data-live="${figure.name}"] .still`).isHidden());
    await context.close();
  });

  about('the link brings back the settings', async () => {
    for (const { name, choices } of figure.controls) {
      if (await live.control(name).isHidden()) continue;
      await live
        .control(name)
        .locator(choices ? 'input:checked' : 'input')
        .focus();
      await tab.keyboard.press('ArrowRight');
    }
    const [query, scene] = [await live.query(), await live.scene()];
    await live.press('link');
    await live.stage.locator('[data-do=link]', { hasText: /link (copied|is)/i }).waitFor();
    const address = tab.url();
    await tab.goto('about:blank');
    await tab.goto(address, { waitUntil: 'load' });
    await alive(tab);
    assert.equal(await live.query(), query);
    assert.equal(await live.scene(), scene);
  });
}

function withMotion() {
  let moving;
  before(async () => {
    moving = await openTab('light', { reducedMotion: 'no-preference' });
    // A click can miss what still glides, as the page does for readers who like motion.
    await moving.addInitScript(() =>
      addEventListener('DOMContentLoaded', () => {
        document.documentElement.style.scrollBehavior = 'auto';
      }),
    );
  });

  // One that counts looks is at its end too soon to be paused.
  for (const figure of inTurn.filter(({ chart }) => chart)) {
    let live;
    const about = (sentence, body) =>
      test(`${figure.name}: ${sentence}`, async () => {
        await body();
        blank(moving);
      });

    about('it plays once it is seen, and Pause holds it', async () => {
      live = await come(moving, figure);
      await live.stage.evaluate(stage => stage.scrollIntoView());
      await moving.waitForFunction(
        of => globalThis.Live.opened[of].playing && globalThis.Live.opened[of].run.taken > 0,
        figure.name,
      );
      await live.press('play');
      const held = await live.now();
      assert.ok(held.t < figure.seconds);
      await frames(moving, 6);
      assert.deepEqual(await live.now(), held);
      assert.equal(await live.playing(), false);
    });

    about('it pauses out of sight', async () => {
      await live.press('reset');
      await live.press('play');
      await moving.evaluate(() => scrollTo(0, document.body.scrollHeight));
      await live.stage.evaluate(
        stage =>
          new Promise(done => {
            new IntersectionObserver(([seen]) => seen.isIntersecting || done()).observe(stage);
          }),
      );
      await frames(moving, 2);
      const { t } = await live.now();
      await frames(moving, 6);
      assert.equal((await live.now()).t, t);
    });

    about('it says so when it runs slower than time', async () => {
      const slow = 'Slower than real time on this machine.';
      await live.press('reset');
      assert.ok(!(await live.stage.locator('.readout').textContent()).includes(slow));
      const { h } = await live.now();
      const busy = Math.max(150, (1500 * h) / (figure.pace ?? 1)); // for longer than a step lasts [ms]
      await moving.evaluate(
        ([of, milliseconds]) => {
          const { run } = globalThis.Live.opened[of],
            { step } = Object.getPrototypeOf(run);
          run.step = () => {
            for (const until = performance.now() + milliseconds; performance.now() < until;);
            step.call(run);
          };
        },
        [figure.name, busy],
      );
      await live.press('play');
      await live.stage.locator('.readout', { hasText: slow }).waitFor();
      await moving.evaluate(of => delete globalThis.Live.opened[of].run.step, figure.name);
      await live.press('play');
    });
  }
}
