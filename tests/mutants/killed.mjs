// SPDX-License-Identifier: MIT-0
// node killed.mjs MUTANTS OUT: runs each mutant's program and writes to OUT which test killed it.
//
// A line of MUTANTS is the mutant's name, its program and the test that must fail, with tabs
// between. A mutant is killed by a failed assertion of that test, and by nothing else. Says how
// many were killed; exits with 1 if one survived.
import { execFileSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';

const [mutantsFile, outFile] = process.argv.slice(2);

// Catch2 reads commas, brackets and stars in the name of a test as its own, and appends to the name
// of a test that goes over a list.
function output(program, test) {
  const escaped = test.replace(/[\\,[\]*"~]/g, '\\$&');
  try {
    return execFileSync(program, [`${escaped}*`], {
      encoding: 'utf8',
      timeout: 60_000,
      stdio: 'pipe',
      maxBuffer: 2 ** 28,
    });
  } catch (error) {
    return error.signal ? `ended by ${error.signal}` : error.stdout;
  }
}

const survivors = [];
const lines = readFileSync(mutantsFile, 'utf8').trim().split('\n');
for (const line of lines) {
  const [name, program, test] = line.split('\t');
  const printed = output(program, test);
  if (!/^assertions:.* failed$/m.test(printed)) {
    survivors.push(`${name} survived "${test}":\n${printed.slice(-300).trim()}`);
  }
}
console.log(`mutants: ${lines.length - survivors.length} of ${lines.length} killed`);
if (survivors.length > 0) {
  console.error(survivors.join('\n'));
  process.exit(1);
}
writeFileSync(outFile, lines.map(line => `${line.replace(/\t.*\t/, ': ')}\n`).join(''));
