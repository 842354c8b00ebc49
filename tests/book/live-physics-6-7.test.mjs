// What the live figures of chapters 6 and 7 show is what is said there. Each row opens a figure with the settings of a link,
// lets it run to its end, and looks at what is shown there:  node live-physics-6-7.test.mjs BUILD
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from './book.mjs';
import { openTab } from './browser.mjs';
import { endOf, figureOf, open } from './live.mjs';

const tab = await openTab();
const end = (name, query) => endOf(tab, name, query);

// A polygon whose edges should be curves misses less than this share of its area [%] in nine seconds, twice the run of the figure: with 20 points on an edge
// of the cat it was at most 0.022 off, with 50 a sixth of that, as it should be when what is missed goes with their length squared.
const POLYGON = 0.05;
const LEVEL = ['jump', 'leaf', 'suspension', 'hatch', 'lamp', 'shuttle'];
const labels = figureOf('speed-against-accuracy').methods;

test('symplectic methods keep the area of the cat at any step, Euler lets it grow, backward Euler shrink', async () => {
  const area = async (method, h) => (await end('cats', `method=${method}&h=${h}`)).area;
  for (const h of [0.05, 0.25, 0.5]) {
    for (const method of ['symplectic_euler', 'velocity_verlet'])
      assert.ok(Math.abs((await area(method, h)) - 100) < POLYGON, `${method} ${h}`);
  }
  for (const h of [0.05, 0.1]) {
    const grown = (await area('euler', h)) / 100,
      shrunk = (await area('backward_euler', h)) / 100;
    const most = (1 + h * h) ** (4.5 / h); // a step multiplies every area by 1 + h^2 cos x
    assert.ok(grown > 1.1 && grown < most, `${grown} of ${most}`);
    assert.ok(shrunk < 0.9 && shrunk > 1 / most, `${shrunk} of ${1 / most}`);
  }
  assert.ok((await area('rk4', 0.5)) < 100 - 2 * POLYGON);
});

test('for a thousand turns symplectic Euler sways within what its first turns showed, RK4 sinks, and Euler escapes', async () => {
  const symplectic = await end('turning', 'method=symplectic_euler&rate=15');
  const farthest = now => Math.hypot(now['farthest x'], now['farthest y']);
  assert.ok(
    symplectic.turns > 900 && Math.abs(farthest(symplectic) / 16 - 1) < 0.07,
    `${symplectic.turns} turns, ${farthest(symplectic)}`,
  );
  const band = await tab.evaluate(() => {
    const { trace } = globalThis.Live.opened.turning.run;
    const range = (from, to) => [
      Math.min(...trace['least energy'].slice(from, to)),
      Math.max(...trace['most energy'].slice(from, to)),
    ];
    return { early: range(0, 200), late: range(-200) };
  });
  const width = band.early[1] - band.early[0];
  for (const edge of [0, 1])
    assert.ok(Math.abs(band.late[edge] - band.early[edge]) < 0.02 * width, JSON.stringify(band));
  const sunk = async rate => 16 - farthest(await end('turning', `method=rk4&rate=${rate}`));
  const [slow, fast] = [await sunk(10), await sunk(20)];
  assert.ok(slow > 8 && fast < slow / 2 ** 4, `${slow} ${fast}`);
  assert.ok((await end('turning', 'method=euler&rate=15'))['most energy'] > 0);
});

test('each method loses the spring where the chapter says that it does', async () => {
  const lost = async query => {
    await end('your-spring', query);
    return tab.evaluate(() => globalThis.Live.opened['your-spring'].drawing.lost);
  };
  assert.deepEqual(await lost('omega=40&zeta=1&rate=30'), [
    'symplectic_euler',
    'velocity_verlet',
    'yoshida4',
    'predicted_euler',
  ]);
  assert.deepEqual(await lost('omega=40&zeta=0&rate=60'), ['euler']);
  assert.deepEqual(await lost('omega=60&zeta=2&rate=15'), [
    'euler',
    'midpoint',
    'rk4',
    'dopri5',
    'symplectic_euler',
    'velocity_verlet',
    'yoshida4',
    'predicted_euler',
  ]);
  assert.deepEqual(await lost('omega=10&zeta=1&rate=240'), []);
});

test('symplectic Euler loses what lies outside of its limit, and the map beside it shows that limit', async () => {
  const limit = zeta => 2 * (Math.sqrt(1 + zeta ** 2) - zeta);
  for (const [omega, rate, zeta] of [
    [50, 30, 1],
    [60, 30, 0.5],
    [20, 60, 0.2],
  ]) {
    const { x } = await end('your-spring', `omega=${omega}&rate=${rate}&zeta=${zeta}&method=symplectic_euler`);
    assert.equal(Number.isNaN(x), omega / rate > limit(zeta), `${omega} ${rate} ${zeta}`);
  }
  const map = await tab.evaluate(() => globalThis.Live.descriptions['your-spring'].tables.map);
  map['ζ'].forEach((zeta, i) => assert.ok(Math.abs(map['symplectic Euler'][i] / limit(zeta) - 1) < 1e-4, `${zeta}`));
});

test('in the level every method is off by what the chapter has recorded, and asks as often', async () => {
  const [header, ...rows] = readFileSync(join(build, 'chapters/7-which-to-use/data/work.csv'), 'utf8')
    .trim()
    .split('\n');
  const work = rows.map(row => Object.fromEntries(row.split(',').map((cell, i) => [header.split(',')[i], cell])));
  let compared = 0,
    fitting = 0;
  for (const thing of LEVEL) {
    const now = await end('speed-against-accuracy', `thing=${thing}`);
    const exact = ['spring_folded', 'constant_acceleration'];
    const isThere = name => Object.values(now[`${name} errors`]).length > 0;
    fitting += Object.keys(labels).filter(name => isThere(name) && !exact.includes(name)).length;
    for (const name of exact.filter(isThere)) {
      assert.ok(Math.max(...Object.values(now[`${name} errors`])) < 1e-9, `${thing}, ${name}`);
    }
    for (const [name, label] of Object.entries(labels)) {
      for (const row of work.filter(row => row.thing === thing && row.method.toLowerCase() === label.toLowerCase())) {
        const rate = Number(row['steps per second']),
          place = Object.values(now.tried).indexOf(rate / 60);
        if (place < 0) continue;
        const [found, recorded] = [now[`${name} errors`][place] ?? Infinity, Number(row.error)];
        const where = `${thing}, ${label}, ${rate} steps a second: ${found} instead of ${recorded}`;
        // The page looks at the ends of frames alone, and calls gone what is a kilometre off.
        assert.ok(found < 1.001 * recorded + 1e-8 || !(recorded < 1000), where);
        if (rate === 60 && recorded < 1000) assert.ok(Math.abs(found - recorded) < 1e-6 * recorded + 1e-8, where);
        assert.equal(now[`${name} evaluations`], Number(row.evaluations) / rate, where);
        ++compared;
      }
    }
  }
  assert.equal(compared, 4 * fitting); // at four rates
  assert.ok(fitting > 10 * LEVEL.length);
});

test('the line of choose asks for the thing that is shown', async () => {
  for (const query of [
    'jump',
    'leaf',
    'suspension',
    'hatch',
    'lamp',
    'shuttle',
    'spring&omega=40&zeta=0.5',
    'orbit&turn=2',
    'air&drag=5',
  ]) {
    const now = await end('speed-against-accuracy', `thing=${query}&tolerance=3e-5`);
    const line = await tab.locator('[data-live=speed-against-accuracy] .advice code').textContent();
    const [program, ...words] = line.split(' ');
    const told = JSON.parse(
      execFileSync(join(build, program.replace('build/', '')), [...words, '--format', 'json'], { encoding: 'utf8' }),
    );
    const reach = Number(words[words.indexOf('--reach') + 1]);
    const both = told.filter(
      entry => entry.function in labels && Object.values(now.tried).includes(entry.steps_per_frame),
    );
    assert.ok(both.length, `${query}: no method to compare`);
    for (const { function: name, steps_per_frame: steps, error } of both) {
      const found = now[`${name} errors`][Object.values(now.tried).indexOf(steps)];
      assert.ok(
        Math.abs(found - error * reach) < 1e-3 * found + 1e-8,
        `${query}, ${name}: ${found} instead of ${error * reach}`,
      );
    }
  }
});

test('a kick and a drift keep the area of the cat at every moment, to what its straight edges cost, and both at once do not', async () => {
  const area = async query => {
    const shears = await open(tab, figureOf('shears'), query);
    return (await shears.trace()).area;
  };
  assert.ok((await area('method=symplectic_euler')).every(value => Math.abs(value - 100) < 0.05));
  assert.ok((await area('method=euler&h=0.5')).at(-1) > 150);
});

test('the spring goes as far out as the shadow says, and past two it leaves', async () => {
  for (const homega of [0.5, 1.5, 1.9]) {
    const { farthest, shadow, ...now } = await end('opening', `homega=${homega}`);
    const most = 1 / Math.sqrt(1 - homega ** 2 / 4);
    assert.ok(farthest <= most + 1e-9 && farthest > 0.98 * most, `${farthest} of ${most}`);
    assert.ok(Math.abs(shadow - 1) < 1e-9);
    const out = Math.max(...[...now['curve x']].map(Math.abs));
    assert.ok(Math.abs(out / most - 1) < 0.001, `${out} of ${most}`);
  }
  assert.ok((await end('opening', 'homega=2.1')).farthest > 1000);
});

test('six leaves end at the speeds of the chapter, and two of them at the right one', async () => {
  const now = await end('terminal', 'c=2&rate=20');
  const factor = { explicit: 0.9, implicit: 1 / 1.1, exponential: Math.exp(-0.1) };
  for (const [how, f] of Object.entries(factor)) {
    // v = (v + ha) f and v = v f + ha, as parts of a / c; ch is a tenth.
    assert.ok(Math.abs(now[`${how} last speed`] - (0.1 * f) / (1 - f)) < 1e-4, `${how} last`);
    assert.ok(Math.abs(now[`${how} first speed`] - 0.1 / (1 - f)) < 1e-4, `${how} first`);
  }
});

test('the crate keeps the energies that the film prints', async () => {
  const crate = await open(tab, figureOf('thrown-crate'), '');
  const { t, ...trace } = await crate.trace();
  const after = t.findIndex(one => one > 5 - 1e-6);
  const printed = [1.99516, 0.560593, 0.999998];
  ['naive', 'bullet', 'rotations'].forEach((way, i) =>
    assert.ok(Math.abs(trace[`${way} energy`][after] - printed[i]) < 1e-5, `${way}`),
  );
});

test('the cells of the level are those of the chapter, and the cheapest ways keep within what is asked', async () => {
  const now = await end('level', '');
  const lines = readFileSync(join(build, 'chapters/7-which-to-use/data/level.csv'), 'utf8').trim().split('\n');
  const [head, ...rows] = lines.map(line => line.split(','));
  const { controls } = figureOf('level');
  const [things, methods] = ['thing', 'method'].map(of =>
    Object.keys(controls.find(({ name }) => name === of).choices),
  );
  const labels = { ...controls.find(({ name }) => name === 'method').choices };
  things.forEach((thing, j) =>
    methods.forEach((method, i) => {
      const row = rows.find(([label]) => label.toLowerCase() === labels[method].toLowerCase());
      const recorded = Number(row[head.findIndex(name => name.startsWith(thing))].replace('inf', 'Infinity')) / 100;
      const shown = now.errors[10 * j + i];
      const same = shown === recorded || Math.abs(shown - recorded) < 1e-3 * recorded + 1e-7;
      assert.ok(same, `${thing}, ${method}: ${shown} instead of ${recorded}`);
    }),
  );
  const bill = async tolerance => [...(await end('level', `tolerance=${tolerance}`)).bills];
  const [loose, tight] = [await bill(0.1), await bill(0.0001)];
  assert.ok(loose.every((price, j) => price <= tight[j] && price >= 1));
});
