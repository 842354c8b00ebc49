// What refers to the code, and what Doxygen makes of its comments and complains of in them.
import assert from 'node:assert/strict';
import { chmodSync } from 'node:fs';
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses, sampleBook, weaves } from './weaver.mjs';

const nothing = name =>
  `a reference to nothing: \\ref ${name}; name something that is documented in code/, with its namespace.`;

test('references to nothing, all over a chapter', () =>
  refuses(
    [
      [CHAPTER, '- say how fast.', '- say \\ref in::goals.'],
      [CHAPTER, '. Marks in code', '. Behind a mark over two lines: \\ref behind::mark\nMarks in code'],
      [CHAPTER, 'Each dot is', '\\ref in::caption Each dot is'],
      [CHAPTER, '## Growth\n\nThe', '## Growth\n\n\\ref behind::heading The'],
      [CHAPTER, 'An aside with', 'An aside \\ref behind::formula'],
      [CHAPTER, '| Euler  | 1 | *none* |', '| Euler  | 1 | \\ref in::table |'],
      [CHAPTER, '2. Look.', '2. @ref in::answer, look.'],
      [
        CHAPTER,
        '\\endtakehome\n',
        '\\endtakehome\n\n<!-- a comment\nof two lines -->\n\n\\f[\na\n\\f]\n\nAt the \\ref at::end.\n',
      ],
    ],
    ...[
      'in::goals',
      'behind::mark',
      'in::caption',
      'behind::heading',
      'behind::formula',
      'in::table',
      'in::answer',
      'at::end',
    ].map(name => [CHAPTER, `ref ${name}`, nothing(name)]),
  ));

test('references to nothing on the other pages', () =>
  refuses(
    [
      ['chapters/front/chapter.md', 'The radius', 'The \\ref radius::nowhere'],
      ['book/references.md', '*Physical', '\\ref book::nowhere *Physical'],
    ],
    ['book/references.md', 'book::nowhere', nothing('book::nowhere')],
    ['chapters/front/chapter.md', 'radius::nowhere', nothing('radius::nowhere')],
  ));

test('a reference to what is nearly there, and one to no name', () => {
  refuses(
    [paragraph('See \\ref integrate::eulr.')],
    [CHAPTER, 'eulr', `${nothing('integrate::eulr')} Did you mean "integrate::euler" or "integrate"?`],
  );
  refuses(
    [paragraph('See \\ref.')],
    [CHAPTER, '\\ref.', '\\ref is incomplete; write \\ref name, of something in code/, with its namespace'],
  );
});

test('comments of the code', () => {
  const { status, stderr } = sampleBook(['code/integrate/euler.h', '@param h  step', '@param step  step']).weave();
  assert.equal(status, 1);
  assert.match(
    stderr,
    /^code\/integrate\/euler\.h:(1[3-9]|2\d): Doxygen: argument 'step' of command @param is not found/,
  );
  assert.match(
    sampleBook(['code/scenes/spring.h', 'A mass on', 'A <foo> on']).weave().stderr,
    /^code\/scenes\/spring\.h:\d+: Unsupported xml\/html tag <foo>: write < as \\<, or put code into backticks$/m,
  );
});

// Doxygen takes ' and '' within backticks for quotation marks, and lets the backticks stand.
test('primes and apostrophes in the comments of the code', () => {
  const read = weaves(
    [
      'code/scenes/spring.h',
      "/// A mass on a spring: x'' = -omega^2 x.",
      `/// A mass on a spring: \`x'' = -omega^2 x\`.
///
/// Its force isn't large: \`m x''\`, without a damper's \`c x'\`, which \`opens
/// x' here\` and isn't 'quoted'. Elsewhere x'' and x_i'' are bare.`,
    ],
    ['code/scenes/spring.h', '[rad/s]', "[rad/s], with \`x''\` and \`x'\`"],
  );
  const html = read('scenes-spring.html');
  for (const code of ["x'' = -omega^2 x", "m x''", "c x'", "opens x' here"])
    assert.ok(html.includes(`<code>${code}</code>`), `${code} in ${html}`);
  assert.ok(html.includes("with <code>x''</code> and <code>x'</code>"), html);
  assert.ok(
    html.includes('isn’t large') && html.includes('isn’t ‘quoted’') && html.includes('x″ and x_i″ are bare'),
    html,
  );
  assert.doesNotMatch(html.replace(/<script[\s\S]*?<\/script>/g, ''), /`|\ue000/);
});

test('a reference to something', () => {
  const html = weaves(paragraph('See \\ref integrate::euler, or \\ref scenes::Spring.'))('2-euler.html');
  assert.match(
    html,
    /<p>See <a href="integrate-euler\.html#euler"><code>integrate::euler<\/code><\/a>, or <a href="scenes-spring\.html"><code>scenes::Spring<\/code><\/a>\.<\/p>/,
  );
});

test('Doxygen runs where the code is another than before, and where it failed', () => {
  const book = sampleBook(['runs.txt', '']);
  const { DOXYGEN = 'doxygen' } = process.env;
  book.edit('doxygen.sh', `#!/bin/sh\n[ "$1" = --version ] || echo >>${book.path('runs.txt')}\nexec ${DOXYGEN} "$@"\n`);
  chmodSync(book.path('doxygen.sh'), 0o755);
  const weave = (...edit) => {
    if (edit.length) book.edit(...edit);
    const { status } = book.weave(book.path('doxygen.sh'));
    return [status, book.read('runs.txt').length];
  };
  const header = 'code/scenes/spring.h';
  assert.deepEqual(weave(), [0, 1]);
  assert.deepEqual(weave(CHAPTER, 'The energy grows', 'So the energy grows'), [0, 1]);
  assert.deepEqual(weave(header, 'A mass on a spring', 'A weight on a spring'), [0, 2]);
  assert.match(book.read('built/book/scenes-spring.html'), /A weight on a spring/);
  assert.deepEqual(weave(header, 'A weight on', '\\ref nothing::there A weight on'), [1, 3]);
  assert.deepEqual(weave(), [1, 4]);
  assert.deepEqual(weave(header, '\\ref nothing::there A weight on', 'A weight on'), [0, 5]);
});
