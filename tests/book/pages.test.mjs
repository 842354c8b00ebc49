// Pages in the browser, light on a desktop and dark on a phone:  node pages.test.mjs BUILD [others]
import assert from 'node:assert/strict';
import { before, describe, test } from 'node:test';
import { accessibility } from './accessibility.mjs';
import { parse } from './book.mjs';
import { openTab, visit } from './browser.mjs';
import { asked, chosen, isMade, others } from './chosen.mjs';
import { inspect } from './inspect.mjs';
import { typesetting } from './typesetting.mjs';

// axe is slow, and of the pages that are made of the code it looks at those that stand for all, and at the others that hold an
// element within an element, or a heading after a heading, that none before them held.
const seen = new Set();
function holdsSomethingNew(page) {
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
for (const page of chosen.filter(isMade)) holdsSomethingNew(page);
const fresh = new Set(asked === others ? others.filter(holdsSomethingNew) : []);

// A page is looked over by axe in one of the looks, and in the other one among the others. Of those that are made of the code
// all that hold something new are seen in both looks, and of the rest a third in one.
const turn = page => ['light', 'dark'][(chosen.includes(page) ? chosen : others).indexOf(page) % 2];
const looksWhole =
  asked === chosen ? (page, look) => turn(page) === look : page => chosen.includes(page) || fresh.has(page);
const visited = look =>
  asked === chosen
    ? chosen
    : [
        ...chosen.filter(page => turn(page) !== look),
        ...others.filter(page => fresh.has(page) || isTurnOf(page, look)),
      ];
const isTurnOf = (page, look) => others.indexOf(page) % 6 === (look === 'light' ? 0 : 3);

// One browser, a tab for each look, and both at once.
describe('in the browser', { concurrency: 2 }, () => {
  for (const [look, reader] of [
    ['light', 'light on a desktop'],
    ['dark', 'dark on a phone'],
  ])
    describe(reader, { concurrency: 1 }, () => {
      let tab;
      before(async () => {
        tab = await openTab(look);
      });
      for (const page of visited(look)) {
        test(`${page}, ${reader}`, async () => {
          await visit(tab, page);
          const faults = [...tab.faults, ...(await tab.evaluate(inspect))];
          if (!isMade(page)) faults.push(...(await tab.evaluate(typesetting)));
          if (looksWhole(page, look)) faults.push(...(await accessibility(tab)));
          assert.ok(!faults.length, faults.join('\n'));
        });
      }
    });
});
