// The pages before and after the chapters: their order, a start page with a program of its own, the glossary, tests by name.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CHAPTER, refuses, weaves } from './weaver.mjs';

const INDEX = 'chapters/front/chapter.md',
  GLOSSARY = 'book/glossary.md',
  TALKS = 'book/talks.md';
const svg = readFileSync(new URL('sample/built/2-euler/figures/spiral.svg', import.meta.url), 'utf8');
const words = text => [GLOSSARY, '- \\term{after a dash} Behind it.\n', text];

// A program for the start page, and what the page shows of it.
const front = (text = '\\figure{race, A race}\nAfter \\number{turns}.\n\\endfigure') => [
  [INDEX, '\\contents', `${text}\n\n\\contents`],
  ['chapters/front/claims.cpp', '// test\nTEST_CASE("Nobody wins") {}\n'],
  ['chapters/front/race.gp', 'plot file("race")\n'],
  ['built/front/figures/race.svg', svg],
  ['built/front/figures/race-narrow.svg', svg],
  ['built/front/data/numbers.csv', 'name,value,unit,digits\nturns,20,,0\n'],
  ['built/front/data/race.csv', 't\n1\n'],
  [
    'built/front/claims.xml',
    `<Catch2TestRun name="claims"><TestCase name="Nobody wins" filename="chapters/front/claims.cpp" line="2">
    <OverallResult success="true" skips="0"/></TestCase></Catch2TestRun>\n`,
  ],
];

test('every page says which edition of the book it is from', () => {
  const read = weaves();
  for (const page of ['index', 'preface', '2-euler', 'claims', 'reference'])
    assert.match(read(`${page}.html`), /<footer>[^<]* 1\.2\.3\. /, page);
});

test('the pages follow each other, and stand in the menu', () => {
  const read = weaves();
  const order = ['index', 'preface', '2-euler', 'checked', 'talks', 'teaching', 'glossary', 'references'];
  order.forEach((name, i) => {
    const page = read(`${name}.html`);
    assert.equal(page.match(/<a rel="next" href="(.*?)\.html"/)?.[1], order[i + 1], name);
    assert.equal(page.match(/<a rel="prev" href="(.*?)\.html"/)?.[1], order[i - 1], name);
    const menu = [
      ...page.match(/<ol class="toc">([\s\S]*?)<div class="tools">/)[1].matchAll(/href="(.*?)\.html"/g),
    ].map(([, href]) => href);
    assert.deepEqual(menu, [
      'preface',
      '2-euler',
      'snippets',
      'exercises',
      'checked',
      'talks',
      'teaching',
      'glossary',
      'references',
      'claims',
      'reference',
    ]);
  });
});

test('the page that says all in short is at the beginning, with the numbers of its chapter', () => {
  const read = weaves(['chapters/2-euler/two-minutes.md', '# In short\n\nA step of \\number{step}.\n']);
  const page = read('two-minutes.html');
  assert.match(page, /<a rel="prev" href="index\.html"/);
  assert.match(page, /<a rel="next" href="preface\.html"/);
  assert.match(page, /<data class="number"/);
});

test('another Markdown file beside a chapter is a page behind it, and who reads on passes it by', () => {
  const read = weaves(['chapters/2-euler/more.md', '# More of it\n\nA step of \\number{step}.\n']);
  const page = read('more.html');
  assert.match(page, /<h1><span class="kicker">Beside chapter 2<\/span> More of it<\/h1>/);
  assert.match(page, /<a rel="prev" href="2-euler\.html"/);
  assert.match(page, /<a rel="next" href="checked\.html"/);
  assert.match(page, /<data class="number"/);
  const chapter = read('2-euler.html');
  assert.match(chapter, /<a rel="next" href="checked\.html"/);
  assert.match(chapter, /<\/li>\n<li class="beside"><a href="more\.html">/);
});

test('a start page with a program of its own is no chapter', () => {
  const read = weaves(...front());
  const page = read('index.html');
  assert.match(
    page,
    /<figure class="plot" id="figure-race">[\s\S]*<b>Figure 1\. A race\.<\/b> After <data class="number" value="20"[^>]*>20<\/data>/,
  );
  assert.match(page, /<a href="data\/front\/race\.csv">race\.csv<\/a>, <a href="source-chapters-front-race-gp\.html">/);
  assert.equal(page.match(/<ol class="contents">([\s\S]*?)<\/ol>/)[1].match(/<li>/g).length, 1);
  assert.equal(read('data/front/race.csv'), 't\n1\n');
  assert.match(
    read('claims.html'),
    /<h2 id="front">The start page<\/h2>\n<ul class="claims">\n<li id="claim-nobody-wins">/,
  );
});

test('what is wrong with the program of the start page is told there', () =>
  refuses(
    front('\\number{turn}\nand \\figure{rice, A race}\nSo. \\look\n\\endfigure'),
    [
      INDEX,
      '{turn}',
      'unknown number "turn"; chapters/front/program.cpp writes none of that name. Did you mean "turns"?',
    ],
    [INDEX, 'rice', 'there is no chapters/front/rice.gp that draws the figure "rice". Did you mean "race"?'],
    [
      'chapters/front/race.gp',
      '',
      'no \\figure{race, ...} in chapters/front/chapter.md shows this figure; show it, or delete the script',
    ],
  ));

test('a folder of chapters without a number in its name is a page behind the chapters', () => {
  const things = front().map(([file, ...rest]) => [
    file === INDEX ? 'chapters/things/chapter.md' : file.replace(/\bfront\b/, 'things'),
    ...rest.map(text => text.replaceAll('front', 'things')),
  ]);
  things[0] = [things[0][0], '# Things\n\n\\figure{race, A race}\nAfter \\number{turns}.\n\\endfigure\n'];
  const read = weaves(...things);
  const page = read('things.html');
  assert.match(
    page,
    /<body class="things">[\s\S]*<h1>Things<\/h1>[\s\S]*<b>Figure 1\. A race\.<\/b> After <data class="number" value="20"/,
  );
  assert.match(page, /<a rel="prev" href="2-euler\.html"[\s\S]*<a rel="next" href="checked\.html"/);
  assert.match(read('claims.html'), /<h2 id="things">Things<\/h2>/);
  assert.doesNotMatch(read('index.html').match(/<ol class="contents">([\s\S]*?)<\/ol>/)[1], /things/);
});

test('a live figure whose parts lie with another chapter', () =>
  refuses(
    [
      ...front(),
      [CHAPTER, '\\figure{spiral', '\\live{spiral'],
      [CHAPTER, '\\endfigure', '\\endlive'],
      ...['cpp', 'js', 'json'].map(kind => [`chapters/front/live/spiral.${kind}`, '{}']),
    ],
    [
      CHAPTER,
      '\\live{spiral',
      'chapters/front/live/spiral.json lies with another chapter; move what is named spiral to chapters/2-euler/live',
    ],
  ));

test('a word of the glossary leads to where it is introduced', () => {
  const read = weaves(words('- \\term{After a dash} Behind it.\n- \\term{step size} How far.\n'), [
    CHAPTER,
    'The energy grows',
    'Its *step\nsize* matters. The energy grows',
  ]);
  const page = read('glossary.html');
  assert.match(
    page,
    /<dfn id="term-after-a-dash">After a dash<\/dfn> <a class="introduced" href="2-euler\.html#growth" aria-label="After a dash: section 2\.2">2\.2<\/a> Behind it\./,
  );
  assert.match(page, /<dfn id="term-step-size">step size<\/dfn> <a class="introduced" href="2-euler\.html#growth"/);
});

test('a word that no chapter introduces, and one that stands twice', () => {
  refuses(
    [words('- \\term{after a dsh} Behind it.\n- \\term{energy} Not in italics.\n')],
    [
      GLOSSARY,
      'dsh',
      'no chapter says *after a dsh* in italics, as where a term is introduced. Did you mean "after a dash"?',
    ],
    [GLOSSARY, '{energy', 'no chapter says *energy* in italics, as where a term is introduced.'],
  );
  refuses(
    [words('- \\term{after a dash} Behind it.\n- \\term{After a dash} Again.\n')],
    [GLOSSARY, '\\term{After', 'the id "term-after-a-dash" stands twice in glossary.html; rename the section or box'],
  );
});

test('a test by its name', () => {
  const read = weaves([TALKS, 'What they say.', '\\tested{Euler gains energy on every step}']);
  assert.match(
    read('talks.html'),
    /<a class="tested" id="cited-1" href="claims\.html#claim-euler-gains-energy-on-every-step">Euler gains energy on every step<\/a>/,
  );
  assert.match(read('claims.html'), /<a href="talks\.html#cited-1">and in the talks<\/a>/);
});

test('a test that nobody wrote', () =>
  refuses(
    [[TALKS, 'What they say.', '\\tested{Euler gains energy on each step}']],
    [
      TALKS,
      '\\tested',
      'no test bears the name of the claim "Euler gains energy on each step". Did you mean "Euler gains energy on every step"?',
    ],
  ));

test('a place that readers call by another name has to be there', () => {
  refuses(
    [['book/search.json', '"called": {}', '"called": { "2-eulr.html": "explicit Euler" }']],
    ['book/search.json', '2-eulr', /^there is no place "2-eulr\.html" in the book\. Did you mean "2-euler\.html"/],
  );
});
