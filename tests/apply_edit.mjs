// SPDX-License-Identifier: MIT-0
// node mutate.mjs HEADER MUTANT OUT: writes HEADER with the changes that MUTANT describes.
//
// A mutant names the function that it spoils and gives lines to find there (each exactly once) and
// lines to put in their place:
//   Killed by: <name of the test that must fail>
//   Method: <type of tests/methods/list.h, if the test goes over a list: spares the others>
//   In: <function, class or table>
//   (empty line)
//   - <found>
//   + <put>
import {readFileSync, writeFileSync, mkdirSync} from 'node:fs';
import {dirname} from 'node:path';

const [headerFile, mutantFile, outFile] = process.argv.slice(2);

function fail(message) {
  console.error(`${mutantFile}: ${message}`);
  process.exit(1);
}

function lines(block, sign) {
  return block.split('\n').filter((line) => line.startsWith(sign))
      .map((line) => line.slice(2)).join('\n');
}

// From the name where it is declared to the brace that ends it.
function span(text, name) {
  const start = text.search(new RegExp(`(^class |^(?!//).*[ >])${name}\\b(?=[([]| *\\{)`, 'm'));
  const end = text.indexOf('\n}', start);
  if (start < 0 || end < 0) fail(`there is no ${name} in ${headerFile}`);
  return [start, end];
}

const [head, ...changes] = readFileSync(mutantFile, 'utf8').trimEnd().split('\n\n');
const name = /^In: (\w+)$/m.exec(head)?.[1];
if (!name || changes.length === 0) fail('needs a line "In: function" and at least one change');
const text = readFileSync(headerFile, 'utf8');
const [start, end] = span(text, name);
const original = text.slice(start, end);
const found = changes.map((change) => {
  const from = lines(change, '-');
  const at = original.indexOf(from);
  if (from === '' || at < 0) fail(`${name} does not hold "${from}"`);
  if (original.indexOf(from, at + 1) >= 0) fail(`${name} holds "${from}" more than once`);
  return {at, from, to: lines(change, '+')};
}).sort((one, other) => other.at - one.at);
let mutated = original;
for (const {at, from, to} of found) {
  mutated = mutated.slice(0, at) + to + mutated.slice(at + from.length);
}
mkdirSync(dirname(outFile), {recursive: true});
writeFileSync(outFile, text.slice(0, start) + mutated + text.slice(end));
