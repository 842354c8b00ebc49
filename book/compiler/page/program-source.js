// A program of the book and what it includes, as files for the compiler in the page.
import { ABOVE, STANDARD } from './precompiled.js';

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

// What a precompiled header and the programs that use it have to agree in. A program may say `throw`, and ends there.
const CLANG = [
  'clang++',
  '-std=c++20',
  '-O1',
  '-ffp-contract=off',
  '-fexceptions',
  '-fignore-exceptions',
  '-D_LIBCPP_HARDENING_MODE=_LIBCPP_HARDENING_MODE_FAST', // an index past the end ends a program
  '-Wall',
];

const FOLDERS = ['-Icode', '-Icode/integrate', '-Icode/shelf', '-Ichapters'];

/** What precompiles one of precompiled.js, templates and all: what uses it need not go over them again. */
export const precompileArguments = name => [
  ...CLANG,
  ...(name === STANDARD ? [] : ['-include-pch', STANDARD, ...FOLDERS]),
  '-fpch-instantiate-templates',
  '-x',
  'c++-header',
  name === STANDARD ? 'standard.h' : ABOVE[name].header,
  '-o',
  name,
];

/** @param precompiled  one of precompiled.js; the compiler's thread adds it */
export const programArguments = (path, precompiled = STANDARD) => [
  ...CLANG,
  '-include-pch',
  precompiled,
  ...FOLDERS,
  '-Wl,--strip-all',
  '-Wl,--max-memory=134217728',
  path,
  '-o',
  'program.wasm',
];
