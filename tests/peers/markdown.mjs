// The report for reading.
const digits = ns => ns.toFixed(ns < 1 ? 3 : ns < 100 ? 2 : 0);
const line = cells => `| ${cells.join(' | ')} |`;
const table = (head, alignment, rows) => [line(head), line(alignment), ...rows.map(line), ''].join('\n');
const isLimit = rows => rows.keys().next().value.startsWith('limit');

export function markdown(measured) {
  return [
    heading(measured),
    ...[...measured.groups].map(([name, rows]) => groupTable(name, rows, measured.flags)),
  ].join('\n');
}

function heading({ processor, compiler, libraries, lacks, rounds, share }) {
  const missing = [...lacks].map(([row, why]) => `- ${row.replace('/', ': ')}. ${why}`);
  const busy = share < 0.97 ? ' **Something else kept it busy: measure again, above all what takes two threads.**' : '';
  return `# Speed beside what you could use instead

Measured on ${processor}, with ${compiler}, ${libraries}. The programs had the processor for ${Math.round(100 * share)} % of their time.${busy}

Times are nanoseconds for one step of one body: the median of ${rounds} rounds and, in brackets, the shortest and the longest
of them. All rows of one program under one set of flags took turns, in random order and in one process. It is the time
of the processor; with two threads, the time on the clock. Before that, each program made sure that the rows of a
group compute the same motion. \`-O2\` alone knows only the vector instructions of the oldest processors of this kind, and
g++ 12 hardly makes vectors of loops with it.

${missing.length ? `Rows that this system lacks:\n\n${missing.join('\n')}` : 'No row is missing on this system.'}
`;
}

function groupTable(name, rows, flags) {
  const [first] = rows.values();
  const sets = flags.filter(set => first.times.has(set));
  const cells = row =>
    sets.flatMap(set => {
      const t = row.times.get(set);
      const reference = first.times.get(set).median;
      const beside = isLimit(rows)
        ? `${((100 * reference) / t.median).toFixed(0)} %`
        : (t.median / reference).toFixed(2);
      return [`${digits(t.median)} (${digits(t.min)}–${digits(t.max)})`, beside];
    });
  const beside = isLimit(rows) ? 'speed' : 'time';
  return `## ${name}

${table(
  ['', ...sets.flatMap(set => [`\`${set}\` [ns]`, beside]), ''],
  ['---', ...sets.flatMap(() => ['--:', '--:']), '---'],
  [...rows].map(([variant, row]) => [variant, ...cells(row), row.note]),
)}`;
}
