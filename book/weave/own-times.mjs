// Puts the times of this machine in place of recorded ones:  node own-times.mjs TABLE.csv TIMES.csv OUT.csv
// TABLE has a column `time`, the name of each, and a column `ns`. Where this machine was not quiet, or took no such time, a row
// has zero, which is nowhere on a logarithmic axis.
import { readFileSync, writeFileSync } from 'node:fs';
import { quiet, readTimes } from './measured-times.mjs';

const [, , table, timesHere, out] = process.argv;
const here = readTimes(timesHere);
const [head, ...rows] = readFileSync(table, 'utf8').trimEnd().split('\n');
const columns = head.split(',');
const name = columns.indexOf('time');
const ns = columns.indexOf('ns');
if (name < 0 || ns < 0) throw new Error(`${table} has no column time or no column ns`);
const own = rows.map(row => {
  const cells = row.split(',');
  cells[ns] = (quiet(here) && here.of.get(cells[name])?.median) || 0;
  return cells.join(',');
});
writeFileSync(out, `${[head, ...own].join('\n')}\n`);
