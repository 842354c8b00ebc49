// How a measured value is written, in prose and in TeX.
import { existsSync } from 'node:fs';
import { readRecords } from './csv.mjs';
import { escapeHtml } from './text.mjs';

const NARROW = '\u202f';
const MINUS = '\u2212';

// "NAME,value,unit,digits" -> Map of name to { name, value, written, unit, digits }.
export function readNumbers(path) {
  if (!existsSync(path)) return new Map();
  return new Map(
    readRecords(path).map(row => [
      row.name,
      {
        name: row.name,
        written: row.value,
        value: Number(row.value.replace(/^([-+]?)inf(inity)?$/i, '$1Infinity')),
        unit: row.unit,
        digits: row.digits === '' ? NaN : Number(row.digits),
      },
    ]),
  );
}

// What is wrong with a number that a sentence or a formula shows, or nothing.
export function numberFault({ name, value, written, digits }) {
  if (Number.isNaN(value)) return `the number "${name}" is not a number: "${written}"`;
  if (!Number.isInteger(digits) || digits < 0 || digits > 17)
    return `the number "${name}" has no digits to show it with; give it 1 to 17, or 0 for an integer`;
  if (digits === 0 && Number.isFinite(value) && !Number.isInteger(value))
    return `the number "${name}" is shown as an integer and is ${written}; give it digits`;
  return null;
}

// Sign, digits and power of ten of a value rounded to `digits` significant digits (0: an integer with all of them).
export function roundValue(value, digits) {
  const negative = value < 0;
  const size = Math.abs(value);
  if (!Number.isFinite(size)) return { negative, infinite: true };
  if (size === 0) return { negative: false, mantissa: '0', exponent: null };
  if (digits === 0)
    return {
      negative: negative && Math.round(size) > 0,
      mantissa: BigInt(Math.round(size)).toString(),
      exponent: null,
    };
  const rounded = Number(size.toPrecision(digits));
  if (rounded >= 1e-4 && rounded < 1e6) return { negative, mantissa: plain(rounded, digits), exponent: null };
  const [mantissa, exponent] = size.toExponential(digits - 1).split('e');
  return { negative, mantissa, exponent: Number(exponent) };
}

function plain(rounded, digits) {
  const magnitude = Math.floor(Math.log10(rounded) + 1e-12);
  return rounded.toFixed(Math.min(100, Math.max(0, digits - 1 - magnitude)));
}

// Groups of three from five digits on, on both sides of the point.
function group(digits, separator) {
  const [whole, fraction] = digits.split('.');
  const left = whole.length < 5 ? whole : whole.replace(/\B(?=(\d{3})+$)/g, separator);
  if (fraction === undefined) return left;
  return `${left}.${fraction.length < 5 ? fraction : fraction.replace(/(\d{3})(?=\d)/g, `$1${separator}`)}`;
}

// A power of ten whose mantissa is 1 to the last digit shown keeps its mantissa: 1.00 × 10⁻⁷ says how well it is known.
function write(value, digits, { separator, minus, infinity, power }) {
  const { negative, infinite, mantissa, exponent } = roundValue(value, digits);
  const sign = negative ? minus : '';
  if (infinite) return sign + infinity;
  const written = group(mantissa, separator);
  return sign + (exponent === null ? written : power(written, exponent));
}

const signed = (exponent, minus) => (exponent < 0 ? minus : '') + Math.abs(exponent);
const SUPERSCRIPT = {
  '-': '⁻',
  '0': '⁰',
  '1': '¹',
  '2': '²',
  '3': '³',
  '4': '⁴',
  '5': '⁵',
  '6': '⁶',
  '7': '⁷',
  '8': '⁸',
  '9': '⁹',
};
const raise = digits => [...digits].map(c => SUPERSCRIPT[c]).join('');

export function numberText(value, digits) {
  return write(value, digits, {
    separator: NARROW,
    minus: MINUS,
    infinity: '∞',
    power: (m, e) => `${m}\u00a0×\u00a010${raise(signed(e, '-'))}`,
  });
}

export function numberHtml(value, digits) {
  return write(value, digits, {
    separator: NARROW,
    minus: MINUS,
    infinity: '∞',
    power: (m, e) => `${m}\u00a0×\u00a010<sup>${signed(e, MINUS)}</sup>`,
  });
}

export function numberTex(value, digits) {
  return write(value, digits, {
    separator: '\\,',
    minus: '-',
    infinity: '\\infty',
    power: (m, e) => `${m}\\times 10^{${e}}`,
  });
}

// All the digits that the program wrote, grouped like any other number.
export function fullText({ written, value, unit }) {
  const [, sign, mantissa, exponent] = written.match(/^([-+]?)([\d.]+)(?:e([-+]?\d+))?$/i) ?? [];
  const digits = mantissa ? (sign === '-' ? MINUS : '') + group(mantissa, NARROW) : numberText(value, 1);
  return (
    digits + (exponent ? `\u00a0×\u00a010${raise(String(Number(exponent)))}` : '') + (unit && NARROW + unitText(unit))
  );
}

export const unitText = unit => unit.replace(/\^(-?\d+)/g, (_, power) => raise(power));
export const unitHtml = unit =>
  escapeHtml(unit).replace(/\^(-?\d+)/g, (_, power) => `<sup>${power.replace('-', MINUS)}</sup>`);

export function unitTex(unit) {
  const tex = unit
    .replace(/%/g, '\\%')
    .replace(/[·*]/g, '\\cdot ')
    .replace(/°/g, '^\\circ ')
    .replace(/[µμ]/g, '\\mu ')
    .replace(/\^(-?\d+)/g, '^{$1}')
    .replace(/ /g, '\\ ');
  return `\\mathrm{${tex}}`;
}

export const quantityText = n => numberText(n.value, n.digits) + (n.unit && NARROW + unitText(n.unit));
export const quantityHtml = n => numberHtml(n.value, n.digits) + (n.unit && NARROW + unitHtml(n.unit));
export const quantityTex = n => `{${numberTex(n.value, n.digits)}${n.unit && `\\,${unitTex(n.unit)}`}}`;
