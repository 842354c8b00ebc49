// SPDX-License-Identifier: MIT-0
// Sources with what they include, to be pasted into a namespace.
import { existsSync, readFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';

export const INCLUDE = /^#include (?:<(.*)>|"(.*)")$/;

/** @param code  where headers are looked for that do not lie beside what includes them */
export function readSources(code) {
  const texts = new Map();

  function linesOf(file) {
    if (!texts.has(file)) texts.set(file, readFileSync(file, 'utf8').split('\n'));
    return texts.get(file);
  }

  function includesOf(file) {
    return linesOf(file).flatMap(line => {
      const own = INCLUDE.exec(line)?.[2];
      return own ? [[dirname(file), code].map(folder => resolve(folder, own)).find(existsSync)] : [];
    });
  }

  // All files that a source is made of, each behind what it includes.
  function filesOf(file, found = []) {
    for (const included of includesOf(file)) if (!found.includes(included)) filesOf(included, found);
    if (!found.includes(file)) found.push(file);
    return found;
  }

  // The text of a file without includes, under its own name and lines for what compilers and tests say.
  function pasted(file, lines = linesOf(file)) {
    const text = lines.map(line => (INCLUDE.test(line) || line === '#pragma once' ? '' : line));
    return `#line 1 ${JSON.stringify(file)}\n${text.join('\n')}`;
  }

  return { linesOf, filesOf, pasted };
}

/** The namespaces that some lines open at their left edge. */
export const namespacesOf = lines => new Set(lines.flatMap(line => /^namespace (\w+) \{/.exec(line)?.[1] ?? []));

/** Puts texts into a namespace in which `integrate::euler` is theirs; what they do not have, such as `integrate::rk4`, is everybody's. */
export const inNamespace = (name, namespaces, texts) =>
  [
    ...[...namespaces].map(one => `namespace ${one} {}`),
    `namespace ${name} {`,
    ...[...namespaces].map(one => `namespace ${one} { using namespace ::${one}; }`),
    ...texts,
    '}',
  ].join('\n');
