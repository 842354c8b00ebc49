// Puts the times of this machine in place of recorded ones:  node own-times.mjs TABLE.csv TIMES.csv OUT.csv
// TABLE has a column `time`, the name of each, and a column `ns`. Where this machine was not quiet, or took no such time, a row
// has zero, which is nowhere on a logarithmic axis.
import { writeFileSync } from 'node:fs';
import { readCsv } from './csv.mjs';
import { quiet, readTimes } from './measured-times.mjs';

const [, , table, timesHere, out] = process.argv;
const here = readTimes(timesHere);
const [columns, ...rows] = readCsv(table);
const name = columns.indexOf('time');
const ns = columns.indexOf('ns');
if (name < 0 || ns < 0) throw new Error(`${table} has no column time or no column ns`);
for (const row of rows) row[ns] = (quiet(here) && here.of.get(row[name])?.median) || 0;
writeFileSync(out, `${[columns, ...rows].map(row => row.join(',')).join('\n')}\n`);
