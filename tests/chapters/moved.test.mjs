// What a chapter prints does not hang on a last bit: its program, begun one unit in the last place beside its starts, has the same
// printed numbers.  node moved.test.mjs PROGRAM CHAPTER DATA SCRATCH
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { before, test } from 'node:test';
import { readCsv } from '../../book/weave/csv.mjs';
import { quantityText, readNumbers } from '../../book/weave/numbers.mjs';
import { cellHtml, readTables } from '../../book/weave/tables.mjs';

const [program, chapter, data, scratch] = process.argv.slice(2);
const ways = { up: 1, down: -1 };

// What changes all the same, by chapter: nothing does. Whatever is named here has to change still.
const CHANGES = {};
// Programs in which not a bit changes: they count, or all begin at zero.
const STILL = ['engines', 'my-thing-does-this', 'pick-a-method'];
const known = CHANGES[basename(chapter)] ?? [];

const texts = readdirSync(chapter)
  .filter(file => /\.(md|gp)$/.test(file))
  .map(file => readFileSync(join(chapter, file), 'utf8'))
  .join('\n');
const quoted = new Set([...texts.matchAll(/\b(?:number|rows)(?:\{|\(")([\w-]+)/g)].map(([, name]) => name));

// { what: as the page prints it }, for each number and each cell of a table that the chapter quotes.
function printed(folder) {
  const found = {};
  for (const number of readNumbers(join(folder, 'numbers.csv')).values()) {
    if (quoted.has(number.name)) found[number.name] = quantityText(number);
  }
  for (const table of readTables(folder).values()) {
    if (!quoted.has(table.name)) continue;
    const [header, ...rows] = readCsv(table.path);
    const columns = header.map(name => table.columns.find(c => c.column === name));
    rows.forEach((row, i) =>
      row.forEach((field, j) => {
        found[`${table.name}, row ${i + 1}, ${header[j]}`] = cellHtml(field, columns[j], []);
      }),
    );
  }
  return found;
}

const page = printed(data);
const runs = {};

before(() => {
  for (const [way, MOVED] of Object.entries({ nowhere: 0, ...ways })) {
    const folder = join(scratch, way);
    mkdirSync(folder, { recursive: true });
    execFileSync(program, [folder], { env: { ...process.env, MOVED }, stdio: 'pipe' });
    runs[way] = folder;
  }
});

const changed = folder => {
  const found = printed(folder);
  assert.deepEqual(Object.keys(found), Object.keys(page));
  return Object.keys(page).filter(what => found[what] !== page[what]);
};

// Of the tables that the program writes; a chapter's folder may hold others, such as this machine's times.
const differing = folder =>
  readdirSync(folder)
    .filter(file => file.endsWith('.csv'))
    .filter(file => readFileSync(join(data, file), 'utf8') !== readFileSync(join(folder, file), 'utf8'));

test('begun where the chapter begins, it writes what the chapter has', () =>
  assert.deepEqual(differing(runs.nowhere), []));

test('begun a last place aside, it writes other bits', () =>
  assert.equal(differing(runs.up).length > 0, !STILL.includes(basename(chapter))));

for (const way of Object.keys(ways)) {
  test(`a last place ${way}, it prints the same`, () => {
    const found = printed(runs[way]);
    const lost = changed(runs[way]).filter(what => !known.includes(what));
    assert.deepEqual(
      lost.map(what => `${what}: ${found[what]} in place of ${page[what]}`),
      [],
      'print fewer digits, give a range, or say that it is luck',
    );
  });
}

test('what is known to change does', () => {
  const all = Object.keys(ways).flatMap(way => changed(runs[way]));
  assert.deepEqual(
    known.filter(what => !all.includes(what)),
    [],
  );
});
