// Makes what a page loads when somebody has an exercise judged:  node pack-judges.mjs OUT JUDGES HARNESS
//
// judging.js: the judges' module and what a student's is linked with, compressed and in Base64, and the thread in which they run.
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { gzipSync } from 'node:zlib';
import { bundled } from './bundled.mjs';

const [out, judges, harness] = process.argv.slice(2);
const packed = file => gzipSync(readFileSync(file), { level: 9 }).toString('base64');
const about = { judges: packed(judges), harness: packed(harness), judging: (await bundled('judge-worker.js')).text };
writeFileSync(join(out, 'judging.js'), `Object.assign((globalThis.Compiled ??= {}), ${JSON.stringify(about)});\n`);
