// Numbers and tables of numbers that are not there, or that no reader could take for one.
import { test } from 'node:test';
import { CHAPTER, NUMBERS, paragraph, refuses } from './weaver.mjs';

const INDEX = 'chapters/front/chapter.md';
const NONE = 'chapters/2-euler/program.cpp writes none of that name.';

test('unknown numbers in sentences and formulas', () =>
  refuses(
    [paragraph('\\number{radus},\n\\number{zzz} and\n\\number{2-euler/stepp} and \\f$ a =\n\\number{stp} \\f$')],
    [CHAPTER, 'radus', `unknown number "radus"; ${NONE} Did you mean "radius"?`],
    [CHAPTER, 'zzz', `unknown number "zzz"; ${NONE} Let it do so: record.number("zzz", ...)`],
    [CHAPTER, 'stepp', `unknown number "2-euler/stepp"; ${NONE} Did you mean "2-euler/step" or "2-euler/steps"?`],
    [CHAPTER, '{stp}', `unknown number "stp"; ${NONE} Did you mean "step" or "steps"?`],
  ));

test('numbers on a page without a program', () =>
  refuses(
    [[INDEX, '\\number{2-euler/radius}', '\\number{radius}\nand \\number{3-euler/radius}']],
    [INDEX, '{radius}', "this page has no program; name the number's chapter, too: \\number{2-euler/radius}"],
    [
      INDEX,
      '3-euler',
      'there is no chapter "3-euler" that could write the number "3-euler/radius". Did you mean "2-euler"?',
    ],
  ));

test('what is no number', () =>
  refuses(
    [
      [NUMBERS, '3.1415926535897931,m,4', 'nan,m,4'],
      [NUMBERS, '123456,,0', '123456.5,,0'],
      paragraph('\\number{steps}'),
    ],
    [CHAPTER, '\\number{radius}', 'the number "radius" is not a number: "nan"; chapters/2-euler/program.cpp wrote it'],
    [
      CHAPTER,
      '\\number{steps}',
      'the number "steps" is shown as an integer and is 123456.5; give it digits; chapters/2-euler/program.cpp wrote it',
    ],
    [
      'chapters/front/chapter.md',
      '\\number{',
      'the number "radius" is not a number: "nan"; chapters/2-euler/program.cpp wrote it',
    ],
  ));

test('a program that has not run', () =>
  refuses(
    [
      [NUMBERS],
      ['chapters/front/chapter.md', '\\number{2-euler/radius}', 'x'],
      [CHAPTER, 'it is \\number{radius} out', 'it is out'],
      [CHAPTER, 'h = \\number{step} \\f$', 'h \\f$ \\look'],
      [CHAPTER, 'h = \\number{step} .', 'h'],
    ],
    [
      'chapters/2-euler/program.cpp',
      '',
      'the program has not written built/2-euler/data/numbers.csv; build the chapter first',
    ],
  ));

test('an unknown table', () =>
  refuses(
    [[CHAPTER, '\\rows{growth}', '\\rows{grwth}']],
    [CHAPTER, 'grwth', 'the program of this chapter writes no table "grwth". Did you mean "growth"?'],
  ));

test('a column that is not described', () =>
  refuses(
    [['built/2-euler/data/tables.csv', 'growth,h,s,2\n', '']],
    [CHAPTER, '\\rows{growth}', 'column "h" of growth.csv has no row in tables.csv'],
  ));

test('a table without its file', () =>
  refuses(
    [['built/2-euler/data/growth.csv']],
    [CHAPTER, '\\rows{growth}', 'tables.csv describes the table "growth", but growth.csv is not there'],
  ));
