// Tables in Markdown: what Doxygen would make a paragraph of, and bars that are no borders.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, woven } from './weaver.mjs';

test('a table that came out as a paragraph', () =>
  refuses(
    [paragraph('> A quotation.\n| a | b |\n|---|---|\n| 1 | 2 |')],
    [
      CHAPTER,
      '| a | b |',
      'this table came out as a paragraph; check that each of its rows starts and ends with | and that the line above it is empty',
    ],
  ));

test('bars in a sentence', () =>
  refuses(
    [paragraph('Some\nthing is either this | or\nthat')],
    [
      CHAPTER,
      'thing is either',
      '"|" was left standing in "either this | or that": Doxygen did not take it for markup; write \\| if it is meant so',
    ],
  ));

test('tables with a mistake in them', () =>
  refuses(
    [
      paragraph(
        [
          '| a | b |\n| 1 | 2 |',
          '| c | d |\n|---|---|',
          '| e | f |\n|---|---|\n| 1 | 2 | 3 |\n| 4 |',
          '> | g | h |\n> |---|---|\n> | 1 | 2 |',
          '1. one\n\n   | i | j |\n   |---|---|\n   | 1 | 2 |\n2. two',
        ].join('\n\n'),
      ),
    ],
    [CHAPTER, '| a |', 'this table has no row of dashes below its head; write |---|---| as its second line'],
    [CHAPTER, '| c |', 'this table has a head and no rows; write its rows right below the dashes'],
    [CHAPTER, '| 3 |', 'this row has 3 cells and the head of its table 2; a | that is no border is written \\|'],
    [CHAPTER, '| 4 |', 'this row has 1 cells and the head of its table 2; a | that is no border is written \\|'],
    [
      CHAPTER,
      '> | g',
      'a table cannot start behind a > or in the line of a list mark: Doxygen makes a paragraph of it; put it on lines of its own',
    ],
    [
      CHAPTER,
      '| i |',
      'this table stands apart from its list item; put it right below the text of the item, without an empty line, or do not indent it',
    ],
  ));

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
