// Writes the methods with the mistakes that live figures let their readers make:  node write-mistakes.mjs CODE OUT
//
// Each mistake is an edit of tests/mutants. The edited header stands in a namespace of its own, with those headers of
// code/measure/methods that call it. OUT.d says what OUT was made of, for Ninja.
import { readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { edited } from '../../exercises/apply_edit.mjs';
import { inNamespace, namespacesOf, readSources } from '../../tests/mutants/sources.mjs';
import { readDescriptions, readMistake } from './descriptions.mjs';

const [code, out] = process.argv.slice(2);
const { linesOf, filesOf, pasted } = readSources(code);
const figures = readDescriptions(new URL('../../chapters/', import.meta.url));
const names = figures.flatMap(({ controls }) =>
  Object.keys(controls.find(({ name }) => name === 'own')?.choices ?? {}),
);
const mistakes = [...new Set(names)]
  .filter(name => name !== 'none')
  .sort()
  .map(readMistake);

const methods = readdirSync(join(code, 'measure/methods'))
  .filter(file => file.endsWith('.h') && file !== 'implicit.h')
  .map(file => join(code, 'measure/methods', file));
const used = new Set();
const included = new Set();

function source({ header, file, words }, index) {
  const own = join(code, 'integrate', `${header}.h`);
  const inside = [...new Set(methods.filter(of => filesOf(of).includes(own)).flatMap(of => filesOf(of)))].filter(of =>
    filesOf(of).includes(own),
  );
  for (const of of inside) for (const needed of filesOf(of)) (inside.includes(needed) ? used : included).add(needed);
  const text = inside.map(of => (of === own ? pasted(file, edited(own, file).split('\n')) : pasted(of)));
  return `// ${words}\n${inNamespace(`mistake_${index}`, namespacesOf(inside.flatMap(linesOf)), text)}`;
}

const sources = mistakes.map(source);
const entries = mistakes.map(
  ({ name, header, type }, i) => `      {"${name}", "${header}", make<mistake_${i}::measure::${type}>},`,
);
const libraries = [...used, ...included].flatMap(linesOf).filter(line => /^#include </.test(line));
writeFileSync(
  out,
  `${[...new Set(libraries)].join('\n')}
${[...included].map(file => `#include ${JSON.stringify(file)}`).join('\n')}
#include "live/own.h"
${sources.join('\n')}
namespace live {
namespace {
template <class Step>
std::unique_ptr<Own> make() {
  return std::make_unique<OwnOf<Step>>();
}
}  // namespace
std::span<const Stand> mistakes() {
  static constexpr Stand list[] = {
${entries.join('\n')}
  };
  return list;
}
}  // namespace live
`,
);
writeFileSync(`${out}.d`, `${out}: ${[...used, ...included, ...mistakes.map(({ file }) => file)].join(' ')}\n`);
