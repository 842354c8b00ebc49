// Summarises build/.ninja_log:  node times.mjs NINJA_LOG OUT   (OUT is left alone when nothing changed)
import { existsSync, readFileSync, writeFileSync } from 'node:fs';

const GROUPS = [
  ['weave', /(^|\/)book\/|book\.stamp$/],
  ['figures', /\/figures\//],
  ['claims', /claims\.xml$/],
  ['run programs', /\/data\//],
  ['compile', /\.(o|pch|gch)$/],
  ['link', /\.(a|so|wasm)$|(^|\/)[\w.-]+$/],
];

// One row per edge: when it started and ended in its build [ms], when its output was written, what it made.
export function readLog(text) {
  const edges = new Map();
  for (const line of text.split('\n')) {
    const [start, end, , output, command] = line.split('\t');
    if (!command) continue;
    edges.set(`${command} ${start} ${end}`, { start: Number(start), end: Number(end), output });
  }
  return [...edges.values()];
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
export function lastBuildSeconds(edges) {
  let last = 0;
  edges.forEach((edge, i) => { if (i && edge.end < edges[i - 1].end) last = i; });
  return Math.max(0, ...edges.slice(last).map(edge => edge.end)) / 1000;
}

export function table(edges) {
  const rows = summarise(edges).map(({ name, edges: n, seconds }) => `${name.padEnd(14)}${String(n).padStart(6)}${seconds.toFixed(1).padStart(10)}`);
  const total = summarise(edges).reduce((sum, { seconds }) => sum + seconds, 0);
  return [`${'part'.padEnd(14)}${'edges'.padStart(6)}${'seconds'.padStart(10)}`, ...rows,
    `${'all of them'.padEnd(14)}${String(edges.length).padStart(6)}${total.toFixed(1).padStart(10)}`,
    `last build: ${lastBuildSeconds(edges).toFixed(1)} s from its first edge to its last`, ''].join('\n');
}

if (process.argv[1]?.endsWith('times.mjs')) {
  const [log, out] = process.argv.slice(2);
  const text = existsSync(log) ? table(readLog(readFileSync(log, 'utf8'))) : 'no log of the build\n';
  writeFileSync(out, text);
  process.stdout.write(text);
}
