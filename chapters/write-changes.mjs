// Writes the changed programs of a chapter:  node write-changes.mjs CHAPTER_FOLDER OUT
//
// OUT is left alone when the changes are as before, so that a sentence beside them compiles nothing.
import { existsSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { applyChange, readChanges } from '../book/weave/changes.mjs';

const [folder, out] = process.argv.slice(2);
const programs = Object.fromEntries(
  readdirSync(folder)
    .filter(file => /^play\w*\.cpp$/.test(file))
    .map(file => [file.slice(0, -4), readFileSync(join(folder, file), 'utf8')]),
);
const changes = readChanges(readFileSync(join(folder, 'chapter.md'), 'utf8')).map(change => ({
  name: change.name,
  title: change.title,
  ...applyChange(programs, change),
}));
for (const { title, fault } of changes.filter(({ fault }) => fault)) {
  console.error(`${join(folder, 'chapter.md')}: \\change{${title}}: ${fault}`);
  process.exitCode = 1;
}
const written = `${JSON.stringify(changes, null, 1)}\n`;
if (!process.exitCode && !(existsSync(out) && readFileSync(out, 'utf8') === written)) writeFileSync(out, written);
