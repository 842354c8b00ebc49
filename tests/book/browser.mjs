// The distribution's Chromium, and a tab of it that keeps account of what should not happen.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { after } from 'node:test';
import { chromium } from 'playwright-core';
import { folder } from './book.mjs';

const candidates = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/snap/bin/chromium', '/usr/bin/google-chrome'];
const executablePath = process.env.CHROMIUM ?? candidates.find(existsSync);
if (!executablePath || !existsSync(executablePath)) {
  console.error(
    `The book is tested in a browser, and there is none: ${executablePath ?? candidates.join(', ')} not found.\n` +
      'Run ./setup.sh, or name a Chromium with CHROMIUM=/path/to/it',
  );
  process.exit(1);
}

// Without the sandbox, which containers refuse: the pages are our own. And without anything that looks at the network.
const args = [
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
];
export const browser = await chromium.launch({ executablePath, chromiumSandbox: false, args });
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
  await tab.waitForFunction(() =>
    [...document.querySelectorAll('[data-live]')].every(figure => figure.classList.contains('live')),
  );
}

export const pageOf = tab => new URL(tab.url()).pathname.split('/').at(-1);
