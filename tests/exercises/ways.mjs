// SPDX-License-Identifier: MIT-0
// node ways.mjs OUT HARNESS HEADER...: writes one source that holds all these submissions of an exercise, each with the
// exercise's harness in a namespace of its own, and finds them by their headers' paths. With driver.cpp it becomes a driver,
// and with library.cpp a library.
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname } from 'node:path';
import { fileURLToPath } from 'node:url';
import { includedBy, inNamespace } from '../../exercises/known.mjs';

export function driverOf(harness, headers) {
  const ways = headers.map((header, i) => inNamespace(`way_${i}`, header, harness));
  const table = headers.map((path, i) => `    {"${path}", way_${i}::answer},\n`);
  return `${includedBy(harness, headers)}
#include <string_view>
#include <utility>

${ways.join('\n')}
extern "C" void (*way_of(const char* header))(harness::Call&) {
  static constexpr std::pair<std::string_view, void (*)(harness::Call&)> ways[] = {
${table.join('')}  };
  for (const auto& [name, way] : ways)
    if (name == header) return way;
  return nullptr;
}
`;
}

if (process.argv[1] === fileURLToPath(import.meta.url)) {
  const [out, harness, ...headers] = process.argv.slice(2);
  mkdirSync(dirname(out), { recursive: true });
  writeFileSync(out, driverOf(harness, headers));
}
