// Exercises that grade themselves, put into the chapter from their own files.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, refuses, sampleBook, weaves } from './weaver.mjs';

const GRADING = 'exercises/grading.md';
const TASK = 'exercises/2-euler/back-again/task.md';

test('a task in its place', () => {
  const page = weaves()('2-euler.html');
  const box = page.match(/<section class="exercise" id="exercise-back-again"[\s\S]*?<\/section>/)[0];
  assert.match(box, /<span class="secno">Exercise 2\.2<\/span> Back again<\/h3>/);
  assert.match(
    box,
    /aria-label="Difficulty 2 of 3: takes some thought">●●○<\/span> <span>find the bug<\/span> <span>15 minutes<\/span>/,
  );
  assert.match(box, /<b>Goal\.<\/b> Say what a negative step does\./);
  assert.match(box, /<summary>Hint<\/summary><div><p>Which line comes first\?/);
  assert.match(box, /href="source-exercises-2-euler-back-again-starter-h\.html"/);
  assert.match(
    box.replace(/<[^>]*>/g, ''),
    /build\/exercises\/grade start back-again\nbuild\/exercises\/grade back-again\.h/,
  );
});

test("how many of a chapter's exercises are graded, and how long they take together", () => {
  const page = weaves(['book/preface.md', '# Preface\n\nOf chapter 2: \\graded{2-euler}.\n'])('preface.html');
  assert.match(page, /Of chapter 2: 1 in 15\u202fmin\./);
});

test('how the tasks are graded is said once, before the first', () => {
  const page = weaves()('2-euler.html');
  assert.equal(page.split('A program grades the rest.').length, 2);
  assert.ok(page.indexOf('A program grades the rest.') < page.indexOf('id="exercise-back-again"'));
  refuses([[GRADING]], [CHAPTER, '\\task{', 'there is no exercises/grading.md; it says how the tasks are graded']);
});

test('what a student must find out is on no page', () => {
  const book = sampleBook(
    ['exercises/2-euler/back-again/solution.h', '// the answer\n'],
    ['exercises/2-euler/back-again/right/other.h', '// another\n'],
  );
  assert.equal(book.weave().status, 0);
  assert.ok(book.has('built/book/source-exercises-2-euler-back-again-starter-h.html'));
  for (const hidden of ['judge-cpp', 'harness-h', 'solution-h', 'right-other-h'])
    assert.ok(!book.has(`built/book/source-exercises-2-euler-back-again-${hidden}.html`), hidden);
  assert.doesNotMatch(book.read('built/book/2-euler.html'), /judge/);
});

test('a task that is not there', () =>
  refuses(
    [[CHAPTER, '\\task{back-again}', '\\task{back-agian}']],
    [CHAPTER, '\\task{back-agian}', 'there is no exercises/2-euler/back-agian/task.md. Did you mean "back-again"?'],
    [TASK, '# Back', 'chapters/2-euler/chapter.md does not show this exercise; write \\task{back-again} there'],
  ));

test('a mistake in a task is told with its own file and line', () =>
  refuses(
    [[TASK, 'Which line', 'Which \\numbr{line}']],
    [TASK, 'Which', 'unknown mark \\numbr. Did you mean \\number?'],
  ));

test('a mistake below a task is told with the line of the chapter', () =>
  refuses([[CHAPTER, 'A remark.', 'A \\remarkable one.']], [CHAPTER, 'A \\remarkable', /^unknown mark \\remarkable/]));

test('a head that lacks a line, or says what is none', () =>
  refuses(
    [[TASK, 'Kind: bug\nDifficulty: 2\nMinutes: 15', 'Kind: bugs\nDifficulty: 9\nTime: long']],
    [
      TASK,
      'Kind',
      'a task is of one of the kinds write, bug, stability, cost, design, not "bugs". Did you mean "bug"?',
    ],
    [TASK, 'Difficulty', 'the difficulty of a task is 1, 2 or 3'],
    [TASK, 'Time', 'line 5 of a task says "Minutes: ..."'],
  ));

test('a task within a sentence', () =>
  refuses(
    [[CHAPTER, 'A remark.', 'See \\task{back-again}.']],
    [CHAPTER, 'See \\task', '\\task{name} stands on a line of its own, in a chapter'],
  ));
