// What the live figures of chapters 4 and 5 show is what is said there. Each row opens a figure with the settings of a link,
// lets it run to its end, and looks at what is shown there:  node live-physics-4-5.test.mjs BUILD
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openTab } from './browser.mjs';
import { endOf, figureOf, open } from './live.mjs';

const tab = await openTab();
const end = (name, query) => endOf(tab, name, query);

// The stretch of the rope over the second half of the run [%].
async function stretches(query) {
  await end('rope-to-drag', query);
  return tab.evaluate(() => {
    const { trace } = globalThis.Live.opened['rope-to-drag'].run;
    return trace.stretch.slice(trace.t.findIndex(t => t > 5));
  });
}
const mean = list => list.reduce((sum, value) => sum + value) / list.length;
const widest = list => Math.max(...list) - Math.min(...list);

test('a rope is lost in one substep less than the minimum, and the solved one loses energy at every stiffness', async () => {
  for (const k of [1e3, 1e4, 1e5]) {
    const { minimum } = await end('hanging-rope', `k=${k}`);
    // The fastest mode of a long chain has twice the frequency of one spring, that of a short one a little less.
    const whole = Math.sqrt(k / 0.01) / 60;
    assert.ok(minimum < whole && minimum > 0.99 * whole, `${minimum} instead of ${whole}`);
    const held = await end('hanging-rope', `k=${k}&substeps=${Math.ceil(minimum)}`);
    const lost = await end('hanging-rope', `k=${k}&substeps=${Math.floor(minimum)}`);
    assert.ok(
      Math.abs(held['stepped energy']) < 0.2 && !(lost['stepped energy'] < 1e6),
      `${held['stepped energy']} ${lost['stepped energy']}`,
    );
    // It cannot lose more than a rope that hangs at rest has lost, one half and what the springs give way.
    assert.ok(held['solved energy'] < -0.2 && held['solved energy'] > -0.51, `${held['solved energy']}`);
  }
});

test('a solved frame of the rope costs the same at every stiffness, and substeps cost by their number', async () => {
  const soft = await end('hanging-rope', 'k=1000&substeps=10'),
    stiff = await end('hanging-rope', 'k=100000&substeps=60');
  assert.equal(soft['solved work'], stiff['solved work']);
  assert.equal(stiff['stepped work'], 6 * soft['stepped work']);
});

test('of one blow a hanging cloth keeps least under backward Euler, all in substeps, and more if struck near the hem', async () => {
  const left = async query => {
    const now = await end('three-cloths', query);
    return ['backward_euler', 'bdf2', 'symplectic_euler'].map(method => now[`${method} energy`]);
  };
  const middle = await left('');
  assert.ok(middle[0] < 0.11 && middle[1] > 2 * middle[0] && middle[1] < 0.3, `${middle}`);
  const hem = await left('hit y=-0.9');
  assert.ok(hem[0] > 1.5 * middle[0] && hem[1] > 1.5 * middle[1], `${hem}`);
  for (const [, , stepped] of [middle, hem, await left('hit y=-0.55&k=1000')])
    assert.ok(Math.abs(stepped - 1) < 0.03, `${stepped}`);
  const most = await tab.evaluate(() => Math.max(...globalThis.Live.opened['three-cloths'].run.trace['bdf2 energy']));
  assert.ok(most > 1.1, `${most} on stiff springs`);
  await end('three-cloths', 'k=100&speed=3');
  const { x, y, width, height } = await tab.locator('[data-live=three-cloths] canvas.scene').boundingBox();
  await tab.mouse.click(x + width / 6, y + height / 2);
  const values = await tab.evaluate(() => globalThis.Live.opened['three-cloths'].values);
  assert.ok(Math.abs(values['hit x']) < 0.2 && Math.abs(values['hit y'] + 0.5) < 0.2, JSON.stringify(values));
});

test('a chart marks where its curve leaves it, and none that stays', async () => {
  const exit = async (query, name = 'drone-spiral') => {
    await end(name, query);
    return tab.evaluate(of => globalThis.Live.opened[of].chart.exits, name);
  };
  assert.deepEqual(
    await exit('rate=16', 'equal-cost'),
    [],
    'an error of nothing, at the start, is under every logarithmic axis',
  );
  assert.deepEqual(await exit('method=euler&rate=60'), []);
  const [{ t, up }] = await exit('method=euler&rate=15');
  const growth = (1 + ((2 * Math.PI) / 8 / 15) ** 2) ** 15;
  assert.ok(up && Math.abs(t - Math.log(4) / Math.log(growth)) < 0.2, `${t}`);
  const [down] = await exit('omega=60&zeta=0&rate=15&method=euler', 'your-spring');
  assert.equal(down.up, false, 'Euler takes this spring from 1 to 1 and then to -15');
});

test('a rope that has come down is stretched about as its formula says, in substeps an eighth of that', async () => {
  const rule = (iterations, substeps) => (100 * 20 ** 2 * 9.81 * (1 / 60 / substeps) ** 2) / (2 * iterations) / 2;
  for (const [iterations, substeps] of [
    [1, 1],
    [4, 1],
    [8, 1],
    [1, 8],
  ]) {
    const found = mean(await stretches(`iterations=${iterations}&substeps=${substeps}`)) / rule(iterations, substeps);
    assert.ok(Math.abs(found - 1) < 0.2, `${found} of the rule with ${iterations} iterations in ${substeps} substeps`);
  }
});

test('in recorded frames the rope twitches more than three times as wide, corrected or not', async () => {
  const even = widest(await stretches('method=even'));
  for (const method of ['recorded', 'distance_corrected', 'uneven']) {
    const recorded = widest(await stretches(`method=${method}`));
    assert.ok(recorded > 3 * even, `${recorded} ${even}`);
  }
});

test('of two ropes with a weight the one in substeps is stretched by its formula, and that in iterations as many times as far', async () => {
  for (const [pulls, weight] of [
    [1, 10],
    [4, 1],
    [8, 10],
    [8, 50],
  ]) {
    await end('two-ropes', `pulls=${pulls}&weight=${weight}`);
    const [iterated, stepped] = await tab.evaluate(() => {
      const { trace } = globalThis.Live.opened['two-ropes'].run;
      return ['iterated stretch', 'stepped stretch'].map(of => trace[of].slice(trace.t.findIndex(t => t > 3)));
    });
    const rule = (100 * (190 + 19 * (weight - 1)) * 9.81) / (60 * pulls) ** 2 / 2;
    for (const [found, wanted] of [
      [mean(stepped), rule],
      [mean(iterated), pulls * rule],
    ])
      assert.ok(Math.abs(found / wanted - 1) < 0.2, `${found} instead of ${wanted}, with ${pulls} pulls of ${weight}`);
  }
});

test('of two ropes any point is in the hand, and what hangs below a cut falls freely', async () => {
  for (const rope of ['iterated', 'stepped']) {
    const at = (now, i) => [now[`${rope} x`][i], now[`${rope} y`][i]];
    const turned = await end('two-ropes', 'held=20');
    const [[x, y], [, below]] = [at(turned, 20), at(turned, 0)];
    assert.ok(Math.hypot(x + 0.6, y - 0.1) < 1e-9, `the weight is at ${x}, ${y}`);
    assert.ok(below < 0.1 - 1.4, `the other end is at ${below}`);
    const cut = await end('two-ropes', 'cut=10');
    const left = Math.hypot(at(cut, 9)[0] + 0.6, at(cut, 9)[1] - 0.1);
    assert.ok(left < 0.95, `nine links of ten centimetres reach ${left}`);
    const fallen = (9.81 * 8 ** 2) / 2;
    for (let i = 10; i <= 20; ++i) assert.ok(Math.abs(at(cut, i)[1] + fallen) < 4, `point ${i} is at ${at(cut, i)[1]}`);
  }
});

test('the bar is torn and held at the steps of the chapter', async () => {
  const torn = async rate => {
    const now = await end('bar-lost', `rate=${rate}`);
    return ['euler', 'symplectic_euler', 'rk4', 'backward_euler'].filter((_, i) => now.torn[i]);
  };
  assert.deepEqual(await torn(60), ['euler', 'symplectic_euler', 'rk4']);
  assert.deepEqual(await torn(240), ['euler', 'symplectic_euler']);
  assert.deepEqual(await torn(480), ['euler']);
  assert.deepEqual(await torn(4000), []);
});

test('a soft constraint gives what the chapter says, and the one of Box2D gives less of it', async () => {
  for (const [rate, swings, damping] of [
    [60, 4.6, 0.24],
    [30, 3.9, 0.42],
  ]) {
    const now = await end('soft-damping', `hertz=5&zeta=0&rate=${rate}`);
    assert.ok(Math.abs(now['got hertz'] - swings) < 0.05, `${now['got hertz']}`);
    assert.ok(Math.abs(now['got zeta'] - damping) < 0.01, `${now['got zeta']}`);
  }
  const { trace } = await open(tab, figureOf('soft-damping'), 'rate=60');
  const { once, twice } = await trace();
  const most = xs => Math.max(...xs.slice(6).map(Math.abs));
  assert.ok(most(twice) < most(once), `${most(twice)} ${most(once)}`);
});
