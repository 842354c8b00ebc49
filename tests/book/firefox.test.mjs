// The live figures in the distribution's Firefox, by the protocol that it speaks itself:  node firefox.test.mjs BUILD FIREFOX
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { pathToFileURL } from 'node:url';
import { MANY_STEPS, casesOfManySteps, question } from '../../book/live/cases.mjs';
import { build, folder } from './book.mjs';
import { openFirefox } from './firefox.mjs';
import { figures, firstOfEachKind } from './live-list.mjs';

const browser = await openFirefox(process.argv[3]);
after(() => browser.close());
const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, reducedMotion: 'reduce' });
await context.addInitScript(() => {
  globalThis.pictures = of =>
    [...document.querySelectorAll(`[data-live="${of}"] canvas`)].map(canvas => canvas.toDataURL()).join();
});
const tab = await context.newPage();
const faults = [];
tab.on('console', message => faults.push(message.text()));
tab.on('pageerror', error => faults.push(error.message));

let open; // the page that is
async function visit(page) {
  if (page === open) return;
  open = page;
  faults.length = 0;
  await tab.goto(pathToFileURL(join(folder, page)).href);
  await tab.waitForFunction(() =>
    [...document.querySelectorAll('[data-live]')].every(figure => figure.classList.contains('live')),
  );
}

for (const { name, page, controls } of firstOfEachKind) {
  test(`${name} comes to life, and answers to its controls`, async () => {
    await visit(page);
    const stage = tab.locator(`[data-live="${name}"] .stage`);
    for (const control of controls) {
      for (const [name, value] of Object.entries(control.for ?? {}))
        await stage.locator(`[data-control="${name}"] [value="${[value].flat()[0]}"]`).check();
      const before = await tab.evaluate(of => globalThis.pictures(of), name);
      await stage.locator(`[data-control="${control.name}"] ${control.choices ? 'input:checked' : 'input'}`).focus();
      await tab.keyboard.press('ArrowRight');
      await tab
        .waitForFunction(([of, old]) => globalThis.pictures(of) !== old, [name, before], { timeout: 5000 })
        .catch(() => assert.fail(`${control.name} changes nothing that is seen`));
    }
    await stage.locator('[data-do=reset]').click();
    await stage.locator('[data-do=play]').click();
    await tab.waitForFunction(of => {
      const { taken, full } = globalThis.Live.opened[of].run;
      return taken > 3 || full;
    }, name);
    await stage.locator('[data-do=play]').click();
    assert.deepEqual(faults, []);
  });
}

test(`${MANY_STEPS} steps of every figure have the same bits as in the native program`, async () => {
  const runs = casesOfManySteps();
  const native = execFileSync(join(build, 'weave/live/live.fingerprints'), {
    input: runs.map(run => question(run, MANY_STEPS)).join('\n'),
    encoding: 'utf8',
  })
    .trim()
    .split('\n');
  await visit(figures[0].page);
  for (const [i, { figure, settings }] of runs.entries()) {
    const found = await tab.evaluate(
      async ([name, values, steps]) => {
        globalThis.compiledOnce ??= await Live.compile(Live.compiled);
        const opened = await Live.open(globalThis.compiledOnce, name);
        for (const [setting, value] of Object.entries(values)) opened.set(setting, value);
        return opened.fingerprint(steps);
      },
      [figure, settings, MANY_STEPS],
    );
    assert.equal(found, native[i], `${figure} ${JSON.stringify(settings)}`);
  }
});
