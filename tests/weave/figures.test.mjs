// Figures and listings whose sources are not there, or are not what they should be.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, weaves } from './weaver.mjs';

const EULER = 'code/integrate/euler.h';
const listing = (path, tag) => paragraph(`\\listing{${path}, ${tag}}`);

test('a figure without a script', () =>
  refuses(
    [paragraph('\\figure{spirals, Title}\nCaption. \\look\n\\endfigure')],
    [
      CHAPTER,
      'spirals',
      'there is no chapters/2-euler/spirals.gp that draws the figure "spirals". Did you mean "spiral"?',
    ],
  ));

test('a figure that is not drawn', () =>
  refuses(
    [['built/2-euler/figures/spiral-narrow.svg']],
    [
      CHAPTER,
      '\\figure{spiral',
      'chapters/2-euler/spiral.gp has not drawn built/2-euler/figures/spiral-narrow.svg; is the chapter built?',
    ],
  ));

test('a script whose figure is not shown', () =>
  refuses(
    [['chapters/2-euler/orbit.gp', 'plot sin(x)\n']],
    [
      'chapters/2-euler/orbit.gp',
      '',
      'no \\figure{orbit, ...} in chapters/2-euler/chapter.md shows this figure; show it, or delete the script',
    ],
  ));

test('marks and formulas in a title', () =>
  refuses(
    [
      [CHAPTER, "Ten turns of a planet's year", 'Ten \\f$ h \\f$'],
      [CHAPTER, 'There and back', 'There by \\number{radius}'],
      [CHAPTER, 'step, The step}', 'step, \\quux}'],
    ],
    [CHAPTER, 'Ten \\f$', 'a formula in a title: write the title in words and put the formula into the text below'],
    [CHAPTER, '\\quux', 'a mark in a title: titles are plain text'],
    [CHAPTER, 'There by', 'a mark in a title: titles are plain text'],
  ));

test('snippets: no such file, no such tag, a file that nothing compiles', () =>
  refuses(
    [
      ['book/notes.h', '// [x]\nint x;\n// [x]\n'],
      paragraph(
        '\\listing{code/integrate/eulr.h, step}\n\n\\listing{code/integrate/euler.h, stp}\n\n' +
          '\\listing{code/scenes/spring.h, step}\n\n\\listing{book/notes.h, x}',
      ),
    ],
    [
      CHAPTER,
      'eulr.h',
      'there is no file code/integrate/eulr.h; paths start at the top of the repository. Did you mean "code/integrate/euler.h"?',
    ],
    [CHAPTER, '.h, stp', `${EULER} has no tag "stp". Did you mean "step"?`],
    [
      CHAPTER,
      'spring.h',
      'code/scenes/spring.h has no tag "step". Put a line "// [step]" before and after the lines to show.',
    ],
    [CHAPTER, 'notes.h', 'book/notes.h is not a C++ file under code/ or chapters/, so nothing compiles it'],
  ));

test('a tag that stands once, and one thrice', () =>
  refuses(
    [
      [EULER, '  v = v + h * a;\n  // [step]\n', '  v = v + h * a;\n'],
      [EULER, '#pragma once\n', '#pragma once\n// [position]\n'],
      listing(EULER, 'position'),
    ],
    [
      CHAPTER,
      'step, The step',
      `tag "step" stands once in ${EULER} (line 27); it must stand twice, before and after the lines to show`,
    ],
    [
      CHAPTER,
      ', position',
      `tag "position" stands 3 times in ${EULER} (lines 10, 29, 31); it must stand twice, before and after the lines to show`,
    ],
  ));

test('tags around documentation alone', () =>
  refuses(
    [
      ['code/scenes/spring.h', '/// A mass on a spring', '// [doc]\n/// A mass on a spring'],
      ['code/scenes/spring.h', 'template <class Real = double>', '// [doc]\ntemplate <class Real = double>'],
      listing('code/scenes/spring.h', 'doc'),
    ],
    [
      CHAPTER,
      ', doc}',
      'nothing but documentation stands between the two tags of "doc" in code/scenes/spring.h (lines 6 and 8)',
    ],
  ));

test('two tags as one listing, with a gap between, indented as one', () => {
  const signature = [
    EULER,
    'template <class Vec, class Time, class Real, class Acceleration>\n',
    '// [signature]\ntemplate <class Vec, class Time, class Real, class Acceleration>\n// [signature]\n',
  ];
  const page = weaves(signature, listing(EULER, 'signature + position'))('2-euler.html');
  const [first, gap, second] = [...page.matchAll(/<span class="ln( gap)?" data-n="(\d+)"><\/span>([^\n]*)/g)]
    .slice(-2)
    .flatMap((m, i) => (i ? [m[1], m[3]] : [m[3]]));
  assert.match(first.replace(/<[^>]*>/g, ''), /^template &lt;class Vec/);
  assert.equal(gap, ' gap');
  assert.match(second.replace(/<[^>]*>/g, ''), /^  x = x \+ h \* v;/);
});

test('marks are not in what readers copy', () => {
  const read = weaves();
  assert.doesNotMatch(read('headers/euler.h'), /\[step\]/);
  assert.match(read('headers/euler.h'), /v = v \+ h \* a;\n\}\n/);
  const page = read('source-code-integrate-euler-h.html');
  assert.doesNotMatch(page, /\[step\]/);
  assert.match(page, /id="L33"/);
});
