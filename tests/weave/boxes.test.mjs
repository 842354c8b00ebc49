// Boxes that do not open and close as they should, and lists at their ends.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, woven } from './weaver.mjs';

test('a box that is never closed', () =>
  refuses(
    [[CHAPTER, '\\endgoals\n', '']],
    [CHAPTER, '\\goals', '\\goals is never closed; put \\endgoals where it ends'],
  ));

test('a box that is never opened', () =>
  refuses(
    [[CHAPTER, '\\takehome\n', '']],
    [CHAPTER, '\\endtakehome', '\\endtakehome closes nothing; there is no open \\takehome before it'],
  ));

test('boxes that close in the wrong order', () =>
  refuses(
    [
      [CHAPTER, '\\endhint\n', ''],
      [CHAPTER, '\\endexercise', '\\endexercise\n\\endhint'],
    ],
    [CHAPTER, '\\endexercise', '\\endexercise comes before \\endhint: \\hint of line 56 is still open; close it first'],
  ));

test('an inner box that is never closed', () =>
  refuses(
    [[CHAPTER, '\\endanswer\n', '']],
    [
      CHAPTER,
      '\\endexercise',
      '\\endexercise comes before \\endanswer: \\answer of line 60 is still open; close it first',
    ],
  ));

test('boxes in places where they cannot be', () =>
  refuses(
    [
      paragraph('\\hint\nOutside.\n\\endhint\n\n\\aside\n\n## A section\n\n\\endaside'),
      [CHAPTER, 'Each dot is', '\\aside\nx\n\\endaside\nEach dot is'],
    ],
    [CHAPTER, '\\aside\nx', '\\aside stands inside \\figure of line 16, which can hold no box'],
    [CHAPTER, '\\hint\nOutside', '\\hint stands outside of \\exercise; put it between \\exercise and \\endexercise'],
    [CHAPTER, '## A section', 'a heading inside \\aside of line 75; is \\endaside missing?'],
  ));

const CROSSES = 'this box ends in another list item or quotation than it starts in; indent both ends alike';

test('a box that ends in another list item than it starts in', () =>
  refuses(
    [paragraph('- one\n  \\aside\n  text\n- two\n  \\endaside')],
    [CHAPTER, '  \\aside\n  text', CROSSES],
    [CHAPTER, '  \\endaside', CROSSES],
  ));

test('a list directly before the end of a box', () => {
  const boxes = ['- one\n- two', '1. one\n2. two', '- one\n  - inner', '- one\n\n  two', '* one\n  two'];
  const page = woven(boxes.map((list, i) => `\\aside\nBox ${i}.\n\n${list}\n\\endaside\nBehind ${i}.`).join('\n\n'));
  const found = [
    ...page.matchAll(/<div class="aside"[^>]*><p>Box \d\.<\/p>\s*([\s\S]*?)<\/div>\s*<p>Behind \d\.<\/p>/g),
  ].map(([, list]) => list.replace(/\s*\n\s*/g, ''));
  assert.deepEqual(found, [
    '<ul><li>one</li><li>two</li></ul>',
    '<ol><li>one</li><li>two</li></ol>',
    '<ul><li>one<ul><li>inner</li></ul></li></ul>',
    '<ul><li><p>one</p><p>two</p></li></ul>',
    '<ul><li>one two</li></ul>',
  ]);
});

test('a box within a list item, and a list behind a box', () => {
  const page = woven('- one\n  \\aside\n  text\n  \\endaside\n- two\n\n\\aside\nBefore.\n\\endaside\n- three');
  assert.match(page, /<li><p>one<\/p>\n<div class="aside"[^>]*><p>text<\/p><\/div><\/li>\n<li>two<\/li>\n<\/ul>/);
  assert.match(page, /<p>Before\.<\/p><\/div>\n<ul>\n<li>three<\/li>/);
});
