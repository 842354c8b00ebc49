// Answers that fold out, and what they end in: a method with its card, the steps that it needs, lines to copy.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, weaves } from './weaver.mjs';

const CALLS = 'chapters/2-euler/calls.h';
const TABLES = 'built/2-euler/data/tables.csv';
const calls = [CALLS, '// A call.\n// [one]\nintegrate::euler(x, v, h);\n// [one]\n'];
const rates = [
  [TABLES, 'table,column,unit,digits\n', 'table,column,unit,digits\nrates,function,,text\n'],
  ['built/2-euler/data/rates.csv', 'function,name,stands,to 10 %,to 1 %,to 0.1 %\nrk4,RK4,4,5,6,7\n'],
];
const box = text => `\\choice{swings, It swings: "so"}\nA question.\n\n${text}\n\\endchoice`;

test('answers fold out within answers, and end in a header to copy and in lines that include it', () => {
  const page = weaves(
    calls,
    ...rates,
    paragraph(box(`\\choice{one, A spring}\n\\take{euler, one, Euler's method}\n\nA reason.\n\\endchoice`)),
  );
  const html = page('2-euler.html').match(
    /<details class="choice" id="swings">[\s\S]*?<\/details>[\s\S]*?<\/details>/,
  )[0];
  assert.match(
    html,
    /<summary>It swings: “so”<\/summary><div><p>A question\.<\/p>\s*<details class="choice" id="one"><summary>A spring/,
  );
  assert.match(html, /<strong>Euler’s method<\/strong> <span>copy <a href="headers\/euler\.h" download>euler\.h<\/a>/);
  assert.ok(
    html
      .replace(/<[^>]*>/g, '')
      .replace(/&quot;/g, '"')
      .includes('#include "euler.h"\n\nintegrate::euler(x, v, h);'),
    html,
  );
  assert.ok(html.includes('<p>A reason.</p>'));
  assert.ok(!html.includes('class="rates"'), 'the program works out no steps for it');
});

test('a method, lines or a table that are not there are named', () => {
  refuses(
    [calls, ...rates, paragraph(box('\\take{eulr, two, Euler}'))],
    [CHAPTER, '\\take', /^there is no card of a function "eulr"\. Did you mean "euler"\?$/],
    [CHAPTER, '\\take', /^chapters\/2-euler\/calls\.h has no tag "two"/],
  );
  refuses(
    [calls, paragraph(box('\\take{euler, one, Euler}'))],
    [CHAPTER, '\\take', 'the program of this page writes no table "rates"'],
  );
  refuses(
    [calls, ...rates, paragraph(box('\\take{euler, one}'))],
    [CHAPTER, '\\take', '\\take is incomplete; write \\take{function, tag of the lines, Name}'],
  );
});

test('steps a turn stand below the steps a swing, and what was measured folds out', () => {
  const page = weaves(
    calls,
    [TABLES, 'table,column,unit,digits\n', 'table,column,unit,digits\nrates,function,,text\norbits,function,,text\n'],
    ['built/2-euler/data/rates.csv', 'function,name,stands,to 10 %,to 1 %,to 0.1 %\neuler,Euler,4,5,6,7\n'],
    [
      'built/2-euler/data/orbits.csv',
      'function,orbit,to 10 %,to 1 %,to 0.1 %\neuler,circle,8,9,10\nrk4,circle,1,2,3\n',
    ],
    paragraph(box("\\choice{one, A spring}\n\\take{euler, one, Euler's method}\n\\endchoice")),
  );
  const html = page('2-euler.html');
  const rows = [...html.match(/<table class="rates">[\s\S]*?<\/table>/)[0].matchAll(/<tr>([\s\S]*?)<\/tr>/g)].map(
    ([, row]) =>
      row
        .replace(/<[^>]*>/g, ' ')
        .trim()
        .split(/\s{2,}/),
  );
  assert.deepEqual(rows.slice(1), [
    ['steps a swing', '4.0', '5.0', '6.0', '7.0'],
    ['a turn, circle', '–', '8.0', '9.0', '10'],
  ]);
  assert.match(html, /<details class="measured"><summary>[^<]*<\/summary><p class="facts">order /);
});

test('lines that call no header have none to copy, and include what they use of the library', () => {
  const page = weaves(
    [CALLS, '// A call.\n// [one]\nx = std::exp(x);\n// [one]\n'],
    ...rates,
    paragraph(box('\\choice{one, A spring}\n\\take{euler, one, By hand}\n\\endchoice')),
  );
  const [take] = page('2-euler.html').match(/<div class="take" data-function="euler">[\s\S]*?<\/pre>/);
  assert.ok(!/download|its page/.test(take), take);
  assert.ok(
    take
      .replace(/<[^>]*>/g, '')
      .replace(/&lt;/g, '<')
      .replace(/&gt;/g, '>')
      .includes('#include <cmath>\n\nx = std::exp(x);'),
    take,
  );
});
