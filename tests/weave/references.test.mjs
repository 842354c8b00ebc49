// References to nothing, and names that stand for two things.
import { test } from 'node:test';
import { CHAPTER, CLAIMS, paragraph, refuses, REPORT } from './weaver.mjs';

const INDEX = 'chapters/front/chapter.md';
const BIB = 'book/references.md';

test('references to nothing, all told at once', () =>
  refuses(
    [
      paragraph(
        [
          '\\figref{spirl}',
          '\\eqref{grow}',
          '\\tabref{zzzzzzzz}',
          '\\exerciseref{bck}',
          '\\lstref{code/integrate/euler.h, stp}',
          '\\citep{verlet1967, verlet1976}',
          '\\chapterref{2-eulr}',
          '\\sectionref{2-euler, growht}',
          '\\sectionref{3-heun, growth}',
        ].join('\n'),
      ),
    ],
    [CHAPTER, '\\figref{spirl}', 'there is no \\figure{spirl}. Did you mean "spiral"?'],
    [CHAPTER, '\\eqref{grow}', 'there is no \\eq{grow}. Did you mean "growth"?'],
    [CHAPTER, '\\tabref{zzzzzzzz}', 'there is no \\table{zzzzzzzz}. There is "growth", "methods".'],
    [CHAPTER, '\\exerciseref{bck}', 'there is no \\exercise{bck}. Did you mean "back"?'],
    [
      CHAPTER,
      ', stp}',
      'no \\listing{code/integrate/euler.h, stp} stands in the book. Did you mean "code/integrate/euler.h, step"?',
    ],
    [CHAPTER, 'verlet1976', 'there is no reference "verlet1976" in book/references.md. Did you mean "verlet1967"?'],
    [CHAPTER, '2-eulr', 'there is no chapter "2-eulr". Did you mean "2-euler"?'],
    [CHAPTER, 'growht', '2-euler has no section "growht". Did you mean "growth"?'],
    [CHAPTER, '3-heun', 'there is no chapter "3-heun". There is "2-euler".'],
  ));

test('links to nothing', () =>
  refuses(
    [paragraph('[one](nowhere.html),\n[two](#nowhere),\n[three](index.html#nowhere)')],
    [CHAPTER, '[one]', 'a link to nothing: nowhere.html'],
    [CHAPTER, '[two]', 'a link to nothing: 2-euler.html has no "#nowhere"'],
    [CHAPTER, '[three]', 'a link to nothing: index.html has no "#nowhere"'],
  ));

test('names that two things bear', () =>
  refuses(
    [
      paragraph(
        [
          '## Growth',
          '\\figure{spiral, Again}\nOnce more. \\look\n\\endfigure',
          '\\eq{growth} \\f[ a \\f] \\endeq',
          '\\table{methods}\nAgain.\n\\rows{growth}\n\\endtable',
          '\\exercise{back, Again}\nOnce more. \\look\n\\endexercise',
        ].join('\n\n'),
      ),
      [BIB, '- \\bibitem{hairer', '- \\bibitem{verlet1967, Another}\n- \\bibitem{hairer'],
    ],
    [BIB, 'Another', 'the reference "verlet1967" is taken by book/references.md:3; give this one another key'],
    [
      CHAPTER,
      '## Growth\n\n\\figure',
      'this section has the same name as the one in line 25; links could not tell them apart',
    ],
    [
      CHAPTER,
      '\\figure{spiral, Again',
      'the figure name "spiral" is taken by chapters/2-euler/chapter.md:16; names are unique in the book',
    ],
    [
      CHAPTER,
      '\\eq{growth} \\f[ a',
      'the equation name "growth" is taken by chapters/2-euler/chapter.md:29; names are unique in the book',
    ],
    [
      CHAPTER,
      '\\table{methods}\nAgain',
      'the table name "methods" is taken by chapters/2-euler/chapter.md:44; names are unique in the book',
    ],
    [
      CHAPTER,
      '\\exercise{back, Again',
      'the exercise name "back" is taken by chapters/2-euler/chapter.md:53; names are unique in the book',
    ],
  ));

test('two tests that bear one claim', () =>
  refuses(
    [[REPORT, 'name="Nobody cites this claim"', 'name="Euler gains: energy on every step"']],
    [
      CLAIMS,
      'TEST_CASE("Nobody',
      'the test name "Euler gains: energy on every step" is taken by chapters/2-euler/claims.cpp:4; names are unique in the book, by their letters and digits',
    ],
  ));

test('a section named like a figure', () =>
  refuses(
    [paragraph('## Figure spiral')],
    [CHAPTER, '## Figure spiral', 'the id "figure-spiral" stands twice in 2-euler.html; rename the section or box'],
  ));

test('a mistake in another page than a chapter', () =>
  refuses(
    [
      [INDEX, '\\chapterref{2-euler}', '\\chapterref{1-euler}'],
      [BIB, '*Physical', '\\citep{nobody} *Physical'],
    ],
    [BIB, 'nobody', 'there is no reference "nobody" in book/references.md. There is "verlet1967", "hairer2006".'],
    [INDEX, '1-euler', 'there is no chapter "1-euler". Did you mean "2-euler"?'],
  ));
