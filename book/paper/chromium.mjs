// The distribution's Chromium. Where it has the headless one by itself, that: the same engine without the windows that nobody
// sees, and a page costs it half as much.
import { existsSync } from 'node:fs';
import { chromium } from 'playwright-core';

const candidates = [
  '/usr/bin/chromium-headless-shell',
  '/usr/bin/chromium',
  '/usr/bin/chromium-browser',
  '/snap/bin/chromium',
  '/usr/bin/google-chrome',
];

// Without the sandbox, which containers refuse: the pages are our own. And without anything that looks at the network.
const args = [
  '--disable-gpu',
  '--disable-quic',
  '--no-first-run',
  '--disable-background-networking',
  '--disable-component-update',
  '--disable-sync',
  '--disable-features=WebAssemblyTrapHandler', // whose signals end the headless one, where code of a reader's goes beyond its memory
  '--font-render-hinting=none', // or letters of the headless one are wider, in print above all
];

export function openChromium() {
  const executablePath = process.env.CHROMIUM ?? candidates.find(existsSync);
  if (executablePath && existsSync(executablePath))
    return chromium.launch({ executablePath, chromiumSandbox: false, args });
  throw new Error(
    `No Chromium: ${executablePath ?? candidates.join(', ')} not found. Run ./setup.sh, or name one with CHROMIUM=/path/to/it`,
  );
}
