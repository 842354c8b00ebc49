// What the headers are to reach, and what was measured.
const methods = ['euler', 'symplectic_euler', 'velocity_verlet', 'rk4', 'dopri5'];
const kinds = ['float, one thread', 'double, one thread', 'float, two threads', 'double, two threads'];
const many = ['32 orbits, symplectic_euler', '32 orbits, rk4'];

const [chain, cloth] = ['chain of 10,000 masses', 'cloth of 58 x 58 masses'];

const atMost = bound => ({ text: `at most ${bound}`, met: value => value <= bound });
const atLeast = bound => ({ text: `at least ${bound}`, met: value => value >= bound });

const of512 = method => `512 orbits, ${method}`;

// Each value is computed from `time(group, variant)`, which is NaN of what isn't there.
const least = times => Math.min(...times.filter(t => !Number.isNaN(t)));
const besideFastest = (time, group, libraries, headers = ['header, struct']) =>
  least(headers.map(variant => time(group, variant))) / least(libraries.map(variant => time(group, variant)));
const headers = ['header, struct', 'header, Vector2d', 'header, one Vec'];
const odeint = ['odeint, array', 'odeint, Eigen', 'odeint classic, array', 'odeint, vector'];
const others = ['GSL', 'SUNDIALS ERKStep', 'SUNDIALS SPRKStep'];
const besideOdeint = time => methods.slice(0, 4).map(m => besideFastest(time, m, odeint));
const geometricMean = values => Math.exp(values.reduce((sum, v) => sum + Math.log(v), 0) / values.length);
const beyond = (time, kind, variant) =>
  time(`10 million particles, ${kind}`, 'limit of memory') / time(`10 million particles, ${kind}`, variant);

export const goals = [
  {
    what: 'One orbit, header on a struct: time beside the loop by hand, worst of the five methods',
    goal: atMost(1.03),
    value: time => Math.max(...methods.map(m => time(m, 'header, struct') / time(m, 'by hand'))),
  },
  {
    what: 'The same beside the fastest odeint, worst of the first four',
    goal: atMost(1.03),
    value: time => Math.max(...besideOdeint(time)),
  },
  { what: 'The same, on balance (geometric mean)', goal: atMost(1), value: time => geometricMean(besideOdeint(time)) },
  {
    what: 'dopri5 beside the fastest odeint, which adds slope by slope and rounds five times for once',
    goal: atMost(1.1),
    value: time => besideFastest(time, 'dopri5', odeint),
  },
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
  ...['rk4', 'dopri5'].map(method => ({
    what: `${method}: times faster than SUNDIALS`,
    goal: atLeast(5),
    value: time => time(method, 'SUNDIALS ERKStep') / time(method, 'header, struct'),
  })),
  {
    what: '512 orbits, header on a struct: time beside the loop by hand, worst of the five methods',
    goal: atMost(1.1),
    value: time => Math.max(...methods.map(m => time(of512(m), 'header, struct') / time(of512(m), 'by hand'))),
  },
  {
    what: 'The fastest row of a header beside the fastest odeint, worst of the five methods',
    goal: atMost(1.03),
    value: time => Math.max(...methods.map(m => besideFastest(time, of512(m), odeint, headers))),
  },
  {
    what: 'The header on a struct beside the faster of GSL and SUNDIALS, worst of rk4 and dopri5',
    goal: atMost(1),
    value: time => Math.max(...['rk4', 'dopri5'].map(m => besideFastest(time, of512(m), others))),
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
