// A program of the book and what it includes, as files for the compiler in the page.

// Its file system knows no "..": what lies beside a chapter's folder is found from the folder of all chapters.
const found = text => text.replace(/^#include "\.\.\//gm, '#include "');

/** { path: text } of a flat list, as the tree that the compiler takes. */
export function treeOf(files) {
  const tree = {};
  for (const [path, text] of Object.entries(files)) {
    const folders = path.split('/');
    const name = folders.pop();
    const folder = folders.reduce((inside, one) => (inside[one] ??= {}), tree);
    folder[name] = found(text);
  }
  return tree;
}

/** The paths of a program and of all headers of the book that it includes, in the order in which they are met. */
export function pathsOf(files, path, met = []) {
  if (met.includes(path)) return met;
  met.push(path);
  const here = path.split('/').slice(0, -1).join('/');
  for (const [, name] of files[path].matchAll(/^#include "(.*)"/gm)) {
    const beside = new URL(name, `file:///${here}/`).pathname.slice(1);
    const next = [beside, `code/${name}`].find(candidate => candidate in files);
    if (next) pathsOf(files, next, met);
  }
  return met;
}

const CLANG = ['clang++', '-std=c++20', '-O1', '-ffp-contract=off', '-fno-exceptions', '-Wall', '-Icode', '-Ichapters'];

export const PRECOMPILED = 'play.pch';
export const precompileArguments = [...CLANG, '-x', 'c++-header', 'chapters/play.h', '-o', PRECOMPILED];

/** @param precompiled  whether the compiler has chapters/play.h by now, which is what takes long */
export const programArguments = (path, precompiled) => [
  ...CLANG,
  ...(precompiled ? ['-include-pch', PRECOMPILED] : []),
  '-Wl,--strip-all',
  '-Wl,--max-memory=134217728',
  path,
  '-o',
  'program.wasm',
];
