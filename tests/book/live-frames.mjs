// How smoothly the live figures run on this machine, with the settings at which they open:  node live-frames.mjs BUILD
// Prints, and judges nothing: times are the machine's.
import { figures, open } from './live.mjs';
import { browser, openTab, visit } from './browser.mjs';

const SECONDS = 3;
const median = list => [...list].sort((a, b) => a - b)[Math.floor(list.length / 2)];
const worst = list => [...list].sort((a, b) => a - b)[Math.floor(list.length * 0.99)];
const ms = value => value.toFixed(1).padStart(7);

const tab = await openTab();
await tab.emulateMedia({ reducedMotion: 'no-preference' });
await tab.addInitScript(() => {
  new MutationObserver((_, observer) => {
    if (!document.querySelector('[data-live].live')) return;
    observer.disconnect();
    requestAnimationFrame(() =>
      requestAnimationFrame(() => {
        globalThis.firstPicture = performance.now();
      }),
    );
  }).observe(document, { subtree: true, attributes: true });
});

// The intervals between frames, and the work of each, while a figure plays over and over.
const record = ([name, seconds]) =>
  new Promise(done => {
    const figure = globalThis.Live.opened[name],
      { frame } = Object.getPrototypeOf(figure);
    const intervals = [],
      work = [];
    let last = null;
    figure.frame = now => {
      if (last !== null) intervals.push(now - last);
      last = now;
      const from = performance.now();
      frame.call(figure, now);
      work.push(performance.now() - from);
      if (!figure.playing) {
        last = null;
        figure.play();
      }
    };
    figure.reset();
    figure.play();
    setTimeout(() => {
      figure.pause();
      done({ intervals, work });
    }, seconds * 1000);
  });

console.log(`${'figure'.padEnd(20)} frames a second   work: median   99 %  of a frame [ms]   first picture [ms]`);
for (const figure of figures) {
  await visit(tab, 'index.html');
  await open(tab, figure);
  const first = await tab.waitForFunction(() => globalThis.firstPicture);
  const { intervals, work } = await tab.evaluate(record, [figure.name, SECONDS]);
  console.log(
    `${figure.name.padEnd(20)} ${ms(1000 / median(intervals))}           ${ms(median(work))} ${ms(worst(work))}                      ${ms(await first.jsonValue())}`,
  );
}
await browser.close();
