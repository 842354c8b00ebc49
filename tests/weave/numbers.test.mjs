// How values are written: U+202F between groups and before units, U+2212 for minus, U+00A0 around the times sign.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import {
  numberFault,
  numberHtml,
  numberTex,
  numberText,
  quantityHtml,
  quantityTex,
  quantityText,
} from '../../book/weave/numbers.mjs';
import { cellHtml } from '../../book/weave/tables.mjs';

const each = (title, write, rows) =>
  test(title, () => {
    for (const [wanted, ...args] of rows) assert.equal(write(...args), wanted, `${JSON.stringify(args)}`);
  });

each('significant digits', numberText, [
  ['3.142', Math.PI, 4],
  ['1.500', 1.5, 4],
  ['0.010', 0.01, 2],
  ['7', 7.4, 1],
  ['1.0', 0.9999, 2],
  ['100', 99.96, 3],
  ['0', 0, 3],
  ['0', -0, 3],
]);

each('a cell of a column of numbers, which may hold words', field => cellHtml(field, { digits: '2' }, []), [
  ['0.33', '0.333'],
  ['∞', 'inf'],
  ['–', 'nan'],
  ['rounding', 'rounding'],
  ['information', 'information'],
]);

each('groups of three from five digits on', numberText, [
  ['1234', 1234, 4],
  ['12\u202f345', 12345, 5],
  ['123\u202f456', 123456.4, 6],
  ['0.1234', 0.12341, 4],
  ['0.123\u202f45', 0.12345, 5],
  ['12\u202f345.678\u202f90', 12345.6789, 10],
  ['1\u202f234\u202f567', 1234567, 0],
  ['1000', 1000, 0],
  ['4\u202f294\u202f967\u202f296', 2 ** 32, 0],
]);

each('powers of ten below 0.0001 and from a million on', numberText, [
  ['0.000\u202f10', 1e-4, 2],
  ['0.000\u202f10', 0.00009996, 2],
  ['9.99\u00a0×\u00a010⁻⁵', 0.0000999, 3],
  ['999\u202f999', 999999, 6],
  ['1.000\u202f00\u00a0×\u00a010⁶', 999999.7, 6],
  ['1.05\u00a0×\u00a010⁻⁷', 1.05e-7, 3],
  ['2\u00a0×\u00a010²³', 2e23, 1],
  ['1.00\u00a0×\u00a010⁻⁷', 1e-7, 3],
]);

each('minus and infinity', numberText, [
  ['\u22123.1', -3.14, 2],
  ['\u22121.05\u00a0×\u00a010⁻⁷', -1.05e-7, 3],
  ['\u221212', -12, 0],
  ['∞', Infinity, 3],
  ['\u2212∞', -Infinity, 0],
]);

each('in HTML', numberHtml, [
  ['\u22121.05\u00a0×\u00a010<sup>\u22127</sup>', -1.05e-7, 3],
  ['2\u00a0×\u00a010<sup>23</sup>', 2e23, 1],
  ['12\u202f345', 12345, 5],
]);

each('in TeX', numberTex, [
  ['-12\\,345', -12345, 5],
  ['1.05\\times 10^{-7}', 1.05e-7, 3],
  ['\\infty', Infinity, 2],
  ['-\\infty', -Infinity, 2],
  ['0.123\\,45', 0.12345, 5],
]);

const quantity = unit => ({ value: -0.5, digits: 2, unit });

each('units in a sentence', quantityText, [
  ['\u22120.50', quantity('')],
  ['\u22120.50\u202fm', quantity('m')],
  ['\u22120.50\u202fm/s²', quantity('m/s^2')],
  ['\u22120.50\u202fs⁻¹', quantity('s^-1')],
  ['\u22120.50\u202f%', quantity('%')],
]);
each('units in HTML', quantityHtml, [
  ['\u22120.50\u202fm/s<sup>2</sup>', quantity('m/s^2')],
  ['\u22120.50\u202fs<sup>\u22121</sup>', quantity('s^-1')],
]);
each('units in TeX', quantityTex, [
  ['{-0.50}', quantity('')],
  ['{-0.50\\,\\mathrm{m/s^{2}}}', quantity('m/s^2')],
  ['{-0.50\\,\\mathrm{s^{-1}}}', quantity('s^-1')],
  ['{-0.50\\,\\mathrm{\\%}}', quantity('%')],
  ['{-0.50\\,\\mathrm{steps\\ per\\ turn}}', quantity('steps per turn')],
]);

each('what no sentence can show', number => numberFault({ name: 'x', written: String(number.value), ...number }), [
  ['the number "x" is not a number: "NaN"', { value: NaN, digits: 3 }],
  ['the number "x" has no digits to show it with; give it 1 to 17, or 0 for an integer', { value: 1, digits: NaN }],
  ['the number "x" has no digits to show it with; give it 1 to 17, or 0 for an integer', { value: 1, digits: 18 }],
  ['the number "x" is shown as an integer and is 1.5; give it digits', { value: 1.5, digits: 0 }],
  [null, { value: Infinity, digits: 0 }],
  [null, { value: 3, digits: 0 }],
  [null, { value: 1.5, digits: 17 }],
]);
