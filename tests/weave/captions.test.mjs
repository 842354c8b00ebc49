// Captions are bound to what was run, or say that they only tell where to look.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { CHAPTER, refuses, sampleBook } from './weaver.mjs';

const CAPTION = 'Each dot is one step, with \\f$ h = \\number{step} \\f$.';
const fault = '\\figure{spiral';
const bare = 'the caption of "spiral" has neither \\number nor \\claim nor \\look; 0 of the book may, and 1 do';

function weaves(...edits) {
  const { status, stdout, stderr } = sampleBook(...edits).weave();
  assert.equal(stderr, '');
  assert.equal(status, 0);
  return stdout;
}

test('a caption with none of the three is refused where none may be', () =>
  refuses([[CHAPTER, CAPTION, 'Each dot is one step.']], [CHAPTER, fault, bare]));

test('a number, within a formula or without, a claim and \\look are enough', () => {
  const captions = [
    CAPTION,
    'It is \\number{step} long.',
    'It gains \\claim{Euler gains energy on every step}.',
    'Each dot is one step. \\look',
  ];
  for (const caption of captions)
    assert.match(weaves([CHAPTER, CAPTION, caption]), /^0 of 1 captions have neither .* \(at most 0 may\)$/m);
});

test('\\look leaves nothing on the page, wherever it stands', () => {
  for (const caption of ['\\look Each dot is one step.', 'Each dot is one step. \\look']) {
    const book = sampleBook([CHAPTER, CAPTION, caption]);
    assert.equal(book.weave().stderr, '');
    assert.match(
      book.read('built/book/2-euler.html'),
      /<figcaption><p><b>Figure 2\.1[^<]*<\/b> +Each dot is one step\. *<\/p>/,
    );
  }
});

test('a mark outside of the caption does not count for it', () =>
  refuses(
    [[CHAPTER, `${CAPTION}\n\\endfigure`, 'Each dot is one step.\n\\endfigure\n\nIt is \\number{step} long.']],
    [CHAPTER, fault, bare],
  ));
