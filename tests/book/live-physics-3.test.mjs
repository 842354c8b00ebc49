// What the live figures of chapter 3 show is what is said there. Each row opens a figure with the settings of a link,
// lets it run to its end, and looks at what is shown there:  node live-physics-3.test.mjs BUILD COMPILER
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from './book.mjs';
import { openTab } from './browser.mjs';
import { endOf } from './live.mjs';

const tab = await openTab();
const end = (name, query) => endOf(tab, name, query);

test('for the same evaluations Euler takes four steps and RK4 one, and each misses the circle by what its formula says', async () => {
  const omega = (2 * Math.PI) / 8,
    seconds = 80;
  for (const rate of [16, 60]) {
    const now = {};
    for (const method of ['euler', 'midpoint', 'rk4'])
      now[method] = await end('equal-cost', `method=${method}&rate=${rate}`);
    assert.deepEqual(
      [now.euler.steps, now.midpoint.steps, now.rk4.steps],
      [1, 2, 4].map(cost => (seconds * rate) / cost),
    );
    const distance = Math.hypot(now.euler['euler x'], now.euler['euler y']);
    assert.ok(
      Math.abs(distance / (10 * (1 + (omega / rate) ** 2) ** ((seconds * rate) / 2)) - 1) < 1e-9,
      `${distance}`,
    );
    // What RK4 lacks in each step is the fifth power of e^(i h omega); what follows is smaller by h omega, squared where it counts.
    const angle = (4 * omega) / rate,
      lack = (10 * now.rk4.steps * angle ** 5) / 120;
    assert.ok(Math.abs(now.rk4['rk4 error'] / lack - 1) < angle ** 2, `${now.rk4['rk4 error']} instead of ${lack}`);
  }
});

test('on the circle RK4 is nearer than symplectic Euler on sixteen evaluations a second, and farther on four', async () => {
  const ratio = async rate => {
    const now = await end('equal-cost', `rate=${rate}`);
    return now['rk4 error'] / now['symplectic_euler error'];
  };
  assert.ok((await ratio(16)) < 1 / 4 && (await ratio(4)) > 1.5, `${await ratio(16)} ${await ratio(4)}`);
});

test('on sixteen evaluations a second the ellipse is lost by Euler, and kept near its shape by symplectic Euler', async () => {
  const now = await end('equal-cost', 'orbit=ellipse&rate=16');
  const distance = method => Math.hypot(now[`${method} x`], now[`${method} y`]);
  assert.ok(
    distance('euler') > 10 * 16 && distance('symplectic_euler') < 1.1 * 16,
    `${distance('euler')} ${distance('symplectic_euler')}`,
  );
});

const FAULTS = [
  'none',
  'fourth stage along the second slope',
  'third stage repeats the second',
  'stages with the old velocity',
  'all slopes count the same',
  'clock stands still',
];
const RIGHT = { third: 'second', fourth: 'third', moving: 'new', clock: 'runs', weights: 'right' };
const ONE_FAULT = [
  {},
  { fourth: 'second' },
  { third: 'first' },
  { moving: 'old' },
  { weights: 'equal' },
  { clock: 'stands' },
];

// What is shown with these faults; the page is that of the figure.
const withFaults = (faults, scene) =>
  tab.evaluate(
    values => {
      const figure = globalThis.Live.opened['stage-bug'];
      figure.choose(values);
      return { ...figure.run.now };
    },
    { ...RIGHT, ...faults, scene },
  );

test('RK4 with one fault has the orders of the table, and is as far off in a turn', async () => {
  const [, ...rows] = readFileSync(join(build, 'chapters/3-runge-kutta/data/bugs.csv'), 'utf8').trim().split('\n');
  assert.deepEqual(
    rows.map(row => row.split(',')[0]),
    FAULTS,
  );
  await end('stage-bug', 'rate=60');
  for (const [i, row] of rows.entries()) {
    const [, off, ...orders] = row.split(',').map(Number);
    for (const [k, scene] of ['drone', 'parachute', 'rocket'].entries()) {
      const now = await withFaults(ONE_FAULT[i], scene);
      assert.ok(Math.abs(now['your order'] - orders[k]) < 1e-3, `${row}: ${now['your order']} on the ${scene}`);
      if (k === 0) assert.ok(Math.abs(1e6 * now['your off'] - off) < 1e-4 * off, `${row}: ${now['your off']}`);
    }
  }
});

// Runs the lines beside the figure on both scenes for so long as it shows them, and prints where they end.
const program = bodies => `#include <complex>
#include <cstdio>
using Real = double;
using C = std::complex<double>;
${bodies
  .map(
    (body, i) => `template <class Vec> void step${i}(Vec& x, Vec& v, double t, double h, auto acceleration) {
  using Position = Vec;
  const double t_middle = t + h / 2, t_end = t + h;
  ${body}
}
void run${i}() {
  C x = 10, v = C(0, 10 * M_PI / 4);
  for (int n = 0; n < 480; ++n) step${i}(x, v, n / 60.0, 1 / 60.0, [](C x, C, double) { return -M_PI * M_PI / 16 * x; });
  double up = 0, speed = 0;
  for (int n = 0; n < 240; ++n) step${i}(up, speed, n / 60.0, 1 / 60.0, [](double, double, double t) { return 35 / (2 - 0.25 * t) - 9.81; });
  std::printf("%.17g %.17g %.17g\\n", x.real(), x.imag(), up);
}
`,
  )
  .join('')}int main() {
${bodies.map((_, i) => `  run${i}();\n`).join('')}}
`;

test('the lines of RK4 that are shown with a fault, compiled, go where it is drawn', async () => {
  const made = [
    ...ONE_FAULT,
    { third: 'first', fourth: 'first', moving: 'old', clock: 'stands', weights: 'equal' },
    { third: 'first', moving: 'old' },
  ];
  const bodies = [],
    ends = [];
  await end('stage-bug', 'rate=60');
  for (const faults of made) {
    const at = async scene => {
      const now = await withFaults(faults, scene);
      return ['your x', 'your y'].map(of => Object.values(now[of]).at(-1));
    };
    ends.push([...(await at('drone')), (await at('rocket'))[1]]);
    bodies.push(await tab.locator('[data-live=stage-bug] .listing pre').textContent());
  }
  const folder = mkdtempSync(join(tmpdir(), 'edits-'));
  try {
    writeFileSync(join(folder, 'edits.cpp'), program(bodies));
    execFileSync(process.argv[3] ?? 'c++', ['-std=c++20', 'edits.cpp', '-o', 'edits'], { cwd: folder });
    const lines = execFileSync(join(folder, 'edits'), { encoding: 'utf8' }).trim().split('\n');
    lines.forEach((line, i) =>
      line.split(' ').forEach((number, k) => {
        assert.ok(Math.abs(Number(number) - ends[i][k]) < 1e-10, `${JSON.stringify(made[i])}: ${line}, not ${ends[i]}`);
      }),
    );
    assert.equal(new Set(bodies).size, made.length);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test('each frame of the comet costs what the chapter has recorded, cut up by frames, run ahead of them and in equal steps', async () => {
  const data = file =>
    readFileSync(join(build, `chapters/3-runge-kutta/data/${file}.csv`), 'utf8')
      .trim()
      .split('\n');
  const recorded = name =>
    Number(
      data('numbers')
        .find(line => line.startsWith(`${name},`))
        .split(',')[1],
    );
  const numbers = list => Object.values(list);
  const cut = await end('comet-cost', 'method=cut&rate=60');
  const costs = data('comet')
    .slice(1)
    .map(row => Number(row.split(',')[1]));
  assert.deepEqual(numbers(cut.costs), costs);
  assert.equal(cut.sum, recorded('comet-framed'));
  assert.equal(cut.dearest, recorded('comet-dearest'));
  // A frame asks once at its start, and six times for each try.
  assert.equal(cut.sum, 1200 + 6 * (cut.steps + cut.missed));
  assert.ok(cut.missed > 5 && numbers(cut['missed x']).length === cut.missed, `${cut.missed}`);
  const fast = await end('comet-cost', 'rate=144');
  const apart = Math.hypot(cut.x - fast.x, cut.y - fast.y);
  assert.ok(Math.abs(1e6 * apart - recorded('comet-apart')) < 0.01, `${apart}`);
  const [ahead, read] = [
    await end('comet-cost', 'method=ahead&rate=60'),
    await end('comet-cost', 'method=ahead&rate=144'),
  ];
  assert.equal(ahead.sum, recorded('comet-free'));
  assert.equal(ahead.dearest, recorded('comet-read-dearest'));
  assert.equal(ahead.sum, 1 + 6 * (ahead.steps + ahead.missed));
  assert.deepEqual([ahead.x, ahead.y, ahead.steps, ahead.missed], [read.x, read.y, read.steps, read.missed]);
  const equal = await end('comet-cost', 'method=equal&rate=60');
  // The last of the steps may be left to one frame more.
  assert.ok(recorded('comet-fixed') - equal.sum <= 4 && equal.sum === 4 * equal.steps, `${equal.sum}`);
  assert.ok(Math.abs(1e3 * equal.error - recorded('comet-fixed-error')) < 1e-3, `${equal.error}`);
});
