// The old book outlives a bad one, and nothing half-written is left behind.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readdirSync, readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { CHAPTER, sampleBook, WEAVER } from './weaver.mjs';

const contents = folder =>
  readdirSync(folder, { recursive: true })
    .sort()
    .map(name => join(folder, name))
    .filter(path => statSync(path).isFile())
    .map(path => [path, readFileSync(path, 'latin1')]);

test('a book that fails leaves the old one as it was', () => {
  const book = sampleBook();
  assert.equal(book.weave().status, 0);
  const before = contents(book.path('built/book'));
  assert.ok(before.length > 20);
  const early = 'Marks in code stay',
    late = 'Marks in code stay [here](nowhere.html)';
  for (const [from, to] of [
    [early, `\\number{x} ${early}`],
    [`\\number{x} ${early}`, `<foo> ${early}`],
    [`<foo> ${early}`, late],
  ]) {
    book.edit(CHAPTER, from, to);
    const { status, stderr } = book.weave();
    assert.equal(status, 1);
    assert.match(stderr, /The book of the last build stays as it was\.$/m);
    assert.deepEqual(contents(book.path('built/book')), before);
    assert.ok(!book.has('built/book.new') && !book.has('built/book.old'));
  }
});

test('a weaver that breaks off while it writes leaves nothing half-written', () => {
  const book = sampleBook(['built/2-euler/data/broken.csv/file', '']);
  assert.throws(() => book.weave(), /broken\.csv/);
  assert.ok(!book.has('built/book') && !book.has('built/book.new'));
});

test('what is left of the book before is gone', () => {
  const book = sampleBook(['built/book/old.html', 'old'], ['built/book.new/x', 'x'], ['built/book.old/x', 'x']);
  assert.equal(book.weave().status, 0);
  assert.ok(
    book.has('built/book/index.html') &&
      !book.has('built/book/old.html') &&
      !book.has('built/book/x') &&
      !book.has('built/book.new') &&
      !book.has('built/book.old'),
  );
});

test('by itself it says and does what it does within a test', () => {
  const timeless = ({ status, stdout, stderr }) => [status, stdout.replace(/\d+\.\d\d s/g, 'some s'), stderr];
  const book = sampleBook();
  assert.deepEqual(timeless(book.runWeaver()), timeless(book.weave()));
  assert.ok(book.has('built/book/index.html'));
  book.edit(CHAPTER, 'Marks in code stay', '\\number{x} Marks in code stay');
  assert.deepEqual(timeless(book.runWeaver()), timeless(book.weave()));
  const broken = sampleBook(['built/2-euler/data/broken.csv/file', '']);
  assert.notEqual(broken.runWeaver().status, 0);
  assert.ok(!broken.has('built/book') && !broken.has('built/book.new'));
});

test('bad use', () => {
  for (const args of [[], ['nowhere.json'], ['a', 'b']]) {
    const { status, stderr } = spawnSync(process.execPath, [WEAVER, ...args], { encoding: 'utf8' });
    assert.equal(status, 2);
    assert.match(stderr, /^usage: node weave\.mjs CONFIG\.json/);
  }
});

test('chapters without text, and Doxygen that is not there', () => {
  const half = sampleBook(['chapters/3-heun/notes.txt', '']).weave();
  assert.equal(half.status, 1);
  assert.match(
    half.stderr,
    /^chapters\/3-heun\/chapter\.md:1: there is no such file; each chapter has one, and each page around them$/m,
  );
  const book = sampleBook();
  assert.match(book.weave('/no/doxygen').stderr, /^book\/Doxyfile\.in: cannot run \/no\/doxygen: /);
  assert.match(book.weave('/bin/false').stderr, /^book\/Doxyfile\.in: Doxygen failed: /);
});
