// Weaves the book:  node weave.mjs CONFIG.json
import { existsSync, readFileSync } from 'node:fs';
import { Faults, weave } from './weaving.mjs';

const configFile = process.argv[2];
if (process.argv.length !== 3 || !existsSync(configFile)) {
  console.error('usage: node weave.mjs CONFIG.json   (CMake writes the file and runs this)');
  process.exit(2);
}
try {
  console.log(weave(JSON.parse(readFileSync(configFile, 'utf8'))));
} catch (fault) {
  if (!(fault instanceof Faults)) throw fault;
  console.error(fault.message);
  process.exitCode = 1;
}
