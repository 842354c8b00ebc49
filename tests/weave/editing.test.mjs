// What the editor of the page is given: a method's lines, with a mistake or to be written anew, and what the compiler says of them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { test } from 'node:test';
import { messagesOf } from '../../book/compiler/page/messages.js';
import { packed, unpacked } from '../../book/compiler/page/kept-code.js';
import { editableOf } from '../../book/weave/editable.mjs';
import { mergeLines } from '../../book/weave/merge-lines.mjs';

const header = name => readFileSync(new URL(`../../code/integrate/${name}.h`, import.meta.url), 'utf8');

test('what a step has besides its lines: names for parts of it, and what the method keeps', () => {
  assert.deepEqual(editableOf(header('euler')), { before: '' });
  assert.deepEqual(editableOf(header('midpoint')), { before: 'const Clock t_middle = Clock(t) + Clock(h / Real(2));' });
  assert.deepEqual(editableOf(header('velocity_verlet')), {
    before: 'const Clock t_end = Clock(t) + Clock(h);',
    keeps: 'a',
  });
});

test('a step that takes more than the page can give is not to be written anew', () => {
  for (const name of ['backward_euler', 'stormer_verlet', 'spring_exact'])
    assert.equal(editableOf(header(name)), null, name);
});

const merged = (before, after) =>
  mergeLines([...before], [...after])
    .map(({ text, sign }) => `${sign}${text}`)
    .join(' ');

test('two texts as one: what goes stands before what comes', () => {
  assert.equal(merged('abc', 'abc'), ' a  b  c');
  assert.equal(merged('abc', 'axc'), ' a -b +x  c');
  assert.equal(merged('ab', 'ba'), '-a  b +a');
  assert.equal(merged('', 'a'), '+a');
  assert.equal(merged('ab', ''), '-a -b');
});

test('the compiler’s messages of one file, without the names of its warnings', () => {
  const said =
    "lines:2:5: warning: unused 'x' [-Wunused]\n    2 | x;\n      | ^\nreader.h:1:1: error: no\nlines:3:1: fatal error: too many";
  assert.deepEqual(messagesOf(said, 'lines'), [
    { line: 2, column: 5, kind: 'warning', text: "unused 'x'" },
    { line: 3, column: 1, kind: 'error', text: 'too many' },
  ]);
  assert.deepEqual(messagesOf('wasm-ld: error: out of room', 'lines'), []);
});

test('a text in a link comes back as it was; what is no text comes as none', async () => {
  const text = 'x = x + h * v;  // \u00e9 \u{1F680}\n'.repeat(40);
  const letters = await packed(text);
  assert.match(letters, /^[\w-]+$/);
  assert.ok(letters.length < text.length / 5);
  assert.equal(await unpacked(letters), text);
  for (const wrong of ['', '***', 'AAAA', letters.slice(0, -9)])
    assert.equal((await unpacked(wrong)) || null, null, wrong);
});
