// SPDX-License-Identifier: MIT-0
// node program.mjs CODE HEADER SOURCE OUT EDIT...: writes to OUT a source that tries each EDIT of HEADER by
// the one test of SOURCE that must see it, and the same tests of the header as it is.
//
// Each version of the header stands in a namespace of its own, with the test and with all headers between the two. What
// does not depend on the header is compiled once, and so is what templates of libraries become.
// A test's name begins with the version's, by versions.mjs. OUT.d says what OUT was made of, for Ninja.
import { writeFileSync } from 'node:fs';
import { basename } from 'node:path';
import { edited } from '../../exercises/apply_edit.mjs';
import { INCLUDE, inNamespace, namespacesOf, readSources } from './sources.mjs';
import { versionsOf } from './versions.mjs';

const [code, headerFile, sourceFile, outFile, ...edits] = process.argv.slice(2);
const { linesOf, filesOf, pasted } = readSources(code);

const files = filesOf(sourceFile);
const inside = files.filter(file => filesOf(file).includes(headerFile));
const outside = files.filter(file => !inside.includes(file));
const namespaces = namespacesOf(inside.flatMap(linesOf));

// The source with one of its tests alone, under a longer name.
function withTest(test, version) {
  let found = false;
  const text = linesOf(sourceFile)
    .join('\n')
    .replace(/^(?:TEMPLATE_(?:\w+_)?)?TEST_CASE\([^]*?^\}$/gm, block => {
      const name = /"((?:[^"\\]|\\.)*)"/.exec(block.replace(/"\s*\n\s*"/g, ''))[1];
      if (name !== test) return block.replace(/.+/g, '');
      found = true;
      return block.replace('"', `"${version}: `);
    });
  if (!found) throw new Error(`${sourceFile} has no test "${test}"`);
  return pasted(sourceFile, text.split('\n'));
}

// All sources are linked into one program, and no two may have a name in common.
const unit = basename(outFile, '.cpp').replace('.', '_in_');

function namespaceOf({ name, test, method, edit }, index) {
  const header = edit ? edited(headerFile, edit).split('\n') : linesOf(headerFile);
  return [
    ...(method ? [`#define ONLY ${method}`] : []),
    inNamespace(
      `${unit}_${index}`,
      namespaces,
      inside.map(file => {
        if (file === sourceFile) return withTest(test, name);
        return file === headerFile ? pasted(edit ?? file, header) : pasted(file);
      }),
    ),
    ...(method ? ['#undef ONLY'] : []),
  ].join('\n');
}

const libraries = inside.flatMap(linesOf).filter(line => INCLUDE.exec(line)?.[1]);
writeFileSync(
  outFile,
  [
    ...new Set(edits.flatMap(edit => edited(headerFile, edit).split('\n')).filter(line => INCLUDE.exec(line)?.[1])),
    ...new Set(libraries),
    ...outside.map(file => `#include ${JSON.stringify(file)}`),
    ...versionsOf(edits).map(namespaceOf),
    '',
  ].join('\n'),
);
writeFileSync(`${outFile}.d`, `${outFile}: ${[...files, ...edits].join(' ')}\n`);
