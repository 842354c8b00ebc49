// Compiles and runs the changed programs of a chapter:
//   node film-changes.mjs CHAPTER_FOLDER CHANGES FILMS OUT COMPILER FLAG...
//
// CHANGES is what write-changes.mjs wrote, and FILMS the folder of what the programs make as they are. OUT gets for each change
// NAME.txt, what it prints, and NAME.html, its film, in which the program's own film is a ghost; then films.json, that they are
// there, and films.json.d, what they were made of.
import { execFileSync } from 'node:child_process';
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { withGhost } from '../book/weave/film-ghost.mjs';

const [folder, list, films, out, compiler, ...flags] = process.argv.slice(2);
const changes = JSON.parse(readFileSync(list, 'utf8'));
mkdirSync(out, { recursive: true });
const scratch = mkdtempSync(join(tmpdir(), 'changes-'));
try {
  const used = changes.flatMap(change => make(change));
  const index = join(out, 'films.json');
  writeFileSync(`${index}.d`, `${index}: ${[...new Set(used)].join(' ')}\n`);
  writeFileSync(index, readFileSync(list));
} finally {
  rmSync(scratch, { recursive: true });
}

// Compiled as a file beside the program itself would be, so that what it includes is found. Returns the headers that it includes.
function make({ name, program, text }) {
  const [binary, headers] = [join(scratch, name), join(scratch, `${name}.d`)];
  const compile = ['-std=c++20', '-O1', '-MMD', '-MF', headers, ...flags, '-x', 'c++', '-', '-o', binary];
  execFileSync(compiler, compile, { cwd: folder, input: text, stdio: ['pipe', 'inherit', 'inherit'] });
  writeFileSync(join(out, `${name}.txt`), execFileSync(binary, { cwd: scratch }));
  const [changed, own] = [join(scratch, `${program}.html`), join(films, `${program}.html`)].map(file =>
    readFileSync(file, 'utf8'),
  );
  writeFileSync(join(out, `${name}.html`), withGhost(changed, own));
  const [, made] = readFileSync(headers, 'utf8').replace(/\\\n/g, ' ').split(/:\s/);
  return made
    .split(/\s+/)
    .filter(file => file && file !== '-')
    .map(file => resolve(folder, file));
}
