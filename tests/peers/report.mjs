// Writes what was measured, for reading, and the times that the book keeps:
//   node report.mjs OUT MEASURED.json...
import { writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { markdown } from './markdown.mjs';
import { readMeasurements } from './read.mjs';

const [out, ...files] = process.argv.slice(2);
const measured = readMeasurements(files);
const { processor, clock, compiler, date, rounds, groups, share } = measured;

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

writeFileSync(join(out, 'speed.md'), markdown(measured));
writeFileSync(join(out, 'times.csv'), timesOfPlanets(measured.flags.find(set => set.startsWith('-O3'))));
console.log(`All that was measured: ${join(out, 'speed.md')}`);
