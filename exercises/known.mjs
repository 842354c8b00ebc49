// SPDX-License-Identifier: MIT-0
// node known.mjs OUT EXERCISE HARNESS SOLUTION HEADER...: writes the source of the known wrong ways to do an exercise, for the
// grader to hold a student's answers beside: each with the exercise's harness in a namespace of its own, and what it says.
// A header with a line `// Known: no, WHY` is left out: one that would loop, crash or take long, or that remembers.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

// What a submission includes is included above: within a namespace it would be another library.
const bare = text => text.replace(/^#(pragma once|include .*)$/gm, '');
const included = text => text.match(/^#include <.*>$/gm) ?? [];
const read = path => readFileSync(path, 'utf8');

/** What a driver and the grader include above the namespaces. */
export const includedBy = (harness, headers) =>
  [...new Set(['#include "given.h"', ...[...headers, harness].map(read).flatMap(included)])].join('\n');

/** One submission and the harness, in a namespace. */
export const inNamespace = (name, header, harness) =>
  `namespace ${name} {\n#line 1 "${header}"\n${bare(read(header))}\n#line 1 "${harness}"\n${bare(read(harness))}\n}\n`;

const line = (header, name) => new RegExp(`^// ${name}: (.*)$`, 'm').exec(read(header))?.[1];

export function knownOf(exercise, harness, solution, headers) {
  const known = headers.filter(header => !line(header, 'Known') && line(header, 'Says'));
  const ways = [solution, ...known];
  const rows = known.map((header, i) => `        {${JSON.stringify(line(header, 'Says'))}, way_${i + 1}::answer},\n`);
  return `${includedBy(harness, ways)}
#include "judge/known.h"

namespace {

${ways.map((header, i) => inNamespace(`way_${i}`, header, harness)).join('\n')}
#line 1 "known.mjs"
const judge::Known known("${exercise}", way_0::answer, {
${rows.join('')}    });

}  // namespace
`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [out, exercise, harness, solution, ...headers] = process.argv.slice(2);
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, knownOf(exercise, harness, solution, headers));
}
