// Compares the runs of the native program with those of the module in Node:  node same-bits.mjs PROGRAM MODULE TABLE [many]
// Prints the table of fingerprints, and writes it where all are the same.
import { execFile } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { promisify } from 'node:util';
import './page/module.js';
import { MANY_STEPS, STEPS, cases, casesOfManySteps, question } from './cases.mjs';

const [program, module, table, many] = process.argv.slice(2);
const steps = many ? MANY_STEPS : STEPS;
const runs = many ? casesOfManySteps() : cases();
const natively = promisify(execFile)(program); // beside this process
natively.child.stdin.end(runs.map(run => question(run, steps)).join('\n'));
const compiled = await WebAssembly.compile(readFileSync(module));
const inNode = [];
for (const { figure, settings } of runs) {
  const opened = await globalThis.Live.open(compiled, figure);
  for (const [name, value] of Object.entries(settings)) opened.set(name, value);
  inNode.push(opened.fingerprint(steps));
}
const native = (await natively).stdout.trim().split('\n');
const lines = [];
let different = 0;
for (const [i, { figure, settings }] of runs.entries()) {
  const node = inNode[i];
  if (node !== native[i]) ++different;
  const words = Object.entries(settings).map(
    ([name, value]) => `${name}=${Number(value) ? Number(Number(value).toPrecision(4)) : value}`,
  );
  lines.push(
    `${figure.padEnd(14)} ${words.join(' ').padEnd(44)} ${native[i]} ${node} ${node === native[i] ? 'same' : 'DIFFERENT'}`,
  );
}
const head = `${'figure'.padEnd(14)} ${'settings'.padEnd(44)} ${'native'.padEnd(16)} ${'Node'.padEnd(16)}`;
const text = `Fingerprints of ${steps} steps\n${head}\n${lines.join('\n')}\n`;
process.stdout.write(text);
if (different) {
  console.error(
    `${different} of ${runs.length} runs have other bits in the page than here: are they compiled with the options of the target reproducible?`,
  );
  process.exit(1);
}
writeFileSync(table, text);
