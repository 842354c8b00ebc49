// SPDX-License-Identifier: MIT-0
// node killed.mjs PROGRAM EDIT...: runs the test of each version that program.mjs put into PROGRAM.
//
// A wrong version is killed by a failed assertion of its test, and by nothing else; and the header as it is must pass the
// same test, or the test would say nothing of the mistake. Says how many were killed; exits with 1 if one survived.
import { spawnSync } from 'node:child_process';
import { versionsOf } from './versions.mjs';

const [program, ...edits] = process.argv.slice(2);

// Catch2 reads commas, brackets and stars in the name of a test as its own, and appends to the name
// of a test that goes over a list.
function output({ name, test }) {
  const escaped = `${name}: ${test}`.replace(/[\\,[\]*"~]/g, '\\$&');
  const { signal, stdout } = spawnSync(program, [`${escaped}*`, '--abort'], {
    encoding: 'utf8',
    timeout: 60_000,
    maxBuffer: 2 ** 28,
  });
  return signal ? `ended by ${signal}` : stdout;
}

function fault({ edit, name, test }, printed) {
  if (edit) return /^assertions:.* failed$/m.test(printed) ? '' : `${name} survived "${test}":`;
  return /^(?:All tests passed|test cases: (\d+) \| \1 passed$)/m.test(printed)
    ? ''
    : `${name} does not pass "${test}":`;
}

const versions = versionsOf(edits);
const faults = versions.flatMap(version => {
  const printed = output(version);
  const found = fault(version, printed);
  return found ? [{ edit: version.edit, text: `${found}\n${printed.slice(-300).trim()}` }] : [];
});
const survived = faults.filter(({ edit }) => edit).length;
console.log(`mutants: ${edits.length - survived} of ${edits.length} killed`);
for (const { text } of faults) console.error(text);
process.exit(faults.length > 0 ? 1 : 0);
