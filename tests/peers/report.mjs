// Writes the table, as Markdown and as CSV, and what the plot needs:
//   node report.mjs OUT MEASURED.json...
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { goalsTable, markdown } from './markdown.mjs';
import { fastFlags, plotTables } from './plot-tables.mjs';
import { readMeasurements } from './read.mjs';

const [out, ...files] = process.argv.slice(2);
const measured = readMeasurements(files);
const { processor, clock, compiler, date, rounds, groups, share } = measured;

const quoted = value => (/[",\n]/.test(value) ? `"${value.replaceAll('"', '""')}"` : value);
const csv = rows => rows.map(row => row.map(quoted).join(',') + '\n').join('');

function allRows() {
  const rows = [
    ['group', 'variant', 'flags', 'median [ns]', 'min [ns]', 'max [ns]', 'rounds', 'processor', 'compiler'],
  ];
  for (const [group, variants] of groups)
    for (const [variant, { times }] of variants)
      for (const [flags, t] of times) {
        rows.push([group, variant, flags, t.median, t.min, t.max, rounds, processor, compiler]);
      }
  return rows;
}

// The steps of one planet, and of one of 512, as the book keeps times: code/measure/times.h.
function timesOfPlanets(flags) {
  const lines = [
    '# Times of a step [ns]: what a quarter, a half and three quarters of the runs stayed below.',
    `# processor: ${processor}`,
    `# clock: ${clock}`,
    `# compiler: ${compiler} ${flags}`,
    `# date: ${date}`,
    `# runs: ${rounds}`,
    `# others: ${Number((1 - Math.min(1, share)).toPrecision(2))}`,
    'name,lower,median,upper',
  ];
  for (const method of ['symplectic_euler', 'velocity_verlet', 'rk4', 'dopri5']) {
    for (const group of [method, `512 orbits, ${method}`]) {
      for (const [variant, { times }] of groups.get(group)) {
        const { lower, median, upper } = times.get(flags);
        lines.push(
          [
            `library/${group}/${variant}`.replaceAll(',', ''),
            ...[lower, median, upper].map(time => time.toPrecision(4)),
          ].join(','),
        );
      }
    }
  }
  return lines.join('\n') + '\n';
}

mkdirSync(join(out, 'plot'), { recursive: true });
writeFileSync(join(out, 'speed.md'), markdown(measured));
writeFileSync(join(out, 'speed.csv'), csv(allRows()));
writeFileSync(join(out, 'times.csv'), timesOfPlanets(fastFlags(measured.flags).native));
for (const [name, rows] of Object.entries(plotTables(measured)))
  writeFileSync(join(out, 'plot', `${name}.csv`), csv(rows));
writeFileSync(
  join(out, 'plot', 'machine.gp'),
  `MACHINE = ${JSON.stringify(`Measured on ${processor}, with ${compiler}`)}
FLAGS = ${JSON.stringify(fastFlags(measured.flags).native)}\n`,
);
console.log(`${goalsTable(measured)}\nAll the rest: ${join(out, 'speed.md')}, with speed.csv and speed.svg beside it.`);
