// The README's figure, which is committed, is the one that the build draws:
//   node readme-figure.test.mjs BUILD COMMITTED.svg DRAWN.svg
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';

const [committed, drawn] = process.argv.slice(3);
const standalone = fileURLToPath(new URL('../../book/weave/standalone.mjs', import.meta.url));
const styleSheet = fileURLToPath(new URL('../../book/theme/book.css', import.meta.url));
const NUMBER = /-?\d+(?:\.\d+)?/g;

test('the figure of the README is that of the build', () => {
  const old = readFileSync(committed, 'utf8');
  const [, title] = old.match(/<title[^>]*>(.*?)<\/title>/);
  const fresh = asStandalone(title.replace(/&apos;/g, "'").replace(/&amp;/g, '&'));
  const advice = `; renew it: node ${standalone} ${drawn} ${styleSheet} "${title}" ${committed}`;
  assert.ok(shape(fresh) === shape(old), `other lines or words${advice}`);
  const before = numbers(old);
  const far = numbers(fresh).filter((n, i) => Math.abs(n - before[i]) > 0.11);
  assert.equal(far.length, 0, `${far.length} coordinates or colours are others${advice}`);
});

function asStandalone(title) {
  const folder = mkdtempSync(join(tmpdir(), 'readme-figure-'));
  const out = join(folder, 'figure.svg');
  execFileSync(process.execPath, [standalone, drawn, styleSheet, title, out]);
  const svg = readFileSync(out, 'utf8');
  rmSync(folder, { recursive: true });
  return svg;
}

// gnuplot 5.4 and 6.0 may differ in the last digit of a coordinate, and in nothing else.
const shape = svg => svg.replace(NUMBER, '#').replace(/\s+/g, ' ');
const numbers = svg => svg.match(NUMBER).map(Number);
