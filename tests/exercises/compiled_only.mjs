// SPDX-License-Identifier: MIT-0
// node compiled_only.mjs FOLDER EXERCISES: no file in the folder, a program or any other, holds a line of a solution or of a
// mistake, or a path of the machine that built it. Prints each that one does; the exit code is 1 then.
import { readdirSync, readFileSync } from 'node:fs';
import { join, resolve } from 'node:path';

const filesIn = folder =>
  readdirSync(folder, { recursive: true, withFileTypes: true })
    .filter(entry => entry.isFile())
    .map(entry => join(entry.parentPath ?? entry.path, entry.name));

const [folder, exercises] = process.argv.slice(2);
const isAnswer = path => /\/(solution\.h|(right|wrong)\/[^/]+)$/.test(path);
// What students are given in the clear is no answer.
const isGiven = path => /\/(starter\.h|harness\/[^/]+\.h)$/.test(path);
const given = new Set(
  filesIn(exercises)
    .filter(isGiven)
    .flatMap(path =>
      readFileSync(path, 'utf8')
        .split('\n')
        .map(line => line.trim()),
    ),
);

// What is long enough to be an answer, and is code.
const lines = new Set(
  filesIn(exercises)
    .filter(isAnswer)
    .flatMap(path => readFileSync(path, 'utf8').split('\n'))
    .map(line => line.replace(/^[+-] /, '').trim())
    .filter(line => line.length >= 20 && /[;{]$/.test(line) && !/^(\/\/|#)/.test(line) && !given.has(line)),
);

let found = 0;
for (const path of filesIn(folder)) {
  const text = readFileSync(path, 'latin1');
  for (const line of [...lines, resolve(exercises)]) {
    if (!text.includes(line)) continue;
    console.error(`${path} holds "${line}"`);
    found = 1;
  }
}
if (lines.size < 500) {
  console.error(`only ${lines.size} lines of answers were found in ${exercises}`);
  found = 1;
}
process.exitCode = found;
