// What a test does with a live figure of the built book.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { build } from './book.mjs';
import { pageOf, visit } from './browser.mjs';
import { figures } from './live-list.mjs';

export { figures, firstOfEachKind } from './live-list.mjs';

export const MODULE = join(build, 'weave/live/live.wasm');
export const module = readFileSync(MODULE);

// Opens the page of a figure, and returns what there is to do with it.
export async function open(tab, figure, query = '') {
  await visit(tab, figure.page + (query && `#figure-${figure.name}?${query}`));
  return hold(tab, figure);
}

// What a figure with the settings of a link shows at its end. Its page is opened once.
export async function endOf(tab, name, query) {
  const figure = figureOf(name);
  if (pageOf(tab) !== figure.page) await visit(tab, figure.page);
  return tab.evaluate(
    ([of, wanted]) => {
      const opened = globalThis.Live.opened[of];
      opened.settings.query = opened.atFirst ??= opened.settings.query;
      opened.handle?.reset();
      opened.set(opened.read(wanted));
      opened.showWhole();
      return { ...opened.run.now };
    },
    [name, query],
  );
}

export const figureOf = wanted => figures.find(({ name }) => name === wanted);

// What there is to do with a figure of the page that is open.
export async function hold(tab, { name }) {
  const stage = tab.locator(`[data-live="${name}"] .stage`);
  await stage.scrollIntoViewIfNeeded();
  const settings = await tab.evaluate(of => globalThis.Live.opened[of].settings.query, name);
  const canvas = selector =>
    stage
      .locator(selector)
      .first()
      .evaluate(element => element.toDataURL());
  return {
    stage,
    press: action => stage.locator(`[data-do=${action}]`).click(),
    scene: () => canvas('canvas.scene'),
    chart: async () => ((await stage.locator('.chart').count()) ? canvas('.chart canvas') : ''),
    now: () =>
      tab.evaluate(of => {
        const { now } = globalThis.Live.opened[of].run;
        return { ...now };
      }, name),
    trace: () => tab.evaluate(of => ({ ...globalThis.Live.opened[of].run.trace }), name),
    playing: () => tab.evaluate(of => globalThis.Live.opened[of].playing, name),
    query: () => tab.evaluate(of => globalThis.Live.opened[of].settings.query, name),
    // Puts it back to how the page opened it: the whole run, with the settings of then.
    reopen: () =>
      tab.evaluate(
        ([of, query]) => {
          const figure = globalThis.Live.opened[of];
          figure.settings.query = query;
          figure.mistakes?.fit();
          figure.reset();
          figure.showWhole();
        },
        [name, settings],
      ),
    control: control => stage.locator(`[data-control="${control}"]`),
    // Some controls are for one choice of another alone: makes that choice. In a list of methods, that of a mistake to make.
    reach: async ({ for: choice = {}, chips, choices }) => {
      const ranked = stage.locator('.ranked');
      if (chips && (await ranked.count())) {
        const [, mistake] = Object.keys(choices);
        await ranked.locator(`[data-name=${mistake.split('/')[0]}]`).click();
      }
      for (const [control, value] of Object.entries(choice))
        await stage.locator(`[data-control="${control}"] [value="${[value].flat()[0]}"]`).check();
    },
  };
}
