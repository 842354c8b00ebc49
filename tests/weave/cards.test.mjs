// Cards: the one of a method on its page, in a chapter and in the list of all methods; and headers that explain themselves.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { test } from 'node:test';
import { CARDS, CHAPTER, METHODS, refuses, sampleBook, weaves } from './weaver.mjs';

const EULER = 'code/integrate/euler.h';
const HEUN = 'code/integrate/heun.h';
const heun = (name, parameters, example = '') => [
  HEUN,
  `/// @file\n/// Heun's method.\n${example}#pragma once\nnamespace integrate {\n\n` +
    `/// Half of it.\ntemplate <class Vec>\nVec heun_start(const Vec& x) { return x; }\n\n` +
    `/// One step.\ntemplate <class Vec>\nvoid ${name}(${parameters}) { x = x + v; }\n\n}  // namespace integrate\n`,
];
const withCard = (...names) =>
  names.flatMap(name => [
    ['built/cards/tables.csv', 'euler,unit,,text\n', `euler,unit,,text\n${name},name,,text\n`],
    [
      `built/cards/${name}.csv`,
      'name,about,asked,measured,digits,unit\nsuits,card,suits,a spring,0,1\norder,Order,position,exact,2,1\norder-velocity,Order,velocity,exact,2,1\n',
    ],
  ]);

test('the same card on the page of the method and in a chapter', () => {
  const read = weaves();
  const card = html => html.match(/<div class="card"[\s\S]*?<div class="parts">([\s\S]*?)<p class="note">(.*?)<\/p>/);
  const [, reference, note] = card(read('integrate-euler.html'));
  assert.equal(card(read('2-euler.html'))[1], reference);
  assert.equal(note, 'The time is the best of nine runs on a &lt;sample&gt; machine.');
  const line = (asked, measured) =>
    assert.ok(reference.includes(`<div><dt>${asked}</dt><dd>${measured}</dd></div>`), `${asked}: ${reference}`);
  line('on an orbit, position', '1.0');
  line('evaluations of the acceleration', '1');
  line('time, on an orbit', '15\u202fns');
  line('drag, <i>ch</i>', '2.00');
  line('spring with <i>ζ</i> = 0.5, <i>hω</i>', '0.912');
  line('undamped spring, <i>hω</i>', 'never');
  line('change per step', '\u22121.39\u00a0×\u00a010<sup>\u22126</sup>\u202f%');
  assert.equal(reference.match(/<p class="label">/g).length, 4);
  assert.ok(read('data/cards/euler.csv').startsWith('name,about,'));
});

test('the list of methods says what the cards say', () => {
  const page = weaves(
    heun('heun', 'Vec& x, Vec& v', '///\n/// @code\n/// integrate::heun(x, integrate::heun_start(v));\n/// @endcode\n'),
    ...withCard('heun'),
  )('snippets.html');
  const [, first, second] = page.split('<table class="methods">');
  const cells = table => [...table.matchAll(/<td><span class="head">.*?<\/span> (.*?)<\/td>/g)].map(([, cell]) => cell);
  assert.match(
    page,
    /<h2 id="for-any-acceleration">For any acceleration<\/h2>[\s\S]*<h2 id="for-a-spring">For a spring<\/h2>/,
  );
  assert.deepEqual(cells(first), [
    '1',
    '1',
    '1',
    '15\u202fns',
    '2.00',
    'never',
    '–',
    '–',
    'falls <small>1.39\u00a0×\u00a010<sup>−6</sup>\u202f% a step</small>',
  ]);
  assert.deepEqual(cells(second), ['exact', '–', '–', '–', '–', '–', '–', '–', '–']);
  assert.match(
    second,
    /<a href="integrate-heun\.html#heun"><code>heun<\/code><\/a> <span>One step\. <a href="headers\/heun\.h" download>file<\/a><\/span>/,
  );
});

test('the page of a header has its example, and leads to the file', () => {
  const read = weaves();
  const page = read('integrate-euler.html');
  assert.match(
    page.replace(/<[^>]*>/g, ''),
    /#include (&quot;|")euler\.h\1\n\ndouble x = 1, v = 0;\nintegrate::euler\(x, v, 0\.0, 0\.1, \[\]\(double x/,
  );
  assert.match(page, /Take <a href="headers\/euler\.h" download>euler\.h<\/a>, .*It needs C\+\+17 and nothing else\./);
  assert.ok(read('headers/euler.h').startsWith('// SPDX'));
  assert.match(
    read('integrate.html'),
    /<a href="integrate-euler\.html"><code>euler\.h<\/code><\/a><\/dt><dd>Euler’s method, for a sample\./,
  );
});

test('a header that needs a library', () => {
  const page = weaves([EULER, '#pragma once\n', '#pragma once\n#include <Eigen/Core>\n#include <cmath>\n'])(
    'integrate-euler.html',
  );
  assert.match(page, /It needs C\+\+17 and Eigen\./);
});

test('a function that steps and has no card', () =>
  refuses(
    [heun('heun', 'Vec& x, Vec& v', '/// @code\n/// heun(heun_start())\n/// @endcode\n')],
    [HEUN, 'void heun(', `heun steps and has no card; list it in code/measure/methods`],
  ));

test('cards of what is no function, and of one that does not step', () =>
  refuses(
    [
      heun('heun', 'Vec x, Vec& v', '/// @code\n/// heun(heun_start())\n/// @endcode\n'),
      [METHODS, '  function = "euler";\n', '  function = "euler";\n  function = "heun";\n  function = "eulr";\n'],
      ...withCard('heun', 'eulr'),
    ],
    [METHODS, '"heun"', 'a card of "heun", which is no function in code/integrate that steps.'],
    [METHODS, '"eulr"', 'a card of "eulr", which is no function in code/integrate that steps. Did you mean "euler"?'],
  ));

test('cards that are not measured yet', () =>
  refuses(
    [['built/cards/tables.csv'], [CHAPTER, '\\card{euler}\n', '']],
    [CARDS, '', 'the cards of the methods are not measured yet; build the target measured_cards first'],
  ));

test('a card that nobody measured, in a chapter', () =>
  refuses(
    [[CHAPTER, '\\card{euler}', '\\card{eulr}']],
    [CHAPTER, 'card{', 'there is no card of a function "eulr". Did you mean "euler"?'],
  ));

test('functions that no example calls', () =>
  refuses(
    [heun('heun', 'Vec& x, Vec& v'), ...withCard('heun')],
    [
      HEUN,
      'Vec heun_start',
      'no example shows how heun_start is used; put one between @code and @endcode into the first comment of heun.h',
    ],
    [
      HEUN,
      'void heun(',
      'no example shows how heun is used; put one between @code and @endcode into the first comment of heun.h',
    ],
  ));

test('an example of one function is one of another that takes the same', () => {
  const twin = '/// Again.\ntemplate <class Vec>\nVec heun_again(const Vec& x) { return x; }\n\n';
  const [name, text] = heun('heun', 'Vec& x, Vec& v', '/// @code\n/// heun(heun_start())\n/// @endcode\n');
  const book = sampleBook([name, text.replace('/// One step.', `${twin}/// One step.`)], ...withCard('heun'));
  assert.equal(book.weave().stderr, '');
});

// The kinds of vectors of tests/snippets, as one text on one line.
const kindsOfVectors = () => {
  const folder = new URL('../snippets/kinds/', import.meta.url);
  const texts = readdirSync(folder).map(name => readFileSync(new URL(name, folder), 'utf8'));
  return texts.join('').replace(/\s+/g, ' ');
};

test('what the list of methods tells a reader to add to a library is what the tests add to it', () => {
  const page = weaves()('snippets.html');
  const added = [...page.matchAll(/<code>(inline .*?)<\/code>/g)].map(([, code]) => code);
  assert.equal(added.length, 2);
  const kinds = kindsOfVectors();
  for (const code of added) assert.ok(kinds.includes(code), code);
});
