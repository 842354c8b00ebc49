// SPDX-License-Identifier: MIT-0
// node ways.mjs OUT HARNESS HEADER...: writes the source of one driver that holds all these submissions of an exercise, each
// with the exercise's harness in a namespace of its own. The driver's argument says which of them it is: the header's path.
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';

// What a submission includes is included above: within a namespace it would be another library.
const bare = text => text.replace(/^#(pragma once|include .*)$/gm, '');
const included = text => text.match(/^#include <.*>$/gm) ?? [];

export function driverOf(harness, headers) {
  const read = path => readFileSync(path, 'utf8');
  const texts = headers.map(read);
  const glue = bare(read(harness));
  const above = [...new Set(['#include "given.h"', ...[...texts, read(harness)].flatMap(included)])];
  const ways = texts.map(
    (text, i) => `namespace way_${i} {\n#line 1 "${headers[i]}"\n${bare(text)}\n#line 1 "${harness}"\n${glue}\n}\n`,
  );
  const table = headers.map((path, i) => `    {"${path}", way_${i}::answer},\n`);
  return `${above.join('\n')}
#include <cstdlib>
#include <string_view>
#include <utility>

${ways.join('\n')}
static void (*chosen)(harness::Call&);

[[gnu::constructor]] static void choose(int count, char** arguments, char**) {
  static constexpr std::pair<std::string_view, void (*)(harness::Call&)> ways[] = {
${table.join('')}  };
  for (const auto& [name, way] : ways)
    if (count == 2 && name == arguments[1]) chosen = way;
  if (!chosen) std::abort();
}

void answer(harness::Call& call) {
  chosen(call);
}
`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [out, harness, ...headers] = process.argv.slice(2);
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, driverOf(harness, headers));
}
