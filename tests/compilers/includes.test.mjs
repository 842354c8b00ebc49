// Every name of std that a file uses comes from a standard header that it includes, or that one of our own headers included by it
// does. What comes with another standard header by chance comes with this compiler's alone.   node includes.test.mjs SOURCE
import assert from 'node:assert/strict';
import { existsSync, readFileSync } from 'node:fs';
import { dirname, join, normalize } from 'node:path';
import { test } from 'node:test';
import { sourceFiles } from '../source_files.mjs';
import { headersOf } from './std_headers.mjs';

const source = process.argv[2];
// Our own headers are named from the file's folder, or from one of these.
const roots = ['code', 'exercises/grader', 'tests', 'tests/peers', 'tests/snippets', 'book', 'chapters'];

const bare = text =>
  text.replace(/\/\*[\s\S]*?\*\/|\/\/.*|R"(\w*)\([\s\S]*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])+'/g, found =>
    found.startsWith('"') || found.startsWith('R"') ? '""' : '\n'.repeat(found.split('\n').length - 1),
  );
const read = file => readFileSync(join(source, file), 'utf8');

// The standard headers that a file and our own headers in it name. Exercises stand behind given.h.
function included(file, seen = new Set()) {
  if (seen.has(file)) return [];
  seen.add(file);
  const given = /^exercises\/\d/.test(file) ? included('exercises/grader/harness/given.h', seen) : [];
  return [
    ...given,
    ...[...read(file).matchAll(/^\s*#\s*include\s+([<"])([^>"]+)[>"]/gm)].flatMap(([, quote, name]) => {
      if (quote === '<') return [name];
      const place = [dirname(file), ...roots]
        .map(root => normalize(join(root, name)))
        .find(path => existsSync(join(source, path)));
      return place ? included(place, seen) : [];
    }),
  ];
}

// What is missing in a file, as `file:line: message`.
function missing(file) {
  const there = new Set(included(file));
  const found = new Map();
  bare(read(file))
    .split('\n')
    .forEach((line, i) => {
      for (const [, name] of line.matchAll(/(?<![\w:])(?:::)?std::((?:ranges::|experimental::)?\w+)/g)) {
        const headers = headersOf.get(name);
        const place = `${file}:${i + 1}: `;
        if (!headers)
          found.set(
            name,
            `${place}std::${name} stands in no row of tests/compilers/std_headers.mjs; add it to its header's`,
          );
        else if (!headers.some(header => there.has(header)))
          found.set(name, `${place}std::${name} needs ${headers.map(header => `<${header}>`).join(' or ')}`);
      }
    });
  return [...found.values()];
}

const files = sourceFiles(source)
  .filter(name => /\.(cpp|h)$/.test(name))
  // Not what students hand in, what is broken on purpose, and what is only woven.
  .filter(
    file =>
      !/^exercises\/\d.*\/(right|wrong)\/|^tests\/grader\/corpus\/(broken|hostile)\/|^tests\/weave\/sample\//.test(
        file,
      ),
  );

test('no file lacks a standard header', () => {
  assert.ok(files.length > 400, `only ${files.length} files`);
  assert.deepEqual(files.flatMap(missing), []);
});
