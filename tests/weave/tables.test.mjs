// Tables in Markdown: where they stand, what is wrong with them, and bars that are no borders.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, woven } from './weaver.mjs';

test('bars in a sentence', () =>
  refuses(
    [paragraph('Some\nthing is either this | or\nthat')],
    [
      CHAPTER,
      'thing is either',
      '"|" was left standing in "either this | or": Markdown did not take it for markup; write \\| if it is meant so',
    ],
  ));

test('tables with a mistake in them', () =>
  refuses(
    [
      paragraph(
        ['| a | b |\n| 1 | 2 |', '| c | d |\n|---|---|', '| e | f |\n|---|---|\n| 1 | 2 | 3 |\n| 4 |'].join('\n\n'),
      ),
    ],
    [CHAPTER, '| a |', 'this table has no row of dashes below its head; write |---|---| as its second line'],
    [CHAPTER, '| c |', 'this table has a head and no rows; write its rows right below the dashes'],
    [CHAPTER, '| 3 |', 'this row has 3 cells and the head of its table 2; a | that is no border is written \\|'],
    [CHAPTER, '| 4 |', 'this row has 1 cells and the head of its table 2; a | that is no border is written \\|'],
  ));

test('tables in quotations and lists', () => {
  const table = '| a | b |\n|---|---|\n| 1 | 2 |';
  const within = mark => table.replace(/^/gm, mark);
  const found = '<div class="tablescroll"><table><thead><tr><th scope="col">a</th>';
  assert.ok(woven(within('> ')).startsWith(`<blockquote>${found}`));
  assert.match(
    woven(`> A quotation.\n${table}`),
    /^<blockquote><p>A quotation\.<\/p><\/blockquote>\n<div class="tablescroll">/,
  );
  assert.match(
    woven(`1. one\n\n${within('   ')}\n2. two`),
    /<ol>\n<li>one\n<div class="tablescroll">[^]*<\/div><\/li>\n<li>two<\/li>/,
  );
  assert.ok(woven(`- ${within('  ').trim()}`).startsWith(`<ul>\n<li>${found}`));
});

test('a box for a table without one, and with two', () =>
  refuses(
    [
      [CHAPTER, '\\rows{growth}\n', ''],
      [CHAPTER, '| Euler  | 1 | *none* |', '| Euler  | 1 | *none* |\n\\rows{growth}'],
    ],
    [
      CHAPTER,
      '\\table{growth}',
      '\\table{growth} holds 0 tables; put one between its caption and \\endtable: \\rows{name}, or rows in Markdown',
    ],
    [
      CHAPTER,
      '\\table{methods}',
      '\\table{methods} holds 2 tables; put one between its caption and \\endtable: \\rows{name}, or rows in Markdown',
    ],
  ));

test('bars in formulas, in code and behind a backslash are no borders', () => {
  const page = woven('| a | b |\n|:--|--:|\n| \\f$ |x| \\f$ | `p | q` |\n| this \\| that | \\number{radius} |');
  const rows = page.match(/<th scope="col">a<\/th>[\s\S]*?<\/table>/)[0].match(/<tr><td>[\s\S]*?<\/tr>/g);
  assert.equal(rows.length, 2);
  assert.match(
    rows[0],
    /<annotation encoding="application\/x-tex">\|x\|<\/annotation>[\s\S]*<td class="right">.*<code>p \| q<\/code>.*<\/td><\/tr>$/,
  );
  assert.match(
    rows[1],
    /^<tr><td>this \| that<\/td><td class="right"><data class="number"[^>]*>3\.142\u202fm<\/data><\/td><\/tr>$/,
  );
});
