// The programs that make films: node play.test.mjs SOURCE BUILD COMPILER EIGEN CHAPTER [OTHER COMPILER]
//
// They are short and stand in their chapter; they print what the chapter quotes; and each "Change it" does what the chapter says,
// since the change is made, compiled and run.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const [source, build, compiler, eigen, chapter, other] = process.argv.slice(2);
const MOST_LINES = 60;
const folder = join(source, 'chapters', chapter);
const prose = readFileSync(join(folder, 'chapter.md'), 'utf8');
const names = readdirSync(folder)
  .filter(file => /^play\w*\.cpp$/.test(file))
  .map(file => file.slice(0, -4));
const read = name => readFileSync(join(folder, `${name}.cpp`), 'utf8');

const fences = (text, kind) =>
  [...text.matchAll(new RegExp(`^\`\`\`${kind}\\n([^]*?)^\`\`\``, 'gm'))].map(([, code]) => code);
const changes = [...prose.matchAll(/^\\change\{(.*)\}\n([^]*?)^\\endchange/gm)].map(([, title, text]) => ({
  title,
  text,
}));
const quoted = fences(prose.replace(/^\\change\{[^]*?^\\endchange/gm, ''), 'prints');

// What a program says, but for where its film is.
const said = output => output.replace(/^Open .*\n/m, '');

test('there is a program, and three things to change', () => {
  assert.ok(names.includes('play'), `${chapter} has no play.cpp`);
  assert.equal(changes.length, 3);
});

for (const name of names) {
  const lines = read(name)
    .split('\n')
    .filter(line => line.trim() && !/^\s*\/\/ (\[|SPDX|Chapter)/.test(line));
  test(`${name}.cpp has at most ${MOST_LINES} lines, and measures nothing`, () => {
    assert.ok(lines.length <= MOST_LINES, `${lines.length} lines`);
    assert.doesNotMatch(read(name), /measure/);
  });

  test(`the chapter quotes what ${name} prints`, () => {
    const printed = said(readFileSync(join(build, 'chapters', chapter, 'films', `${name}.txt`), 'utf8'));
    assert.ok(quoted.includes(printed), `it prints\n${printed}and the chapter quotes\n${quoted.join('or\n')}`);
  });

  test(`the film of ${name} needs nothing but itself`, () => {
    const page = readFileSync(join(build, 'chapters', chapter, 'films', `${name}.html`), 'utf8');
    assert.doesNotMatch(page, /https?:|src=|href=|@import|url\(/);
    assert.ok(page.length < 500_000, `${page.length} bytes`);
  });
}

const unindented = line => line.trim();

// The lines of `text`, with those that the change takes out, which stand there once, replaced by those that it puts in.
function changed(text, diff) {
  const rows = diff.trimEnd().split('\n');
  const out = rows.filter(row => !row.startsWith('+')).map(row => unindented(row.slice(1)));
  const put = rows.filter(row => !row.startsWith('-')).map(row => row.slice(1));
  const lines = text.split('\n');
  const at = lines.flatMap((_, i) => (out.every((line, k) => unindented(lines[i + k] ?? '') === line) ? [i] : []));
  return at.length === 1 ? [...lines.slice(0, at[0]), ...put, ...lines.slice(at[0] + out.length)].join('\n') : null;
}

// Compiles a program of the chapter, and runs it: what it says, and its film.
function run(code, by, name = 'play') {
  const scratch = mkdtempSync(join(tmpdir(), 'play-'));
  try {
    const [file, binary] = [join(scratch, 'play.cpp'), join(scratch, 'play')];
    writeFileSync(file, code.replace(/#include "\.\.\//g, `#include "${join(source, 'chapters')}/`));
    const flags = ['-std=c++20', '-O1', '-ffp-contract=off', '-DEIGEN_DONT_VECTORIZE', '-Wall', '-Wextra', '-Werror'];
    execFileSync(by, [...flags, `-I${join(source, 'code')}`, '-isystem', eigen, `-I${folder}`, file, '-o', binary]);
    const output = execFileSync(binary, { cwd: scratch, encoding: 'utf8' });
    return { said: said(output), film: readFileSync(join(scratch, `${name}.html`), 'utf8') };
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

for (const { title, text } of changes) {
  test(`change it: ${title}`, () => {
    const diffs = fences(text, 'diff'),
      expected = fences(text, 'prints');
    assert.ok(diffs.length > 0 && expected.length === 1, 'a change has lines to change, and what is printed then');
    const fits = names.filter(name => changed(read(name), diffs[0]) !== null);
    assert.equal(fits.length, 1, `its lines stand in ${fits.length} programs of ${chapter}, once: ${diffs[0]}`);
    const program = diffs.reduce((code, diff) => {
      const next = changed(code, diff);
      assert.ok(next, `the lines stand not once: ${diff}`);
      return next;
    }, read(fits[0]));
    assert.equal(run(program, compiler, fits[0]).said, expected[0]);
  });
}

for (const name of other ? names : []) {
  test(`${name} makes the same film by another compiler`, () => {
    const film = readFileSync(join(build, 'chapters', chapter, 'films', `${name}.html`), 'utf8');
    assert.ok(run(read(name), other, name).film === film, 'the films differ');
  });
}
