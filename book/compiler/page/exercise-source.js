// A student's header and the harness of its exercise, as files for the compiler in the page.
import { EXERCISE } from './precompiled.js';
import { programArguments, treeOf } from './program-source.js';

const includes = (...names) => names.map(name => `#include "${name}"\n`).join('');

const OUTPUT = ['-o', 'program.wasm'];
// The checks that a submission of grade has: an index out of range, a sum that overflows, a function without its return. Those of
// each pointer's size and sum would take as long as all else, and find next to nothing.
const CHECKED = [
  '-I.',
  '-fsanitize=array-bounds,undefined',
  '-fno-sanitize=alignment,object-size,pointer-overflow',
  '-fsanitize-trap=all',
  '-Wextra',
  '-Wno-unused-parameter',
];
const ARGUMENTS = [...programArguments('main.cpp', EXERCISE).slice(0, -2), ...CHECKED];
// A stack that overflows is a trap, and the student's own main is known by its name.
const MODULE = [
  '-mexec-model=reactor',
  '-Wl,--stack-first',
  '-Wl,-z,stack-size=1048576',
  '-Wl,--export-if-defined=main',
];

// Whoever computes with complex numbers gets an exact root of them.
const rootOf = text => (text.includes('<complex>') ? ['complex_root.h'] : []);

const filesOf = ({ given, harness }, header, text, main) =>
  treeOf({ ...given, 'exercise/harness.h': harness, [header]: text, 'main.cpp': main });

/** What compiles a header with its harness into a module for the judges: { args, files }. */
export const judgedSource = (task, header, text) => ({
  args: [...ARGUMENTS, ...MODULE, 'harness.o', ...OUTPUT],
  files: {
    ...filesOf(task, header, text, includes('given.h', ...rootOf(text), header, 'exercise/harness.h')),
    'harness.o': task.object,
  },
});

/** What compiles a header with a main of its own: { args, files }. */
export const ownSource = (task, header, text) => ({
  args: [...ARGUMENTS, ...OUTPUT],
  files: filesOf(
    task,
    header,
    text,
    `#undef GRADING\n#include <cstdio>\n${includes('given.h', ...rootOf(text), header)}`,
  ),
});

/** Whether a header has a main, to be run by. */
export const hasMain = text => /\bint\s+main\s*\(/.test(text);

/** A main to begin with, behind what is there. */
export const withMain = text => `${text.trimEnd()}

#ifndef GRADING
int main() {
  std::puts("This is printed by main, at the end of the file.");
}
#endif
`;
