// The README's figure, which is committed, is the one that the build draws:
//   node readme-figure.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import * as cheerio from 'cheerio';

const [build, source] = process.argv.slice(2);
const committed = join(source, 'book/readme.svg');
const drawn = join(build, 'chapters/2-euler/figures/drone-spiral.svg');
const standalone = fileURLToPath(new URL('../../book/weave/standalone.mjs', import.meta.url));
const styleSheet = fileURLToPath(new URL('../../book/theme/book.css', import.meta.url));

test('the figure of the README is that of the build', () => {
  const old = readFileSync(committed, 'utf8');
  const title = old
    .match(/<title[^>]*>(.*?)<\/title>/)[1]
    .replace(/&apos;/g, "'")
    .replace(/&amp;/g, '&');
  const fresh = asStandalone(title);
  const [before, after] = [parts(old), parts(fresh)];
  const advice = `renew it: node ${standalone} ${drawn} ${styleSheet} "${title}" ${committed}`;
  const gone = before.filter(part => !after.includes(part));
  const added = after.filter(part => !before.includes(part));
  assert.ok(
    !gone.length && !added.length && before.length === after.length,
    `${gone.length} parts are gone, such as ${gone[0]}
${added.length} are new, such as ${added[0]}
${advice}`,
  );
});

function asStandalone(title) {
  const folder = mkdtempSync(join(tmpdir(), 'readme-figure-'));
  const out = join(folder, 'figure.svg');
  execFileSync(process.execPath, [standalone, drawn, styleSheet, title, out]);
  const svg = readFileSync(out, 'utf8');
  rmSync(folder, { recursive: true });
  return svg;
}

// gnuplot 5.4 and 6.0 draw the same parts, but not in the same order.
function parts(svg) {
  const $ = cheerio.load(svg, { xml: true });
  const leaves = $('*').filter((_, e) => !e.children.some(child => child.type === 'tag'));
  const chain = e =>
    $(e)
      .parents()
      .addBack()
      .map((_, part) => `${part.name} ${Object.values(part.attribs).join(' ')}`)
      .get()
      .join(' > ');
  return leaves
    .map((_, e) => `${chain(e)}: ${$(e).text()}`.replace(/\s+/g, ' '))
    .get()
    .sort();
}
