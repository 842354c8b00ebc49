// SPDX-License-Identifier: MIT-0
// node apply_edit.mjs FILE EDIT OUT [EDIT OUT]...: writes FILE with the mistake that EDIT describes.
//
// An edit gives lines to find in the file (each change exactly once) and lines to put in their place:
//   Fails: <name of the test that must see it>
//   Says: <words that must stand in what the test says>
//   Method: <type of code/measure/methods, if the test goes over a list: spares the others>
//   In: <function, class or table to look in, where the lines alone are not clear>
//   Why: <why it does what it does, for readers of a live figure that offers it>
//   <the mistake in words>
//   (empty line)
//   - <found>
//   + <put>
// All but the first line and the changes may be missing. The head becomes the first lines of what is
// written, as comments.
import { readFileSync, writeFileSync, mkdirSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

function lines(block, sign) {
  return block
    .split('\n')
    .filter(line => line.startsWith(sign))
    .map(line => line.slice(2))
    .join('\n');
}

// From the name where it is declared to the brace that ends it.
function span(file, text, name, fail) {
  const start = text.search(new RegExp(`(^class |^(?!//).*[ >])${name}\\b(?=[([]| *\\{)`, 'm'));
  const end = text.indexOf('\n}', start);
  if (start < 0 || end < 0) fail(`there is no ${name} in ${file}`);
  return [start, end];
}

// The text of FILE with the mistake.
export function edited(file, edit) {
  const text = readFileSync(file, 'utf8');
  const fail = message => {
    console.error(`${edit}: ${message}`);
    process.exit(1);
  };
  const [head, ...changes] = readFileSync(edit, 'utf8').trimEnd().split('\n\n');
  if (!/^Fails: ./.test(head) || changes.length === 0) {
    fail('needs "Fails: TEST" as its first line and at least one change');
  }
  const name = /^In: (\w+)$/m.exec(head)?.[1];
  const [start, end] = name ? span(file, text, name, fail) : [0, text.length];
  const original = text.slice(start, end);
  const found = changes
    .map(change => {
      const from = lines(change, '-');
      const at = original.indexOf(from);
      const said = `"${from.replace(/\s+/g, ' ')}"`;
      if (from === '' || at < 0) fail(`${name ?? file} does not hold ${said}`);
      if (original.indexOf(from, at + 1) >= 0) fail(`${name ?? file} holds ${said} more than once`);
      return { at, from, to: lines(change, '+') };
    })
    .sort((one, other) => other.at - one.at);
  let changed = original;
  for (const { at, from, to } of found) {
    changed = changed.slice(0, at) + to + changed.slice(at + from.length);
  }
  return head.replace(/^/gm, '// ') + '\n' + text.slice(0, start) + changed + text.slice(end);
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [file, ...edits] = process.argv.slice(2);
  for (let i = 0; i < edits.length; i += 2) {
    mkdirSync(dirname(edits[i + 1]), { recursive: true });
    writeFileSync(edits[i + 1], edited(file, edits[i]));
  }
}
