// The shelf: what a header promises, beside what was measured of it.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { refuses, weaves } from './weaver.mjs';

const CARDS = 'code/measure/shelf_card.h';
const LAMP = 'code/shelf/lamp.h';
const lamp = [
  LAMP,
  '/// @file\n/// A lamp.\n///\n/// @code\n/// shelf::lamp(1.0);\n/// @endcode\n///\n' +
    '/// Promises:\n/// - shines for h^2 seconds, to 1e-12 of them\n/// - is off\n/// afterwards\n#pragma once\n' +
    '/// Things.\nnamespace shelf {\n\n/// Shines.\ntemplate <class Vec>\nvoid lamp(const Vec& x) {}\n\n}  // namespace shelf\n',
];
const LISTS = [
  ['code/measure/shelf/lamp.cpp', '// Measures a lamp.\n'],
  ['built/shelf/tables.csv', 'table,column,unit,digits\nlamp,promise,,text\n'],
  ['built/shelf/numbers.csv', 'name,value,unit,digits\n'],
];
const measured = (...rows) => [
  ...LISTS,
  ['built/shelf/lamp.csv', `promise,kept,measured,digits,unit\n${rows.join('\n')}\n`],
];
const KEPT = ['"shines for h^2 seconds, to 1e-12 of them",yes,2.5e-13,2,s', 'is off afterwards,yes,off,0,1'];

test('a header of the shelf is in the index, and its promises stand beside what was measured', () => {
  const read = weaves(lamp, ...measured(...KEPT));
  assert.match(read('snippets.html'), /<h2 id="things">[\s\S]*<dt><a href="shelf-lamp.html"><code>lamp.h<\/code>/);
  const page = read('shelf-lamp.html');
  assert.match(
    page,
    /<dt>shines for h<sup>2<\/sup> seconds, to 10<sup>−12<\/sup> of them<\/dt><dd>2\.5\u00a0×\u00a010<sup>−13<\/sup>\u202fs<\/dd>/,
  );
  assert.match(page, /<dt>is off afterwards<\/dt><dd>off<\/dd>/);
  assert.doesNotMatch(page.replace(/<pre[^]*?<\/pre>/g, ''), /Promises:/);
  assert.match(page, /A <code>Vec<\/code> is whatever has/);
});

test('a promise that is not kept', () =>
  refuses(
    [lamp, ...measured(KEPT[0], 'is off afterwards,no,on,0,1')],
    [LAMP, '', 'a promise is not kept: "is off afterwards"; measured: on'],
  ));

test('a header of which nothing is measured', () =>
  refuses(
    [lamp, ...LISTS.map(([name, text]) => [name, text.replace('lamp,promise,,text\n', '')])],
    [LAMP, '', 'nothing is measured of lamp.h; write code/measure/shelf/lamp.cpp'],
  ));

test('a shelf that is not measured yet', () =>
  refuses(
    [lamp, [CARDS, '// All cards.\n']],
    [CARDS, '', 'what the shelf promises is not measured yet; build the target measured_shelf first'],
  ));
