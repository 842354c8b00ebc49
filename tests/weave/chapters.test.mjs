// A book of two chapters: references from one to the other, and names that both claim for themselves.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { minutesToRead } from '../../book/weave/reading-time.mjs';
import { refuses, weaves } from './weaver.mjs';

const SECOND = 'chapters/3-heun/chapter.md';
const svg = readFileSync(new URL('sample/built/2-euler/figures/spiral.svg', import.meta.url), 'utf8');
const report =
  name => `<Catch2TestRun name="claims"><TestCase name="${name}" filename="chapters/3-heun/claims.cpp" line="2">
  <OverallResult success="true" skips="0"/></TestCase></Catch2TestRun>\n`;

const chapter = (text, { figure = 'wheel', test = 'Heun is better', numbers = 'gain,2,,3\n' } = {}) => [
  [SECOND, `# Heun\n\n${text}\n\n\\figure{${figure}, Title}\nCaption. \\look\n\\endfigure\n`],
  ['chapters/3-heun/claims.cpp', `// test\nTEST_CASE("${test}") {}\n`],
  [`chapters/3-heun/${figure}.gp`, 'plot sin(x)\n'],
  [`built/3-heun/figures/${figure}.svg`, svg],
  [`built/3-heun/figures/${figure}-narrow.svg`, svg],
  ['built/3-heun/data/numbers.csv', `name,value,unit,digits\n${numbers}`],
  ['built/3-heun/claims.xml', report(test)],
];

const words = count => 'word '.repeat(count);

test('references to another chapter', () => {
  const read = weaves(
    ...chapter(
      'See \\eqref{growth}, \\lstref{code/integrate/euler.h, step}, \\sectionref{2-euler, growth}, \\chapterref{2-euler},\n' +
        '\\number{2-euler/radius}, \\f$ \\number{2-euler/steps} \\f$, \\claim{Euler gains energy on every step}.',
    ),
  );
  const page = read('3-heun.html');
  for (const [href, text] of [
    ['eq-growth', '(2.1)'],
    ['listing-1', 'Listing 2.1'],
    ['growth', 'section 2.2'],
  ])
    assert.ok(page.includes(`<a href="2-euler.html#${href}">${text}</a>`), text);
  assert.match(page, /<a href="2-euler\.html">Chapter 2, <em>Euler’s method<\/em><\/a>/);
  assert.match(page, />3\.142\u202fm<\/data>/);
  assert.match(page, /<annotation encoding="application\/x-tex">\{123\\,456\}</);
  assert.equal(read('claims.html').match(/said in chapter 2<\/a>, .*?and in chapter 3<\/a>/g)?.length, 1);
});

test('how long a chapter takes: 200 words a minute, some for each thing to look at or to try, nothing for the exercises', () => {
  const minutes = text =>
    weaves(...chapter(`${text}\n\nIt takes \\minutes{3-heun}.`))('3-heun.html').match(/It takes (.*?)\./)[1];
  assert.equal(minutes(words(2800)), '15\u202fmin');
  assert.equal(minutes(`${words(2800)}\n\n${'\\f[ a \\f]\n\n'.repeat(5)}`), '20\u202fmin');
  const token = (type, meta, content = '') => ({ type, meta, content });
  const text = token('text', null, words(2800));
  assert.deepEqual([minutesToRead([text]), minutesToRead([text, token('open', { name: 'change' })])], [15, 20]);
  assert.equal(
    minutes(`${words(2800)}\n\n${'\\f[ a \\f]\n\n'.repeat(5)}## Exercises\n\n${words(9000)}`),
    '20\u202fmin',
  );
});

test('a place to stop says how long it took so far, and how long the rest takes', () => {
  const read = weaves(...chapter(`${words(4000)}\n\n\\pause\n\n${words(6000)}\n\n## Exercises\n\n${words(9000)}`));
  assert.match(
    read('3-heun.html'),
    /<p class="pause">A good place to stop\. So far it took about 20 minutes; the rest takes 30,/,
  );
});

test('minutes of a chapter that is not there', () =>
  refuses(chapter('It takes \\minutes{3-huen}.'), [
    SECOND,
    '3-huen',
    'there is no chapter "3-huen". Did you mean "3-heun"?',
  ]));

test('numbers and tables of another chapter', () =>
  refuses(
    chapter('\\number{radius}\nand \\number{2-euler/gain}\n\n\\table{other}\nCaption.\n\\rows{growth}\n\\endtable'),
    [
      SECOND,
      '{radius}',
      'unknown number "radius"; chapters/3-heun/program.cpp writes none of that name. Did you mean "2-euler/radius"?',
    ],
    [
      SECOND,
      '2-euler/gain',
      'unknown number "2-euler/gain"; chapters/2-euler/program.cpp writes none of that name. Did you mean "3-heun/gain"?',
    ],
    [SECOND, '\\rows', 'the program of this chapter writes no table "growth". There is none yet.'],
  ));

test('names that both chapters claim', () =>
  refuses(
    chapter('\\eq{growth} \\f[ a \\f] \\endeq', { figure: 'spiral', test: 'Nobody cites this claim' }),
    [
      SECOND,
      '\\eq{',
      'the equation name "growth" is taken by chapters/2-euler/chapter.md:29; names are unique in the book',
    ],
    [
      SECOND,
      '\\figure',
      'the figure name "spiral" is taken by chapters/2-euler/chapter.md:16; names are unique in the book',
    ],
    [
      'chapters/3-heun/claims.cpp',
      'TEST_CASE',
      'the test name "Nobody cites this claim" is taken by chapters/2-euler/claims.cpp:8; names are unique in the book, by their letters and digits',
    ],
  ));
