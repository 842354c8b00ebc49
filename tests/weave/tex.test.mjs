// Bad TeX, told at the line of the formula in which it stands.
import { test } from 'node:test';
import { CHAPTER, paragraph, refuses } from './weaver.mjs';

test('bad TeX in sentences and in displayed formulas', () =>
  refuses(
    [
      paragraph(
        [
          'Inline \\f$ a \\foo \\f$,',
          'over lines \\f$ a +',
          '\\bar{ \\f$, displayed',
          '\\f[',
          'c',
          '+ \\fooo',
          '\\f]',
          '\\f{align*}{ a &= b \\\\',
          ' c &= \\baz \\f}',
          '\\f{alin}{ a \\f}',
        ].join('\n'),
      ),
    ],
    [CHAPTER, '\\foo \\f$', 'bad TeX: Undefined control sequence: \\foo, in "a \\foo"'],
    [CHAPTER, '\\bar{', 'bad TeX: Unexpected end of input in a macro argument, expected \'}\', in "a + \\bar{"'],
    [CHAPTER, '\\fooo', 'bad TeX: Undefined control sequence: \\fooo, in "c + \\fooo"'],
    [CHAPTER, '\\baz', 'bad TeX: Undefined control sequence: \\baz, in "… &= b \\\\ c &= \\baz \\end{align*}"'],
    [CHAPTER, 'alin}', 'bad TeX: No such environment: alin, in "\\begin{alin} a \\end{alin}"'],
  ));

test('bad TeX that shows only with the numbers put in', () =>
  refuses(
    [paragraph('\\f$ a_\\number{tiny}_2 \\f$')],
    [CHAPTER, 'tiny', 'bad TeX: Double subscript, in "…\\times 10^{-7}}_2"'],
  ));

test('letters that TeX has no sign for', () =>
  refuses([paragraph('\\f$ größe \\f$')], [CHAPTER, 'größe', /^bad TeX: .*"ö" used in math mode, in "größe"$/]));

test('bad TeX in the comments of the code', () =>
  refuses(
    [['code/integrate/euler.h', '\\f$ h \\f$', '\\f$ \\foo \\f$']],
    [
      'code/integrate/euler.h',
      'constexpr void euler',
      'in the documentation here: bad TeX: Undefined control sequence: \\foo, in "\\foo"',
    ],
  ));

test('formulas that are not closed, or never opened', () =>
  refuses(
    [paragraph('One \\f$ a and\n\ntwo \\f] and\n\n\\f[ three \\f$ a \\f$\n\n\\f{align} a \\f}')],
    [CHAPTER, 'One', 'this formula is never closed; put \\f$ after it'],
    [CHAPTER, 'two', '\\f] closes a formula that was never opened'],
    [CHAPTER, '\\f[ three', 'this formula is never closed; put \\f] after it'],
    [CHAPTER, '{align}', 'this formula lacks its second brace; write \\f{align*}{ ... \\f}'],
  ));

test('formulas as other systems write them', () =>
  refuses(
    [paragraph('So $h$ is')],
    [CHAPTER, '$h$', '$ does not open a formula here; write \\f$ ... \\f$, or \\$ for the sign itself'],
  ));

test('numbered formulas: none, and two', () =>
  refuses(
    [paragraph('\\eq{none} \\f$ a \\f$ \\endeq\n\n\\eq{two} \\f[ a \\f] \\f[ b \\f] \\endeq')],
    [CHAPTER, '\\eq{none}', '\\eq{none} holds 0 displayed formulas; it numbers one: \\f[ ... \\f]'],
    [CHAPTER, '\\eq{two}', '\\eq{two} holds 2 displayed formulas; it numbers one: \\f[ ... \\f]'],
  ));
