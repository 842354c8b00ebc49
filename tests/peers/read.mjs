// What the programs measured: Google Benchmark's JSON files, put together.
import { readFileSync } from 'node:fs';

export function readMeasurements(files) {
  const all = { lacks: new Map(), flags: [], groups: new Map(), shares: [] };
  for (const file of files) addFile(all, JSON.parse(readFileSync(file, 'utf8')));
  const { shares, ...measured } = all;
  return { ...measured, share: shares.sort((a, b) => a - b)[Math.floor(shares.length / 2)] };
}

function addFile(all, { context, benchmarks }) {
  all.processor = `${context.processor}, ${context.num_cpus} cores`;
  all.compiler = context.compiler;
  all.clock = context.clock;
  all.date = context.date.slice(0, 10);
  all.libraries = context.libraries;
  for (const [key, value] of Object.entries(context)) {
    if (key.startsWith('lacks ')) all.lacks.set(key.slice(6), value);
  }
  if (!all.flags.includes(context.flags)) all.flags.push(context.flags);
  const inOrder = [...benchmarks].sort((a, b) => a.family_index - b.family_index);
  for (const benchmark of inOrder) addAggregate(all, context.flags, benchmark);
}

// A run's name begins with that of its row, group/variant.
function addAggregate(all, flags, benchmark) {
  if (benchmark.error_occurred) throw new Error(`${benchmark.run_name}: ${benchmark.error_message}`);
  const [group, variant, ...settings] = benchmark.run_name.split('/');
  const rows = getOrAdd(all.groups, group, () => new Map());
  const row = getOrAdd(rows, variant, () => ({ note: benchmark.label ?? '', times: new Map() }));
  const time = getOrAdd(row.times, flags, () => ({}));
  time[benchmark.aggregate_name] = benchmark.seconds_per_step * 1e9;
  all.rounds = benchmark.repetitions;
  if (benchmark.aggregate_name === 'median' && !settings.includes('real_time')) {
    all.shares.push(benchmark.cpu_time / benchmark.real_time);
  }
}

function getOrAdd(map, key, make) {
  if (!map.has(key)) map.set(key, make());
  return map.get(key);
}
