// The times that the page takes of its methods beside those that were recorded:  node live-times.mjs BUILD
// Prints, and judges nothing: times are the machine's.
import { browser, openTab } from './browser.mjs';
import { figures, open } from './live.mjs';

const figure = figures.find(({ timed }) => timed);
const tab = await openTab();
const things = Object.keys(figure.controls.find(({ name }) => name === figure.timed).choices);
const { thing, method, nanoseconds } = await (async () => {
  await open(tab, figure);
  return tab.evaluate(name => globalThis.Live.descriptions[name].tables['recorded-steps'], figure.name);
})();
for (const name of things.filter(name => thing.includes(name))) {
  const live = await open(tab, figure, `${figure.timed}=${name}`);
  await live.press('time');
  await live.stage.locator('.ranked', { hasText: /: taken in/ }).waitFor();
  const here = await tab.evaluate(of => globalThis.Live.opened[of].run.times, figure.name);
  const recorded = Object.fromEntries(nanoseconds.flatMap((ns, i) => (thing[i] === name ? [[method[i], ns]] : [])));
  const methods = Object.keys(here);
  const swapped = methods.flatMap(one =>
    methods
      .filter(other => recorded[one] > 1.5 * recorded[other] && here[one] < here[other])
      .map(other => `${one}, ${other}`),
  );
  const cells = methods.map(one => `${one} ${recorded[one].toFixed(1)} ${here[one].toFixed(1)}`);
  console.log(
    `${name}: [ns] recorded, here: ${cells.join('; ')}\n  in another order, though they differ by more than half: ${swapped.join('; ') || 'none'}`,
  );
}
await browser.close();
