// What "Try it" opens on the page of each header: a program that compiles without a warning and prints what its examples say.
//   node try.test.mjs CODE EIGEN COMPILER
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { examplesOf, programOf } from '../../book/compiler/page/try-source.js';

const [code, eigen, compiler] = process.argv.slice(2);
const work = mkdtempSync(join(tmpdir(), 'try-'));
after(() => rmSync(work, { recursive: true }));

function run(folder, name, text) {
  const [source, program] = ['try.cpp', 'program'].map(file => join(work, file));
  writeFileSync(source, programOf(folder, name, examplesOf(text)));
  const includes = [`-I${code}`, `-I${join(code, folder)}`, '-isystem', eigen];
  const made = spawnSync(
    compiler,
    ['-std=c++20', '-Wall', '-Wextra', '-Werror', '-Wno-unused-variable', ...includes, source, '-o', program],
    {
      encoding: 'utf8',
    },
  );
  assert.equal(made.status, 0, `${name}\n${made.stderr}`);
  const { status, stdout } = spawnSync(program, { encoding: 'utf8' });
  assert.equal(status, 0, name);
  return stdout.split('\n');
}

for (const folder of ['integrate', 'shelf']) {
  const headers = readdirSync(join(code, folder)).filter(name => name.endsWith('.h'));
  for (const name of headers) {
    const text = readFileSync(join(code, folder, name), 'utf8');
    if (text.includes('#include <Eigen/') || !examplesOf(text).length) continue; // nothing to try in the page
    test(name, () => {
      const printed = run(folder, name, text);
      const said = [...text.matchAll(/^\/\/\/ *\/\/ Now (.+) is (.+)\.$/gm)];
      assert.ok(printed.length > 1);
      if (folder === 'integrate') return assert.match(printed[0], /^x is -?\d[\d.e-]*, v is -?\d[\d.e-]*$/);
      said.forEach(([, expression, number], i) => {
        const [, value] = printed[i].split(`${expression} is `);
        assert.equal(printed[i].indexOf(`${expression} is `), 0);
        const digits = number
          .replace(/e.*$/, '')
          .replace(/[-.]/g, '')
          .replace(/^0+(?=.)/, '').length;
        const isSo =
          Number(number) === 0 ? Math.abs(value) < 1e-6 : Number(Number(value).toPrecision(digits)) === Number(number);
        assert.ok(isSo, `${expression} is ${value}, and the example says ${number}`);
      });
    });
  }
}
