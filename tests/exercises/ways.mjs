// SPDX-License-Identifier: MIT-0
// node ways.mjs OUT HARNESS HEADER...: writes the source of one driver that holds all these submissions of an exercise, each
// with the exercise's harness in a namespace of its own. The driver's argument says which of them it is: the header's path.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { includedBy, inNamespace } from '../../exercises/known.mjs';

export function driverOf(harness, headers) {
  const ways = headers.map((header, i) => inNamespace(`way_${i}`, header, harness));
  const table = headers.map((path, i) => `    {"${path}", way_${i}::answer},\n`);
  return `${includedBy(harness, headers)}
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
