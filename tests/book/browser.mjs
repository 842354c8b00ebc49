// A tab of the distribution's Chromium that keeps account of what should not happen.
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after } from 'node:test';
import { openChromium } from '../../book/paper/chromium.mjs';
import { folder } from './book.mjs';

export const browser = await openChromium().catch(fault => {
  console.error(`The book is tested in a browser. ${fault.message}`);
  process.exit(1);
});
after(() => browser.close());

const looks = {
  light: { viewport: { width: 1280, height: 900 }, colorScheme: 'light' },
  dark: { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true, colorScheme: 'dark' },
};

// A tab with `faults`, which collects console messages and requests that leave the disk or fail. Its readers want no motion,
// unless `more` says so.
export async function openTab(look = 'light', more = {}) {
  const context = await browser.newContext({ ...looks[look], reducedMotion: 'reduce', ...more });
  await context.grantPermissions(['clipboard-read', 'clipboard-write']);
  const tab = await context.newPage();
  tab.setDefaultTimeout(20000);
  tab.faults = [];
  tab.on('console', message => tab.faults.push(`console: ${message.text()}`));
  tab.on('pageerror', error => tab.faults.push(`script: ${error.message}`));
  tab.on(
    'request',
    request => /^(file|data|blob):/.test(request.url()) || tab.faults.push(`leaves the disk: ${request.url()}`),
  );
  // A film that is on its way when a reader leaves the page is no fault.
  const leftBehind = request => /\/films\//.test(request.url()) && request.failure()?.errorText === 'net::ERR_ABORTED';
  tab.on('requestfailed', request => leftBehind(request) || tab.faults.push(`not loaded: ${request.url()}`));
  return tab;
}

export function addressOf(page) {
  const [file, fragment] = page.split('#');
  return pathToFileURL(join(folder, file)).href + (fragment ? `#${fragment}` : '');
}

export async function visit(tab, page) {
  tab.faults.length = 0;
  await tab.goto(addressOf(page), { waitUntil: 'load' });
  await alive(tab);
}

// The page has arrived: all of it is in its place, and every live figure runs.
export const alive = tab =>
  tab.waitForFunction(
    () =>
      document.documentElement.matches('.arrived, :not(.scripted)') && // a film by itself has nowhere to arrive
      [...document.querySelectorAll('[data-live]')].every(figure => figure.classList.contains('live')),
  );

// What the browser draws next, `count` times over: whatever still moves has moved by then.
export const frames = (tab, count = 4) =>
  tab.evaluate(async n => {
    for (; n; --n) await new Promise(requestAnimationFrame);
  }, count);

export const pageOf = tab => new URL(tab.url()).pathname.split('/').at(-1);

// A page that scrolls hides the value shown, and it tells so one frame later.
export async function bringIntoView(tab, thing) {
  await thing.scrollIntoViewIfNeeded();
  await frames(tab, 2);
}

// Where the page is open, it stays: for tests that leave nothing behind that another one would stumble over.
export const come = (tab, page) => (pageOf(tab) === page ? null : visit(tab, page));
