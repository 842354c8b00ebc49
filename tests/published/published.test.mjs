// What is published: its names, its checksums, and what its archives hold.
//   node published.test.mjs SOURCE BUILD VERSION COMPILER CMAKE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { cpSync, existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, utimesSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { filesOf, zip } from '../../book/publish/zip.mjs';

const [source, build, version, compiler, cmake] = process.argv.slice(2);
const published = join(build, 'published');
const name = `one-step-at-a-time-${version}`;
const work = mkdtempSync(join(tmpdir(), 'published-'));
after(() => rmSync(work, { recursive: true }));

function unpack(archive) {
  execFileSync(cmake, ['-E', 'tar', 'xf', join(published, archive)], { cwd: work });
  return join(work, archive.replace('.zip', ''));
}
const headersIn = folder => readdirSync(folder).filter(file => file.endsWith('.h'));

test('the version is in each name', () => {
  const archives = ['book.zip', 'handout.zip', 'headers.zip'].map(end => `${name}-${end}`);
  assert.deepEqual(readdirSync(published).sort(), ['SHA256SUMS', ...archives, `${name}.pdf`].sort());
});

test('the checksums hold', () => {
  const sums = readFileSync(join(published, 'SHA256SUMS'), 'utf8').trim().split('\n');
  assert.equal(sums.length, readdirSync(published).length - 1);
  for (const line of sums) {
    const [sum, file] = line.split('  ');
    assert.equal(
      createHash('sha256')
        .update(readFileSync(join(published, file)))
        .digest('hex'),
      sum,
      file,
    );
  }
});

test('the headers are all there, with their licence and without marks, and compile from where they are unpacked', () => {
  const folder = unpack(`${name}-headers.zip`);
  assert.ok(existsSync(join(folder, 'LICENSE')));
  for (const part of ['integrate', 'shelf']) {
    assert.deepEqual(headersIn(join(folder, part)), headersIn(join(source, 'code', part)));
    for (const header of headersIn(join(folder, part)))
      assert.doesNotMatch(readFileSync(join(folder, part, header), 'utf8'), /^\s*\/\/ \[\w+\]$/m, header);
  }
  const program = join(work, 'program.cpp');
  writeFileSync(
    program,
    '#include <integrate/euler.h>\n#include <shelf/fixed_step.h>\nint main() {\n' +
      '  double x = 0, v = 1;\n  integrate::euler(x, v, 0.0, 0.5, [](double, double, double) { return 0.0; });\n  return x != 0.5;\n}\n',
  );
  execFileSync(compiler, ['-std=c++17', '-Wall', '-Werror', '-I', folder, program, '-o', join(work, 'program')]);
  execFileSync(join(work, 'program'));
});

test('the book opens at its front page, which leads to the same PDF', () => {
  const folder = unpack(`${name}-book.zip`);
  const front = readFileSync(join(folder, 'index.html'), 'utf8');
  const [, pdf] = front.match(/<p class="pdf"><a href="([^"]*)"/);
  assert.deepEqual(readFileSync(join(folder, pdf)), readFileSync(join(published, `${name}.pdf`)));
  assert.ok(existsSync(join(folder, 'LICENSE')));
  assert.deepEqual(
    filesOf(folder, '').length,
    filesOf(join(build, 'book'), '').length + 1, // the licence
  );
});

test('the handout can be run, and its book leads to no PDF', () => {
  execFileSync(cmake, ['-E', 'tar', 'xf', join(published, `${name}-handout.zip`)], { cwd: work });
  const folder = join(work, 'one-step-at-a-time');
  execFileSync(join(folder, 'build/exercises/grade'), ['--help']);
  assert.doesNotMatch(readFileSync(join(folder, 'book/index.html'), 'utf8'), /\.pdf/);
  assert.deepEqual(
    filesOf(folder).filter(file => file.name.endsWith('.pdf')),
    [],
  );
});

test('a zip has the same bytes, whenever its files were written', () => {
  const copy = join(work, 'integrate');
  cpSync(join(source, 'code/integrate'), copy, { recursive: true });
  for (const header of headersIn(copy)) utimesSync(join(copy, header), 1e9, 1e9);
  assert.deepEqual(zip(filesOf(copy)), zip(filesOf(join(source, 'code/integrate')).reverse()));
});
