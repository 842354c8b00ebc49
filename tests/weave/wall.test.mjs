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
