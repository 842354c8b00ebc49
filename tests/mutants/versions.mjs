// SPDX-License-Identifier: MIT-0
// The versions of headers that are tried: each edit's, and the header as it is by the same tests.
import { readFileSync } from 'node:fs';
import { basename, dirname } from 'node:path';

function versionOf(edit) {
  const head = readFileSync(edit, 'utf8').split('\n\n')[0];
  const header = basename(dirname(edit));
  return {
    edit,
    header,
    name: `${header}/${basename(edit, '.txt')}`,
    test: /^Fails: (.*)$/m.exec(head)[1],
    method: /^Method: (\w+)$/m.exec(head)?.[1],
  };
}

// A version as it is goes over a single method, too, where an edit does.
export function versionsOf(edits) {
  const wrong = edits.map(versionOf);
  const right = new Map();
  for (const { header, test, method } of wrong) {
    const name = `${header} as it is${method ? ` for ${method}` : ''}`;
    right.set(`${name}: ${test}`, { header, name, test, method });
  }
  return [...right.values(), ...wrong];
}
