// The programs that make films: node play.test.mjs SOURCE BUILD COMPILER EIGEN CHAPTER [OTHER COMPILER]
//
// They are short and stand in their chapter; they print what the chapter quotes; and each "Change it" did, where the build made the
// change, what the chapter says; another compiler makes the same of it.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { applyChange, readChanges, readQuoted } from '../../book/weave/changes.mjs';
import { withGhost } from '../../book/weave/film-ghost.mjs';

const [source, build, compiler, eigen, chapter, other] = process.argv.slice(2);
const MOST_LINES = 60;
const folder = join(source, 'chapters', chapter);
const prose = readFileSync(join(folder, 'chapter.md'), 'utf8');
const names = readdirSync(folder)
  .filter(file => /^play\w*\.cpp$/.test(file))
  .map(file => file.slice(0, -4));
const read = name => readFileSync(join(folder, `${name}.cpp`), 'utf8');

const changes = readChanges(prose);
const quoted = readQuoted(prose);

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

const programs = Object.fromEntries(names.map(name => [name, read(name)]));
for (const change of changes) {
  test(`change it: ${change.title}`, () => {
    assert.ok(
      change.diffs.length > 0 && change.prints.length === 1,
      'it has lines to change, and what is printed then',
    );
    const { fault, program, text } = applyChange(programs, change);
    assert.ok(!fault, fault);
    const made = kind => readFileSync(join(build, 'chapters', chapter, 'changes', `${change.name}.${kind}`), 'utf8');
    assert.equal(said(made('txt')), change.prints[0]);
    const own = readFileSync(join(build, 'chapters', chapter, 'films', `${program}.html`), 'utf8');
    assert.ok(
      made('html').includes('const ghost = {') && !own.includes('const ghost = {'),
      'it has the old film as its ghost',
    );
    if (!other) return;
    const again = run(text, other, program);
    assert.equal(again.said, change.prints[0]);
    assert.ok(made('html') === withGhost(again.film, own), 'its films by two compilers differ');
  });
}

for (const name of other ? names : []) {
  test(`${name} makes the same film by another compiler`, () => {
    const film = readFileSync(join(build, 'chapters', chapter, 'films', `${name}.html`), 'utf8');
    assert.ok(run(read(name), other, name).film === film, 'the films differ');
  });
}
