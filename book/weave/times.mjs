// Summarises build/.ninja_log:  node times.mjs NINJA_LOG OUT   (OUT is left alone when nothing changed)
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, resolve } from 'node:path';

const GROUPS = [
  ['weave', /(^|\/)book\/|book\.stamp$/],
  ['figures', /\/figures\//],
  ['claims', /claims\.xml$/],
  ['run programs', /\/data\//],
  ['compile', /\.(o|pch|gch)$/],
  ['link', /\.(a|so|wasm)$|(^|\/)[\w.-]+$/],
];

// One row per line of the log: when an edge started and ended in its build [ms], what it made, the hash of its command. What it
// made is told from the build folder on: what folders that one lies in says nothing.
export function readLog(text, folder) {
  return text
    .split('\n')
    .map(line => line.split('\t'))
    .filter(fields => fields.length === 5)
    .map(([start, end, , output, command]) => ({
      start: Number(start),
      end: Number(end),
      output: output.replace(`${folder}/`, ''),
      command,
    }));
}

// The log has a line for each output of an edge, and still has those of older builds: the last one of an output counts,
// and outputs of one command are one edge.
export function edgesOf(entries) {
  const outputs = new Map(
    entries.filter(({ output }) => !/(^|\/)times\.txt$/.test(output)).map(entry => [entry.output, entry]),
  );
  return [...new Map([...outputs.values()].map(entry => [entry.command, entry])).values()];
}

export function summarise(edges) {
  const groups = new Map(GROUPS.map(([name]) => [name, { name, edges: 0, seconds: 0 }]));
  for (const { start, end, output } of edges) {
    const [name] = GROUPS.find(([, pattern]) => pattern.test(output)) ?? ['link'];
    const group = groups.get(name);
    group.edges += 1;
    group.seconds += (end - start) / 1000;
  }
  return [...groups.values()].filter(group => group.edges);
}

// Ninja appends each build to the log, and its clock starts at 0 again: the last build is what follows the last time
// that an edge ended before the one above it.
export function lastBuildSeconds(entries) {
  let last = 0;
  entries.forEach((entry, i) => {
    if (i && entry.end < entries[i - 1].end) last = i;
  });
  return Math.max(0, ...entries.slice(last).map(entry => entry.end)) / 1000;
}

export function table(entries) {
  const edges = edgesOf(entries);
  const rows = summarise(edges).map(
    ({ name, edges: n, seconds }) => `${name.padEnd(14)}${String(n).padStart(6)}${seconds.toFixed(1).padStart(10)}`,
  );
  const total = summarise(edges).reduce((sum, { seconds }) => sum + seconds, 0);
  return [
    `${'part'.padEnd(14)}${'edges'.padStart(6)}${'seconds'.padStart(10)}`,
    ...rows,
    `${'all of them'.padEnd(14)}${String(edges.length).padStart(6)}${total.toFixed(1).padStart(10)}`,
    `last build: ${lastBuildSeconds(entries).toFixed(1)} s from its first edge to its last`,
    '',
  ].join('\n');
}

if (process.argv[1]?.endsWith('times.mjs')) {
  const [log, out] = process.argv.slice(2);
  const text = existsSync(log)
    ? table(readLog(readFileSync(log, 'utf8'), dirname(resolve(log))))
    : 'no log of the build\n';
  writeFileSync(out, text);
  process.stdout.write(text);
}
