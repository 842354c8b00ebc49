// What the headers are to reach, and what was measured.
const methods = ['euler', 'symplectic_euler', 'velocity_verlet', 'rk4'];
const kinds = ['float, one thread', 'double, one thread', 'float, two threads', 'double, two threads'];
const many = ['32 orbits, symplectic_euler', '32 orbits, rk4'];

const [chain, cloth] = ['chain of 10,000 masses', 'cloth of 58 x 58 masses'];

const atMost = bound => ({ text: `at most ${bound}`, met: value => value <= bound });
const atLeast = bound => ({ text: `at least ${bound}`, met: value => value >= bound });

// Each value is computed from `time(group, variant)`.
const besideOdeint = time =>
  methods.map(
    m =>
      time(m, 'header, struct') /
      Math.min(
        time(m, 'odeint, array'),
        time(m, 'odeint, Eigen'),
        m === 'rk4' ? time(m, 'odeint classic, array') : Infinity,
      ),
  );
const geometricMean = values => Math.exp(values.reduce((sum, v) => sum + Math.log(v), 0) / values.length);
const beyond = (time, kind, variant) =>
  time(`10 million particles, ${kind}`, 'limit of memory') / time(`10 million particles, ${kind}`, variant);

export const goals = [
  {
    what: 'One orbit, header on a struct: time beside the loop by hand, worst of the four methods',
    goal: atMost(1.03),
    value: time => Math.max(...methods.map(m => time(m, 'header, struct') / time(m, 'by hand'))),
  },
  {
    what: 'The same beside the fastest odeint, worst of the four methods',
    goal: atMost(1.03),
    value: time => Math.max(...besideOdeint(time)),
  },
  { what: 'The same, on balance (geometric mean)', goal: atMost(1), value: time => geometricMean(besideOdeint(time)) },
  {
    what: 'rk4: times faster than a call of GSL',
    goal: atLeast(3),
    value: time => time('rk4', 'GSL, for each call') / time('rk4', 'header, struct'),
  },
  {
    what: 'rk4: times faster than GSL along the same trajectory, where its call is two steps',
    goal: atLeast(3),
    value: time => time('rk4', 'GSL') / time('rk4', 'header, struct'),
  },
  {
    what: 'rk4: times faster than SUNDIALS',
    goal: atLeast(5),
    value: time => time('rk4', 'SUNDIALS ERKStep') / time('rk4', 'header, struct'),
  },
  ...kinds.map(kind => ({
    what: `Particles, ${kind}: speed beside the limit of memory`,
    goal: atLeast(0.95),
    value: time => beyond(time, kind, 'header, number by number'),
  })),
  ...kinds.map(kind => ({
    what: `Particles, ${kind}, 16 substeps: speed beside that limit`,
    goal: atLeast(5),
    value: time => beyond(time, kind, 'header, blocks, 16 substeps'),
  })),
  ...kinds.map(kind => ({
    what: `The same with time counted in substeps, ${kind}`,
    goal: atLeast(5),
    value: time => beyond(time, kind, 'header, blocks, 16 substeps, h = 1'),
  })),
  {
    what: '32 orbits: time of the better header row beside the loop vectorised by hand, worst of the two methods',
    goal: atMost(1.1),
    value: time =>
      Math.max(
        ...many.map(
          g => Math.min(time(g, 'header, blocks'), time(g, 'header, plain loop')) / time(g, 'vectorised by hand'),
        ),
      ),
  },
  {
    what: 'Implicit step of a chain of 10,000 unknowns, in milliseconds',
    goal: atMost(1),
    value: time => (10_000 * time(chain, 'header, BandSystem')) / 1e6,
  },
  {
    what: 'The same beside Thomas by hand',
    goal: atMost(1.3),
    value: time => time(chain, 'header, BandSystem') / time(chain, 'by hand, Thomas'),
  },
  {
    what: 'Implicit step of cloth of 10,092 unknowns, beside plain Eigen',
    goal: atMost(1.3),
    value: time => time(cloth, 'header, SparseSystem') / time(cloth, 'by hand, plain Eigen'),
  },
];

/// One goal under one set of flags: by the medians, and by the fastest rounds; undefined if it wasn't measured.
export function reached({ value, goal }, groups, flags) {
  const by = statistic =>
    value((group, variant) => groups.get(group)?.get(variant)?.times.get(flags)?.[statistic] ?? NaN);
  const median = by('median');
  return Number.isNaN(median) ? undefined : { median, fastest: by('min'), met: goal.met(median) };
}
