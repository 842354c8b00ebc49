// The sample, a book in miniature, in a folder of its own: edited, woven and judged. It is woven within the test's own process, by
// what weave.mjs calls: to start the weaver costs more than to weave so small a book.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  readdirSync,
  realpathSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { Faults, weave } from '../../book/weave/weaving.mjs';

export const WEAVER = fileURLToPath(new URL('../../book/weave/weave.mjs', import.meta.url));
const SAMPLE = fileURLToPath(new URL('sample', import.meta.url));

export const CHAPTER = 'chapters/2-euler/chapter.md';
export const CLAIMS = 'chapters/2-euler/claims.cpp';
export const REPORT = 'built/2-euler/claims.xml';
export const CARDS = 'code/measure/every_card.cpp';
export const METHODS = 'code/measure/methods/euler.h';
export const MODULE = 'built/live.wasm';
export const NUMBERS = 'built/2-euler/data/numbers.csv';

// A paragraph of its own in the chapter, outside of every box.
export const paragraph = text => [CHAPTER, '\\remark\nA remark.\n', `${text}\n\n\\remark\nA remark.\n`];

export const line = (source, needle) => source.slice(0, source.indexOf(needle)).split('\n').length;

const folders = [];
process.on('exit', () => {
  for (const folder of folders) rmSync(folder, { recursive: true, force: true });
});

// Each edit is [file, what stands there once, what shall stand there]; [file, text] writes a file, [file] removes it.
export function sampleBook(...edits) {
  const folder = realpathSync(mkdtempSync(join(tmpdir(), 'weave-')));
  folders.push(folder);
  cpSync(SAMPLE, folder, { recursive: true });
  const book = {
    folder,
    path: name => join(folder, name),
    has: name => existsSync(join(folder, name)),
    read: name => readFileSync(join(folder, name), 'utf8'),
    edit: (name, ...change) => edit(book, name, change),
    weave: doxygen => woveBy(configOf(folder, doxygen)),
    // As CMake does it, in a process of its own.
    runWeaver: () => {
      writeFileSync(join(folder, 'weave.json'), JSON.stringify(configOf(folder)));
      return spawnSync(process.execPath, [WEAVER, join(folder, 'weave.json')], { encoding: 'utf8' });
    },
  };
  for (const change of edits) book.edit(...change);
  return book;
}

function edit(book, name, change) {
  const path = book.path(name);
  if (!change.length) {
    rmSync(path, { recursive: true });
    return;
  }
  mkdirSync(dirname(path), { recursive: true });
  if (change.length === 1) {
    writeFileSync(path, change[0]);
    return;
  }
  const parts = book.read(name).split(change[0]);
  assert.equal(parts.length, 2, `${name} has ${parts.length - 1} times: ${change[0]}`);
  writeFileSync(path, parts.join(change[1]));
}

function configOf(folder, doxygen = process.env.DOXYGEN || 'doxygen') {
  const names = readdirSync(join(folder, 'chapters'));
  const chapters = names.filter(name => name !== 'front' || existsSync(join(folder, 'built/front')));
  const timed = ['recorded', 'here'].some(name => existsSync(join(folder, `built/${name}.csv`)));
  return {
    version: '1.2.3',
    source: folder,
    output: join(folder, 'built/book'),
    work: join(folder, 'work'),
    live: existsSync(join(folder, MODULE)) ? join(folder, MODULE) : '',
    cards: join(folder, 'built/cards'),
    methods: join(folder, 'built/register'),
    shelf: existsSync(join(folder, 'code/shelf')) ? join(folder, 'built/shelf') : '',
    doxygen,
    times: timed ? [{ recorded: join(folder, 'built/recorded.csv'), here: join(folder, 'built/here.csv') }] : [],
    chapters: chapters.map(name => ({ name, folder: `chapters/${name}`, build: join(folder, 'built', name) })),
  };
}

// What weave.mjs would say of it, and end with.
function woveBy(config) {
  try {
    return { status: 0, stdout: `${weave(config)}\n`, stderr: '' };
  } catch (fault) {
    if (!(fault instanceof Faults)) throw fault;
    return { status: 1, stdout: '', stderr: `${fault.message}\n` };
  }
}

// The weaver stops with these faults and no others, each [file, what stands in its line, message].
export function refuses(edits, ...faults) {
  const book = sampleBook(...edits);
  const { status, stdout, stderr } = book.weave();
  const told = stderr.split(/\n(?! )/).filter(Boolean);
  assert.match(told.pop() ?? '', new RegExp(`^The book is not woven: ${faults.length} mistakes? to mend\\. $`), stderr);
  faults.forEach(([file, needle, message], i) => {
    const place = `${file}:${line(book.read(file), needle)}: `;
    if (message instanceof RegExp) {
      assert.ok(told[i].startsWith(place), `${place} expected: ${told[i]}`);
      assert.match(told[i].slice(place.length), message);
    } else assert.equal(told[i], place + message);
  });
  assert.equal(told.length, faults.length, stderr);
  assert.equal(stdout, '');
  assert.equal(status, 1);
  assert.ok(!book.has('built/book') && !book.has('built/book.new'), 'something was written');
}

// The pages of a woven book with these edits.
export function weaves(...edits) {
  const book = sampleBook(...edits);
  const { status, stdout, stderr } = book.weave();
  assert.equal(stderr, '');
  assert.equal(status, 0, stdout);
  return name => book.read(join('built/book', name));
}

// What becomes of a piece of Markdown, in HTML.
export function woven(text) {
  const page = weaves(paragraph(`From here.\n\n${text}\n\nTo here.`))('2-euler.html');
  return page.match(/<p>From here\.<\/p>\s*([\s\S]*?)\s*<p>To here\.<\/p>/)[1];
}
