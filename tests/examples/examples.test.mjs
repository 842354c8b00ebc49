// The examples over each header of code/integrate and code/shelf, compiled in an empty folder beside copies of the headers that they name:
//   node examples.test.mjs METHODS SHELF FOLDER_OF_CARDS EIGEN COMPILER [EMULATOR]
// With an emulator, the programs hold all their libraries; if it was not found, they are compiled and not run.
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import {
  closeSync,
  copyFileSync,
  mkdtempSync,
  openSync,
  readFileSync,
  readdirSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { examplesOf } from '../../book/compiler/page/try-source.js';

const [methods, shelf, cards, eigen, compiler, emulator] = process.argv.slice(2);
const headersOf = folder =>
  readdirSync(folder)
    .filter(name => name.endsWith('.h'))
    .sort();
const read = (folder, name) => readFileSync(join(folder, name), 'utf8');

const called = code => [...code.matchAll(/integrate::(\w+)/g)].map(([, name]) => name);

// The order that the worst of the methods showed on a damped spring; `exact` is as good as any.
function orderOf(code) {
  const files = readdirSync(cards);
  const orders = called(code)
    .filter(name => files.includes(`${name}.csv`))
    .map(name => {
      const line =
        readFileSync(join(cards, `${name}.csv`), 'utf8').match(/^drag-order,.*?,([^,]*),[^,]*,[^,]*$/m)?.[1] ?? 'exact';
      return line === 'exact' ? 5 : Math.round(Number(line));
    });
  return orders.length ? Math.min(...orders) : 0;
}

// What the examples with numbers move is x'' = -9 x - x' from x = 1 at rest, for one second, by steps of a sixtieth. The state
// has to be there, but for h omega to the power of the order. The others, with vectors, have to have moved. It is a file of
// its own: the examples include what they need, and no more is included for them.
const CHECK = `
#include <cmath>
#include <cstdio>
int check(double x, double v, double allowed) {
  const double w = std::sqrt(9 - 0.25), left = std::exp(-0.5);
  const double x_true = left * (std::cos(w) + 0.5 / w * std::sin(w)), v_true = -left * 9 / w * std::sin(w);
  if (std::abs(x - x_true) < allowed && std::abs(v - v_true) < 3 * allowed) return 0;
  std::printf("x = %g and v = %g after a second, where %g and %g are true\\n", x, v, x_true, v_true);
  return 1;
}
`;

const DECLARED = `int check(double, double, double);
template <class Vec>
int check(const Vec& x, const Vec& v, double) {
  return x.allFinite() && v.allFinite() && v.norm() > 1e-3 ? 0 : 1;
}
`;

function programOf(name, examples) {
  const order = orderOf(examples.join(''));
  const includes = examples.join('').match(/^#include .*$/gm) ?? [];
  const body = examples.map(
    code => `${code.replace(/^#include .*$/gm, '')}  wrong += check(x, v, ${(3 / 60) ** order});\n`,
  );
  return `${[`#include "${name}"`, ...includes].join('\n')}\n${DECLARED}int main() {\n  int wrong = 0;\n${body.join('')}  return wrong;\n}\n`;
}

// What an example of the shelf says at its end has to be so, to the digits that it says.
const SAID = /^ *\/\/ Now (.+) is (-?[\d.]+(?:e-?\d+)?)\.$/gm;

function roundingOf(number) {
  const [, fraction = '', exponent = '0'] = number.match(/^-?\d+(?:\.(\d+))?(?:e(-?\d+))?$/);
  return 0.5001 * 10 ** (Number(exponent) - fraction.length);
}

function programOfShelf(name, examples) {
  const includes = examples.join('').match(/^#include .*$/gm) ?? [];
  const body = examples.map(code => {
    const said = code.match(SAID)?.length ?? 0;
    assert.ok(said, `no line "// Now EXPRESSION is NUMBER." in the example over ${name}`);
    const checked = code.replace(
      SAID,
      (_, expression, number) =>
        `wrong += off(${JSON.stringify(expression)}, double(${expression}), ${number}, ${roundingOf(number)});`,
    );
    return `{\n${checked.replace(/^#include .*$/gm, '')}}\n`;
  });
  return `${[`#include "${name}"`, ...includes].join('\n')}
int off(const char*, double, double, double);
int main() {
  int wrong = 0;
${body.join('')}  return wrong;
}
`;
}

const CHECK_OF_SHELF = `
#include <cmath>
#include <cstdio>
int off(const char* expression, double found, double said, double allowed) {
  if (std::abs(found - said) <= allowed) return 0;
  std::printf("%s is %.9g, and not %g\\n", expression, found, said);
  return 1;
}
`;

const warnings = ['-Wall', '-Wextra', '-Wpedantic', '-Wconversion', '-Wshadow', '-Werror', '-Wno-unused-variable'];
const flags = ['-std=c++17', '-O1', ...(emulator ? ['-static'] : []), ...warnings, '-isystem', eigen];

function compile(cwd, ...words) {
  const { status, stderr } = spawnSync(compiler, [...flags, ...words], { cwd, encoding: 'utf8' });
  assert.equal(status, 0, stderr);
}

// Compiles and runs it in a folder of its own, with what checks it, an object file.
function tryOut(folder, name, source, check) {
  const scratch = mkdtempSync(join(tmpdir(), 'example-'));
  try {
    for (const [, needed] of source.matchAll(/^#include "(.*)"$/gm))
      copyFileSync(join(folder, needed), join(scratch, needed));
    writeFileSync(join(scratch, 'example.cpp'), source);
    compile(scratch, 'example.cpp', check, '-o', 'example.exe'); // so called, Windows runs it, too
    if (emulator?.endsWith('-NOTFOUND')) return;
    const [program, ...words] = [...(emulator ? [emulator] : []), join(scratch, 'example.exe')];
    const printed = join(scratch, 'printed.txt'); // services of Wine hold a pipe for seconds after
    const out = openSync(printed, 'w');
    const { status } = spawnSync(program, words, { stdio: ['ignore', out, out] });
    closeSync(out);
    assert.equal(status, 0, readFileSync(printed, 'utf8'));
  } finally {
    rmSync(scratch, { recursive: true });
  }
}

function tryAll(folder, makeProgram, check) {
  const checked = mkdtempSync(join(tmpdir(), 'check-'));
  after(() => rmSync(checked, { recursive: true }));
  const object = join(checked, 'check.o');
  before(() => {
    writeFileSync(join(checked, 'check.cpp'), check);
    compile(checked, '-c', 'check.cpp', '-o', object);
  });
  for (const name of headersOf(folder)) {
    test(`the example over ${name} compiles, runs and ends where it should`, () => {
      const examples = examplesOf(read(folder, name));
      assert.ok(examples.length, `${name} has no @code in its first comment`);
      tryOut(folder, name, makeProgram(name, examples), object);
    });
  }
}

tryAll(methods, programOf, CHECK);
tryAll(shelf, programOfShelf, CHECK_OF_SHELF);
