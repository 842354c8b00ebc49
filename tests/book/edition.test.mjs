// One version of the book, wherever it is named:  node edition.test.mjs BUILD SOURCE
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { pages, parse } from './book.mjs';

const read = file => readFileSync(join(process.argv[3], file), 'utf8');
const version = read('CMakeLists.txt').match(/^project\(\w+ VERSION (\S+) /m)?.[1];

test('the citation, the newest entry of the changelog and every page name the version of the build', () => {
  assert.match(version, /^\d+\.\d+\.\d+$/);
  assert.equal(read('CITATION.cff').match(/^version: (.*)$/m)?.[1], version);
  assert.equal(read('CHANGELOG.md').match(/^## (.*)$/m)?.[1], version);
  for (const page of pages) assert.ok(parse(page)('main > footer').text().includes(` ${version}. `), page);
});

test('the README stays short', () => {
  const words = read('README.md').split(/\s+/).filter(Boolean).length;
  assert.ok(words <= 700, `${words} words; what is for contributors stands in CONTRIBUTING.md`);
});

test('the grader, and so each report, names the version of the build', () => {
  const lines = execFileSync(join(process.argv[2], 'exercises/grade'), ['--version'], { encoding: 'utf8' })
    .trim()
    .split('\n');
  assert.ok(lines.length > 25, `only ${lines.length} exercises`);
  for (const line of lines) assert.match(line, new RegExp(` ${version.replaceAll('.', '\\.')}-[0-9a-f]{16}$`));
});
