// A lecturer's pages: what a chapter teaches, and its figures one to a sheet.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { weaves } from './weaver.mjs';

test('the figures of a chapter are slides, and its goals stand before them', () => {
  const read = weaves();
  const slides = read('slides-2.html');
  const chapter = read('2-euler.html');
  const titles = [...chapter.matchAll(/<figure class="plot" id="(figure-[^"]*)">/g)].map(([, id]) => id);
  assert.ok(titles.length > 0);
  assert.deepEqual(
    [...slides.matchAll(/<section class="slide">[^]*?<svg[^]*?<a href="2-euler\.html#([^"]*)">/g)].map(([, id]) => id),
    titles,
  );
  assert.match(slides, /size: A4 landscape/);
  assert.match(read('slides.html'), new RegExp(`<a href="slides-2\\.html">${titles.length} slide`));
});
