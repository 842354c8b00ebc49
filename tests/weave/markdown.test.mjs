// What a chapter cannot hold: C++, unknown marks, headings and pictures of Markdown's own.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, woven } from './weaver.mjs';

const CUT = 'C++ typed into the prose; cut it from a compiled file with \\listing{path, tag}';

test('C++ in a fence', () =>
  refuses(
    [
      paragraph(
        '```cpp\nint a;\n```\n\n~~~{.cpp}\nint b;\n~~~\n\n```c++ title\nint c;\n```\n\n- ```cpp\n  int d;\n  ```',
      ),
    ],
    [CHAPTER, '```cpp\nint a', CUT],
    [CHAPTER, '~~~{.cpp}', CUT],
    [CHAPTER, '```c++', CUT],
    [CHAPTER, '- ```cpp', CUT],
  ));

test('a fence in the line of a list mark, and one within a sentence', () => {
  assert.match(
    woven('- ```sh\n  ls\n  ```\n- two'),
    /<li><div class="codebox terminal">.*ls.*<\/div><\/li>\n<li>two<\/li>/,
  );
  refuses(
    [paragraph('Run ```sh\nls\n```')],
    [CHAPTER, 'Run ```', 'a fence starts on a line of its own; put ``` on the next'],
  );
});

test('code by indentation', () =>
  refuses(
    [paragraph('Text.\n\n    int first;')],
    [CHAPTER, 'int first', 'code by indentation; put it between ``` lines, or indent it less if it is no code'],
  ));

const html = tag => `HTML has no looks in this book: <${tag}>; write < as \\<, or put code into backticks`;

test('HTML', () =>
  refuses(
    [paragraph('A <foo> and\na </quux> here.\n\n<pre>int a;\n</pre>\n\nBut vector<Body>, a<b, c>d and 1 < 2 may be.')],
    [CHAPTER, '<foo>', html('foo')],
    [CHAPTER, 'quux', html('/quux')],
    [CHAPTER, '<pre>', html('pre')],
    [CHAPTER, '</pre>', html('/pre')],
  ));

test('unknown and incomplete marks', () =>
  refuses(
    [
      paragraph(
        '\\figrf{x}\n\\quux\n@code\n\\code{.cpp}\n\\citep{}\n\\lstref{code/integrate/euler.h}\n\\number{radius\n\n\\figure{spiral}\nCaption.\n\\endfigure',
      ),
    ],
    [CHAPTER, '\\figrf', 'unknown mark \\figrf. Did you mean \\figref or \\figure?'],
    [CHAPTER, '\\quux', 'unknown mark \\quux. Write \\\\quux if the text itself is meant.'],
    [CHAPTER, '@code', 'unknown mark @code; write \\@code if the text itself is meant'],
    [CHAPTER, '\\code{', 'unknown mark \\code. Write \\\\code if the text itself is meant.'],
    [CHAPTER, '\\citep{}', '\\citep is incomplete; write \\citep{key}'],
    [CHAPTER, '\\lstref{code/integrate/euler.h}', '\\lstref is incomplete; write \\lstref{path, tag}'],
    [CHAPTER, '\\number{radius\n', '\\number is incomplete; write \\number{name}'],
    [CHAPTER, '\\figure{spiral}', '\\figure is incomplete; write \\figure{name, Title}'],
  ));

test('headings', () =>
  refuses(
    [
      paragraph(
        '## With \\f$ h \\f$\n\n## With \\number{radius}\n\n#### Too deep\n\n# Another title\n\nUnderlined\n----------\n\nTwice\n=====',
      ),
    ],
    [CHAPTER, '## With \\f$', 'a formula in a heading: write the heading in words'],
    [CHAPTER, '## With \\number', 'a mark in a heading: headings are plain text and `code`'],
    [CHAPTER, '#### Too', 'a heading of level 4 right below one of level 2; leave no level out'],
    [CHAPTER, '# Another', 'a second title; sections start with ##'],
    [
      CHAPTER,
      '----------\n',
      '---------- below a line of text makes it a heading; write it as "## Heading", or put an empty line between',
    ],
    [
      CHAPTER,
      '=====',
      '===== below a line of text makes it a heading; write it as "## Heading", or put an empty line between',
    ],
  ));

test('a page without a title', () =>
  refuses(
    [[CHAPTER, "# Euler's method\n", 'Text\n']],
    [CHAPTER, '', 'a page starts with its title; write "# Title" in the first line'],
  ));

test('what is never closed', () =>
  refuses(
    [
      paragraph('A `span.\n\n```sh\nls'),
      ['chapters/front/chapter.md', '\\contents', '\\contents\n<!-- x'],
      [CHAPTER, '```sh\ncmake --build build --target 2-euler   # \\number{radius} stays as it is\n```\n', ''],
    ],
    [CHAPTER, 'A `span', 'this code span is never closed; put ` after it, or write \\` for a backtick'],
    [CHAPTER, '```sh', 'this fence is never closed; put a line ``` after the code'],
    ['chapters/front/chapter.md', '<!--', 'this comment is never closed; put --> after it'],
  ));

const PICTURE =
  'a picture from outside; pictures of this book are drawn by a script of the chapter: \\figure{name, Title}';

test('pictures and footnotes', () => {
  refuses(
    [paragraph('One ![alt](x.png)\ntwo <img src="x.png">')],
    [CHAPTER, 'One', PICTURE],
    [CHAPTER, 'two', PICTURE],
  );
  refuses(
    [paragraph('Text[^1].\n\n[^1]: lost')],
    [CHAPTER, 'Text[^1]', /^"\[\^" was left standing/],
    [CHAPTER, '[^1]: lost', /^"\[\^" was left standing/],
  );
});

test('markup that is not taken for markup, told in its line', () =>
  refuses(
    [paragraph('First *emphasis*\nand **strong,\nthen 2*3\nand [a][b] -- so.')],
    [
      CHAPTER,
      'and **strong',
      '"**" was left standing in "and **strong,": Markdown did not take it for markup; write \\* if it is meant so',
    ],
    [CHAPTER, 'then 2*3', /^"\*" was left standing in "then 2\*3"/],
    [CHAPTER, 'and [a]', /^"\]\[" was left/],
    [CHAPTER, '-- so', /^"--" was left/],
  ));

test('comments, over empty lines and with marks in them, leave nothing', () => {
  assert.equal(
    woven('One <!-- two --> three.\n\n<!--\n\\figure{nowhere}\n\n\\endaside --> Four.'),
    '<p>One three.</p>\n<p>Four.</p>',
  );
});

test('a bare address is a link', () =>
  assert.equal(
    woven('See https://example.org/a_b, not example.org.'),
    '<p>See <a href="https://example.org/a_b">https://example.org/a_b</a>, not example.org.</p>',
  ));

test('a year at the start of a line starts no list', () => {
  assert.equal(woven('- Bari,\n  2008. Pleiades.'), '<ul>\n<li>Bari, 2008. Pleiades.</li>\n</ul>');
});

test('a character behind a backslash is meant', () => {
  assert.equal(
    woven('Meant: a \\* b, 2\\*3, \\*\\*, \\\\code, \\@ref, \\`, \\$5\\$, \\<T>, \\|, \\_x\\_.'),
    '<p>Meant: a * b, 2*3, **, \\code, @ref, `, $5$, &lt;T&gt;, |, _x_.</p>',
  );
});
