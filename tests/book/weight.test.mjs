// What a page weighs: node weight.test.mjs BUILD. Times are no test's business; bytes are.
import assert from 'node:assert/strict';
import { statSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { chapters, folder, pages } from './book.mjs';
import { openTab, visit } from './browser.mjs';

const MB = 1e6;
const size = file => statSync(file).size;
const heaviest = [...chapters].sort((a, b) => size(join(folder, b)) - size(join(folder, a)))[0];

test('no page is over a megabyte', () => {
  assert.deepEqual(
    pages.filter(page => size(join(folder, page)) > MB),
    [],
  );
});

test('the heaviest chapter loads less than 1.9 MB, in two dozen files', async () => {
  const tab = await openTab();
  const files = new Set();
  tab.on('requestfinished', request => {
    if (request.url().startsWith('file:')) files.add(request.url().replace(/[#?].*/, ''));
  });
  await visit(tab, heaviest);
  const bytes = [...files].reduce((sum, url) => sum + size(fileURLToPath(url)), 0);
  assert.ok(files.size > 5 && files.size <= 24, `${files.size} files`);
  assert.ok(bytes < 1.9 * MB, `${heaviest}: ${bytes} bytes`);
});
