// The examples over each header of code/integrate, compiled in an empty folder beside copies of the headers that they name:
//   node examples.test.mjs FOLDER_OF_HEADERS FOLDER_OF_CARDS EIGEN COMPILER
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { copyFileSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';

const [headers, cards, eigen, compiler] = process.argv.slice(2);
const names = readdirSync(headers)
  .filter(name => name.endsWith('.h'))
  .sort();
const read = name => readFileSync(join(headers, name), 'utf8');

// The text between @code and @endcode, as a reader copies it.
function examplesOf(header) {
  const blocks = [...header.matchAll(/^\/\/\/ @code\n((?:\/\/\/.*\n)*?)\/\/\/ @endcode$/gm)];
  return blocks.map(([, text]) => text.replace(/^\/\/\/ ?/gm, ''));
}

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

for (const name of names) {
  test(`the example over ${name} compiles, runs and ends where it should`, () => {
    const examples = examplesOf(read(name));
    assert.ok(examples.length, `${name} has no @code in its first comment`);
    const folder = mkdtempSync(join(tmpdir(), 'example-'));
    try {
      const source = programOf(name, examples);
      for (const [, needed] of source.matchAll(/^#include "(.*)"$/gm))
        copyFileSync(join(headers, needed), join(folder, needed));
      writeFileSync(join(folder, 'example.cpp'), source);
      writeFileSync(join(folder, 'check.cpp'), CHECK);
      const flags = [
        '-std=c++17',
        '-O1',
        '-Wall',
        '-Wextra',
        '-Wpedantic',
        '-Wconversion',
        '-Wshadow',
        '-Werror',
        '-Wno-unused-variable',
        '-isystem',
        eigen,
      ];
      const made = spawnSync(compiler, [...flags, 'example.cpp', 'check.cpp', '-o', 'example'], {
        cwd: folder,
        encoding: 'utf8',
      });
      assert.equal(made.status, 0, made.stderr);
      const run = spawnSync(join(folder, 'example'), { encoding: 'utf8' });
      assert.equal(run.status, 0, run.stdout + run.stderr);
    } finally {
      rmSync(folder, { recursive: true });
    }
  });
}
