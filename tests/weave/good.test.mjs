// The good sample: woven without a word of complaint, its numbers and formulas right.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { NUMBERS, sampleBook, weaves, woven } from './weaver.mjs';

const tex = html =>
  [...html.matchAll(/<annotation encoding="application\/x-tex">(.*?)<\/annotation>/g)].map(([, text]) => text);
const number = value => new RegExp(`<data class="number" value="[^"]*"[^>]*>${value}</data>`);

test('the good sample', () => {
  const book = sampleBook();
  const { status, stdout, stderr } = book.weave();
  assert.equal(stderr, '');
  assert.equal(status, 0);
  assert.match(stdout, /^2-euler +\d+ +1 +1 +1 of 2 +1 of 4 +2 +1$/m);
  const page = book.read('built/book/2-euler.html');
  assert.match(page, number('3\\.142\u202fm'));
  assert.match(page, /value="3\.1415926535897931"/);
  assert.match(book.read('built/book/index.html'), number('3\\.142\u202fm'));
  assert.deepEqual(tex(page).slice(0, 2), [
    'h = {0.10\\,\\mathrm{s}}',
    'E_{n+1} = \\bigl(1 + (h\\omega)^2\\bigr)\\, E_n , \\qquad h = {0.10\\,\\mathrm{s}} .',
  ]);
  assert.match(page, /<code>\\number\{radius\}<\/code>/);
  assert.match(
    page,
    /<tr><td>Euler<\/td><td class="right">1\.0\u00a0×\u00a010<sup>\u22127<\/sup><\/td><td class="right">∞<\/td><\/tr>/,
  );
  assert.ok(!/[\ue000-\uf8ff]/.test(page), 'a token was left standing');
});

test('numbers in sentences and formulas', () => {
  const html = woven(
    'A \\number{tiny}, \\number{steps}, \\number{2-euler/step}, \\f$ \\number{tiny} < \\number{steps} \\f$.',
  );
  assert.match(html, number('1\\.05\u00a0×\u00a010<sup>\u22127</sup>'));
  assert.match(html, number('123\u202f456'));
  assert.match(html, number('0\\.10\u202fs'));
  assert.deepEqual(tex(html), ['{1.05\\times 10^{-7}} &lt; {123\\,456}']);
});

test('infinity, and what is no number in a table', () => {
  const growth = 'built/2-euler/data/growth.csv';
  const page = weaves(
    [NUMBERS, '3.1415926535897931,m,4', '-inf,m,4'],
    [growth, '0.01,1.0001', 'nan,-inf'],
  )('2-euler.html');
  assert.match(page, number('\u2212∞\u202fm'));
  assert.match(page, /<tr><td>Euler<\/td><td class="right">–<\/td><td class="right">\u2212∞<\/td><\/tr>/);
});
