// Chromium's own print of the whole book, with bookmarks. It is printed twice: the first time, without its pictures, to see on which
// sheet each place is, for style sheets can't say that yet.
import { join, resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { openChromium } from './chromium.mjs';
import { sheetsOfPlaces } from './destinations.mjs';
import { settleNames } from './settle.mjs';
import { wholeBook } from './whole.mjs';

const MINUTES = 5;
const A4 = { format: 'A4', preferCSSPageSize: true };

export async function printWhole(book) {
  const html = wholeBook(book);
  const browser = await openChromium();
  try {
    const tab = await openWhole(browser, pathToFileURL(join(resolve(book), 'whole.html')).href, html);
    const sheets = await sketch(tab);
    await tab.evaluate(numberLinks, Object.fromEntries(sheets));
    const pdf = await tab.pdf({ ...A4, outline: true, tagged: true });
    checkNumbers(sheets, sheetsOfPlaces(pdf));
    return settleNames(pdf);
  } finally {
    await browser.close();
  }
}

// The page is at home among the woven ones, though it is no file there: so it finds fonts and films, and its links lead within.
async function openWhole(browser, address, html) {
  const context = await browser.newContext({ colorScheme: 'light', reducedMotion: 'reduce' });
  const tab = await context.newPage();
  tab.setDefaultTimeout(MINUTES * 60_000);
  await tab.route(address, route => route.fulfill({ contentType: 'text/html; charset=utf-8', body: html }));
  await tab.goto(address, { waitUntil: 'load' });
  await tab.evaluate(() => document.fonts.ready.then(() => {}));
  return tab;
}

async function sketch(tab) {
  const blank = await tab.addStyleTag({ content: 'svg > * { display: none; }' });
  const pdf = await tab.pdf(A4);
  await blank.evaluate(style => style.remove());
  return sheetsOfPlaces(pdf);
}

// In the browser
function numberLinks(sheets) {
  for (const a of document.querySelectorAll('[data-sheet]')) a.dataset.sheet = sheets[a.hash.slice(1)];
}

function checkNumbers(sketched, printed) {
  for (const [place, sheet] of printed)
    if (sketched.get(place) !== sheet)
      throw new Error(`"${place}" is on page ${sheet}, and its links say ${sketched.get(place)}`);
}
