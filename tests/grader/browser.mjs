// The distribution's Chromium, which reads XML and pages as a reader's would.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const candidates = ['/usr/bin/chromium', '/usr/bin/chromium-browser', '/snap/bin/chromium', '/usr/bin/google-chrome'];

export function openBrowser() {
  const executablePath = process.env.CHROMIUM ?? candidates.find(existsSync);
  if (!executablePath) throw new Error('No Chromium. Run ./setup.sh, or name one with CHROMIUM=/path/to/it');
  const args = [
    '--disable-gpu',
    '--no-first-run',
    '--disable-background-networking',
    '--disable-component-update',
    '--disable-sync',
  ];
  // Without the sandbox, which containers refuse: the pages are our own.
  return chromium.launch({ executablePath, chromiumSandbox: false, args });
}
