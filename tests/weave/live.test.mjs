// Live figures: what is built on the still picture, what a page loads for it, and what is missing.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, MODULE, refuses, sampleBook } from './weaver.mjs';

const FOLDER = 'chapters/2-euler/live';
const DESCRIPTION = JSON.stringify({
  seconds: 1,
  pace: 1,
  shape: [1, 1],
  scene: 'place [m]',
  chart: { name: 'energy', curves: [{ value: 'energy', colour: 'method' }], from: 0, to: 2 },
  controls: [
    { name: 'method', label: 'Method', choices: { euler: 'Euler' }, start: 'euler' },
    { name: 'h', label: 'Step', from: 0, to: 1, by: 0.1, start: 0.5 },
  ],
});
const live = [
  [CHAPTER, '\\figure{spiral', '\\live{spiral'],
  [CHAPTER, '\\endfigure', '\\endlive'],
  [`${FOLDER}/spiral.cpp`, 'int x;\n'],
  [`${FOLDER}/spiral.js`, 'draw();\n'],
  [`${FOLDER}/spiral.json`, DESCRIPTION],
];
const method = ['code/integrate/euler.h', '  const Vec a', '  // [move]\n  const Vec a'];
const methodEnd = ['code/integrate/euler.h', '  v = v + h * a;\n', '  v = v + h * a;\n  // [move]\n'];
const module = [MODULE, 'any bytes'];

function weaves(...edits) {
  const book = sampleBook(...edits);
  const { status, stderr } = book.weave();
  assert.equal(stderr, '');
  assert.equal(status, 0);
  return book;
}

test('a live figure: the still picture, the stage with its controls and the code of its method', () => {
  const page = weaves(...live, method, methodEnd, module).read('built/book/2-euler.html');
  assert.match(
    page,
    /<figure class="plot" id="figure-spiral" data-live="spiral"><div class="still"><div class="wide" style="[^"]*"><svg/,
  );
  assert.match(
    page,
    /<template>[\s\S]*<input type="radio" name="spiral-method" value="euler" checked>[\s\S]*<input type="range" min="0" max="1" step="0\.1" value="0\.5">[\s\S]*<\/template>/,
  );
  assert.match(page, /data-method="euler"[^]*?const<\/span> Vec a/);
  assert.match(page, /<b>Figure 2\.1\. /);
});

test('the page of a live figure loads its scripts, and no other page does', () => {
  const book = weaves(...live, method, methodEnd, module);
  const scripts = page => [...book.read(`built/book/${page}`).matchAll(/src="(live\/[^"]*)"/g)].map(found => found[1]);
  assert.deepEqual(
    scripts('2-euler.html').filter(src => !book.has(`built/book/${src}`)),
    [],
  );
  for (const needed of ['live/compiled.js', 'live/live.js', 'live/spiral.js'])
    assert.ok(scripts('2-euler.html').includes(needed), needed);
  for (const page of ['index.html', 'references.html', 'claims.html']) assert.deepEqual(scripts(page), []);
});

test('without a compiler for the browser the figure is a still one', () => {
  const book = weaves(...live, method, methodEnd);
  const page = book.read('built/book/2-euler.html');
  assert.match(page, /<figure class="plot" id="figure-spiral"><div class="wide" style="[^"]*"><svg/);
  assert.doesNotMatch(page, /data-live|class="stage"|src="live\//);
  assert.ok(!book.has('built/book/live'));
});

const parts = [
  CHAPTER,
  'Each dot is one step, with',
  'Each dot is one step.\n\n\\paper\nThe line is \\number{step} wide.\n\\endpaper\n\n\\screen\nMove the *step*.\n\\endscreen\n\nWith',
];

test('a caption may say one thing on paper and another on the screen', () => {
  const page = weaves(...live, method, methodEnd, module, parts).read('built/book/2-euler.html');
  const caption = page.match(/<figcaption><p><b>Figure 2\.1[^]*?<\/figcaption>/)[0];
  assert.match(
    caption,
    /<div class="on-paper"><p>The line is <data[^>]*>0\.10\u202fs<\/data> wide\.<\/p><\/div>\s*<div class="on-screen"><p>Move the <em>step<\/em>\.<\/p><\/div>/,
  );
  assert.doesNotMatch(page.match(/<desc id="figure-spiral-wide-desc">[^<]*/)[0], /Move/);
  const style = weaves(...live, method, methodEnd, module).read('built/book/live/live.css');
  assert.match(style, /^figcaption \.on-screen \{ display: none; \}/m);
  assert.match(
    style,
    /^@media screen \{ \.stage ~ figcaption \.on-paper \{ display: none; \} \.stage ~ figcaption \.on-screen \{ display: block; \} \}/m,
  );
});

test('a figure that is a still one has the words for paper alone', () => {
  const page = weaves(...live, method, methodEnd, parts).read('built/book/2-euler.html');
  assert.match(page, /<div class="on-paper"><p>The line is/);
  assert.doesNotMatch(page, /on-screen|Move the/);
});

test('a claim that the words for the screen make is not looked for in a book without live figures', () => {
  const said = [
    CHAPTER,
    'Each dot is one step, with',
    '\\screen\nIt gains \\claim{Nobody cites this claim}.\n\\endscreen\n\nWith',
  ];
  const places = (...more) =>
    weaves(...live, method, methodEnd, said, ...more)
      .read('built/book/claims.html')
      .match(/Nobody cites this claim<\/span>[^]*?<\/li>/)[0];
  assert.match(places(module), /<a href="2-euler\.html#cited-\d+">said in chapter 2<\/a>/);
  assert.match(places(), /not said in the text/);
});

test('words for the screen, outside of a live figure', () =>
  refuses(
    [[CHAPTER, 'Each dot is one step, with', 'Each dot is one step, with\n\n\\screen\nMove it.\n\\endscreen\n\n']],
    [CHAPTER, '\\screen', '\\screen stands outside of \\live; put it between \\live and \\endlive'],
  ));

test('a live figure that nothing describes', () =>
  refuses(
    [
      ...live,
      [CHAPTER, '\\live{spiral', '\\live{spirall'],
      ['chapters/2-euler/spirall.gp', 'plot x\n'],
      ['chapters/2-euler/spiral.gp'],
      ...['', '-narrow'].map(size => [
        `built/2-euler/figures/spirall${size}.svg`,
        '<svg xmlns="http://www.w3.org/2000/svg"/>',
      ]),
    ],
    [
      CHAPTER,
      '\\live{spirall',
      `there is no ${FOLDER}/spirall.json that describes the live figure "spirall". Did you mean "spiral"?`,
    ],
    [CHAPTER, '\\figref{spiral}', /there is no \\figure\{spiral\}/],
    [
      `${FOLDER}/spiral.json`,
      '',
      'no page shows this with \\live{spiral, ...}; show it, or delete what is named spiral',
    ],
  ));

test('a live figure without its parts', () =>
  refuses(
    [...live, [`${FOLDER}/spiral.js`]],
    [CHAPTER, '\\live{spiral', `there is no ${FOLDER}/spiral.js, which the live figure "spiral" needs`],
    [
      CHAPTER,
      '\\live{spiral',
      /^the live figure shows the code of its methods: code\/integrate\/euler\.h has no tag "move"\./,
    ],
  ));

const described = change => [`${FOLDER}/spiral.json`, JSON.stringify({ ...JSON.parse(DESCRIPTION), ...change })];
// What the script of the figure says of it.
const description = book => JSON.parse(book.read('built/book/live/spiral.js').match(/\] = ({.*});/)[1]);
const other = live.filter(([file]) => !file.endsWith('.json'));

test('a live figure may show a table of its chapter, and the code of a method from another place', () => {
  const book = weaves(
    ...other,
    described({ tables: ['growth'], code: { euler: { path: 'code/integrate/euler.h', tag: 'step' } } }),
    module,
  );
  assert.deepEqual(description(book).tables.growth.h, [0.1, 0.01, 1e-7]);
  assert.match(book.read('built/book/2-euler.html'), /data-method="euler"[^]*?the old velocity[^]*?<\/template>/);
});

test('a live figure may draw with numbers of its chapter', () => {
  const book = weaves(...other, described({ numbers: ['step', 'radius'] }), method, methodEnd, module);
  assert.deepEqual(description(book).numbers, { step: 0.1, radius: 3.141592653589793 });
});

test('a live figure that wants a number nobody records', () =>
  refuses(
    [...other, described({ numbers: ['stp'] }), method, methodEnd],
    [CHAPTER, '\\live{spiral', /^chapters\/2-euler\/live\/spiral\.json: unknown number "stp".*Did you mean "step"/],
  ));

test('a live figure that wants a table nobody writes', () =>
  refuses(
    [...other, described({ tables: ['growht'] }), method, methodEnd],
    [
      CHAPTER,
      '\\live{spiral',
      `${FOLDER}/spiral.json wants the table "growht", and the program of this chapter writes none of that name. Did you mean "growth"?`,
    ],
  ));

test('a description that is no JSON', () =>
  refuses([...live, [`${FOLDER}/spiral.json`, '{ "controls": ']], [`${FOLDER}/spiral.json`, '', /^this is no JSON: /]));

const SENTENCE = 'Each dot is one step, with';
const says = mark => [...live, method, methodEnd, module, [CHAPTER, SENTENCE, `Try ${mark}. ${SENTENCE}`]];

test('words that set a live figure', () =>
  assert.match(
    weaves(...says('\\set{spiral?method=euler&h=0.25, a quarter, say}')).read('built/book/2-euler.html'),
    /<a class="set" href="#figure-spiral" data-set="method=euler&amp;h=0\.25">a quarter, say<\/a>/,
  ));

for (const [what, mark, told] of [
  ['nothing', 'spiral, words', /^\\set\{\.\.\.\} names a live figure and what is set in it/],
  ['a figure that is not there', 'spirl?h=1, words', /^there is no live figure "spirl" on this page.*spiral/],
  [
    'a control that is not there',
    'spiral?step=1, words',
    /^the live figure "spiral" has no control "step"\. There is "method", "h"\./,
  ],
  ['a choice that is not there', 'spiral?method=eular, words', /^"eular" is no choice of "method".*"euler"/],
  ['a value beyond its slider', 'spiral?h=2, words', '"h" cannot be 2: it goes from 0 to 1'],
])
  test(`words that set ${what}`, () => refuses(says(`\\set{${mark}}`), [CHAPTER, 'Try', told]));

test('words that set what is dragged in the picture, up and down alone', () => {
  const handle = { name: 'Ledge', x: { at: 1 }, y: { set: 'ledge', from: 0, to: 2, start: 1 }, by: 0.1, unit: 'm' };
  const held = mark => [
    ...other,
    described({ handle }),
    method,
    methodEnd,
    module,
    [CHAPTER, SENTENCE, `Try ${mark}. ${SENTENCE}`],
  ];
  const page = weaves(...held('\\set{spiral?ledge=1.5, higher}')).read('built/book/2-euler.html');
  assert.match(page, /data-set="ledge=1\.5">higher<\/a>/);
  const wrong = [CHAPTER, 'Try', /has no control "hedge"\. .*"ledge"/];
  refuses(held('\\set{spiral?hedge=1, x}'), wrong);
  refuses(held('\\set{spiral?ledge=3, x}'), [CHAPTER, 'Try', '"ledge" cannot be 3: it goes from 0 to 2']);
});
