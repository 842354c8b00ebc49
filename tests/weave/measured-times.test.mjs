// Times in tables and on cards: those that were recorded, and this machine's if it was quiet.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { refuses, weaves } from './weaver.mjs';

const GROWTH = 'built/2-euler/data/growth.csv',
  COLUMNS = 'built/2-euler/data/tables.csv',
  CARD = 'built/cards/euler.csv';
const file = (others, rows) =>
  `# Times.\n# processor: a <fast> one\n# clock: 3.1 GHz\n# compiler: g++ 12 -O2\n# date: 2026-11-22\n# runs: 31\n` +
  `# others: ${others}\nname,lower,median,upper\n${rows}\n`;
const recorded = ['built/recorded.csv', file(0.0123, 'card/euler,14.1,14.9,15.2\nspring/Yoshida 4,1.6,1.66,1.7')];
const here = others => ['built/here.csv', file(others, 'card/euler,29,30,31\nspring/Yoshida 4,3.1,3.21,3.3')];
const cells = [
  [COLUMNS, 'growth,factor,,5', 'growth,factor,ns,text'],
  [GROWTH, 'method,h,factor\nEuler,0.5,time:spring/Yoshida 4\nEuler,0.25,time:none such\n'],
  [CARD, '14.7123', 'time:card/euler'],
];

test('a time is the recorded one, and of what is not recorded it says so', () => {
  const read = weaves(recorded, ...cells);
  const page = read('2-euler.html');
  assert.match(
    page,
    /<td class="right"><span class="time" title="half of the runs between 1\.6 and 1\.7 ns">1\.7<\/span><\/td>/,
  );
  assert.match(page, /<td class="right">not recorded<\/td>/);
  assert.match(
    page,
    /<p class="times">Medians of 31 runs in turn, recorded on a &lt;fast&gt; one at 3\.1 GHz with g\+\+ 12 -O2, 2026-11-22, while other programs took 1\.2\u202f% of a processor\.<\/p>/,
  );
  assert.match(
    read('integrate-euler.html'),
    /<dt>time, on an orbit<\/dt><dd><span class="time"[^>]*>15<\/span>\u202fns<\/dd>[\s\S]*<p class="times">Medians of 31 runs/,
  );
});

test('the times of this machine stand in brackets if it was quiet', () => {
  const page = weaves(recorded, here(0.03), ...cells)('2-euler.html');
  assert.match(
    page,
    /1\.7<\/span> <span class="here" title="here half of the runs between 3\.1 and 3\.3 ns">\(3\.2\)<\/span><\/td>/,
  );
  assert.match(
    page,
    /In brackets: on the machine that this copy was built on, a &lt;fast&gt; one at 3\.1 GHz with g\+\+ 12 -O2\.<\/p>/,
  );
});

test('if it was not quiet its times are not shown, and the page says why', () => {
  const page = weaves(recorded, here(0.98), ...cells)('2-euler.html');
  assert.ok(!page.includes('class="here"'));
  assert.match(page, /was not quiet: other programs took 98\u202f% of a processor, so its times are not shown\.<\/p>/);
});

test('a table without times says nothing of them', () => {
  assert.ok(!weaves(recorded, here(0))('2-euler.html').includes('class="times"'));
});

test('a book that wants times and has no record of them', () =>
  refuses(
    [here(0), ['code/measure/times.cpp', '// takes them\n']],
    [
      'code/measure/times.cpp',
      '',
      'there are no recorded.csv; build the target record_times on a quiet machine, or record_libraries of the preset peers',
    ],
  ));
