// Every page in the browser, in one look: light on a desktop, or dark on a phone.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { before, describe, test } from 'node:test';
import { kind, pages, parse } from './book.mjs';
import { openTab, visit } from './browser.mjs';
import { inspect } from './inspect.mjs';

const axe = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');
const seen = new Set();

// Two tabs take turns: while one waits for its page, the other works.
describe('every page', { concurrency: 2 }, () => {
  const free = [];
  before(async () => free.push(await openTab(process.argv[3]), await openTab(process.argv[3])));
  for (const page of pages) {
    test(page, async () => {
      const tab = free.pop();
      try {
        await visit(tab, page);
        const faults = [...tab.faults, ...(await tab.evaluate(inspect))];
        if (holdsSomethingNew(page)) faults.push(...(await accessibility(tab)));
        assert.ok(!faults.length, faults.join('\n'));
      } finally {
        free.push(tab);
      }
    });
  }
});

// axe is slow, and pages of code and of reference are made alike by the dozen: it looks at those that hold an element
// within an element, or a heading after a heading, that none before them held.
function holdsSomethingNew(page) {
  if (!['api', 'source'].includes(kind(page))) return true;
  const $ = parse(page);
  const name = e => `${e.name}.${e.attribs.class ?? ''}`;
  const within = $('main *')
    .map((_, e) => `${name(e.parent)} ${name(e)}`)
    .get();
  const headings = $('h1, h2, h3, h4')
    .map((_, e) => e.name)
    .get();
  const after = headings.map((h, i) => `${headings[i - 1]} ${h}`);
  const before = seen.size;
  for (const pair of [...within, ...after]) seen.add(pair);
  return seen.size > before;
}

// preload would make axe fetch the style sheets, which a page on disk may not
async function accessibility(tab) {
  await tab.evaluate(axe);
  const { violations } = await tab.evaluate(() => axe.run(document, { resultTypes: ['violations'], preload: false }));
  return violations.map(
    ({ id, help, nodes }) =>
      `axe ${id}: ${help}, ${nodes.length} times, first at ${nodes[0].target} ${nodes[0].any[0]?.message ?? ''}`,
  );
}
