// The tables that speed.gp draws, each with the names of its columns. Rows run downwards, so the first has the largest y.
const missing = ['NaN', 'NaN', 'NaN'];

const spread = t => (t ? [t.median, t.min, t.max] : missing);
// Three columns for each name: what it is, and from where to where it goes.
const table = (names, rows) => [
  ['variant', 'row', ...names.flatMap(name => [name, `${name} from`, `${name} to`])],
  ...rows.map(([label, ...values], i) => [label, rows.length - i, ...values]),
];

/// The flags of the fast builds, with and without errno.
export function fastFlags(flags) {
  const fast = flags.filter(set => set.startsWith('-O3'));
  return {
    native: fast.find(set => !set.includes('-fno-math-errno')),
    noErrno: fast.find(set => set.includes('-fno-math-errno')),
  };
}

export function plotTables({ groups, flags }) {
  const fast = fastFlags(flags);
  const times = (group, variant, flags) => groups.get(group)?.get(variant)?.times.get(flags);
  return { orbit: orbit(groups, times, fast), particles: particles(groups, times, fast), many: many(times, fast) };
}

function orbit(groups, times, { native }) {
  const methods = ['rk4', 'euler', 'symplectic_euler', 'velocity_verlet'];
  const variants = new Set(methods.flatMap(method => [...groups.get(method).keys()]));
  variants.delete('GSL, for each call');
  return table(
    methods,
    [...variants].map(v => [v, ...methods.flatMap(method => spread(times(method, v, native)))]),
  );
}

function particles(groups, times, { native }) {
  const kinds = ['float, one thread', 'float, two threads', 'double, one thread', 'double, two threads'];
  const group = kind => `10 million particles, ${kind}`;
  const speed = (kind, variant) => {
    const t = times(group(kind), variant, native);
    const limit = times(group(kind), 'limit of memory', native).median;
    return t ? [limit / t.median, limit / t.max, limit / t.min] : missing;
  };
  const variants = [...groups.get(group(kinds[0])).keys()];
  return table(
    kinds,
    variants.map(v => [v, ...kinds.flatMap(kind => speed(kind, v))]),
  );
}

function many(times, { native, noErrno }) {
  const variants = ['vectorised by hand', 'header, blocks', 'header, plain loop'];
  const kinds = ['symplectic_euler', 'rk4'].flatMap(method => [native, noErrno].map(flags => ({ method, flags })));
  return table(
    kinds.map(({ method, flags }) => `${method}${flags === noErrno ? ' without errno' : ''}`),
    variants.map(v => [v, ...kinds.flatMap(({ method, flags }) => spread(times(`32 orbits, ${method}`, v, flags)))]),
  );
}
