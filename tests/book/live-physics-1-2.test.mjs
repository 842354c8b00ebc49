// What the live figures of the front page and of chapters 1 and 2 show is what is said there. Each row opens a figure with the settings of a link,
// lets it run to its end, and looks at what is shown there:  node live-physics-1-2.test.mjs BUILD
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { openTab } from './browser.mjs';
import { endOf } from './live.mjs';

const tab = await openTab();
const end = (name, query) => endOf(tab, name, query);

test('the drone gains energy under Euler by the factor of the chapter, and keeps it under symplectic Euler', async () => {
  const omega = (2 * Math.PI) / 8;
  for (const rate of [15, 60, 240]) {
    const { energy } = await end('drone-spiral', `method=euler&rate=${rate}`);
    const formula = (1 + (omega / rate) ** 2) ** (80 * rate);
    assert.ok(Math.abs(energy / formula - 1) < 1e-9, `${energy} instead of ${formula} at ${rate}`);
    const swapped = await end('drone-spiral', `method=symplectic_euler&rate=${rate}`);
    assert.ok(Math.abs(swapped.energy - 1) < omega / rate, `${swapped.energy}`);
  }
});

test('the suspension dies away within its limit and grows outside, and the limit is two zeta over omega', async () => {
  for (const zeta of [0.1, 0.3]) {
    const limit = (2 * zeta) / 20;
    const inside = await end('suspension', `method=euler&zeta=${zeta}&h=${limit - 0.001}`);
    const outside = await end('suspension', `method=euler&zeta=${zeta}&h=${limit + 0.001}`);
    assert.ok(inside.energy < 1 && outside.energy > 1, `${inside.energy} ${outside.energy}`);
    assert.ok(Math.abs(inside.limit - limit) < 1e-9, `${inside.limit}`);
  }
});

test('a tenth of the way in every frame depends on the frame rate and on a late frame, smoothing on neither', async () => {
  // The way left 0.4 s after the third jump by ten metres, of which each comes two seconds after the last.
  const left = share => (10 - (10 - 10 * share(2)) * share(2)) * share(0.4);
  const frames = (seconds, rate) => Math.floor(seconds * rate + 1e-9);
  const near = (found, share) => assert.ok(Math.abs(found - left(share)) < 1e-9, `${found} instead of ${left(share)}`);
  for (const [slow, fast, late] of [
    [30, 144, 0],
    [15, 240, 0.25],
  ]) {
    const now = await end('two-cameras', `slow=${slow}&fast=${fast}&late=${late}`);
    const missed = seconds => late && Math.ceil(seconds) * (60 * late - 1);
    near(now['slow lerp'], seconds => 0.9 ** frames(seconds, slow));
    near(now['middle lerp'], seconds => 0.9 ** (frames(seconds, 60) - missed(seconds)));
    near(now['fast lerp'], seconds => 0.9 ** frames(seconds, fast));
    near(now['slow exact'], seconds => 0.9 ** ((60 * frames(seconds, slow)) / slow));
    near(now['middle exact'], seconds => 0.9 ** frames(seconds, 60));
    near(now['fast exact'], seconds => 0.9 ** ((60 * frames(seconds, fast)) / fast));
  }
  const scene = tab.locator('[data-live=two-cameras] canvas.scene');
  await scene.scrollIntoViewIfNeeded();
  const { x, y, width, height } = await scene.boundingBox();
  await tab.mouse.click(x + width / 4, y + height / 4);
  const isThere = () => Math.abs(globalThis.Live.opened['two-cameras'].run.now['target x'] + 3.5) < 0.1;
  await tab.waitForFunction(isThere);
});

test('four machines jump as high as the first program prints, and who passes the ledge stands on it', async () => {
  const list = values => Object.values(values);
  // With how high each jumper was drawn at most, and who is on the ledge in the end.
  const heights = async (query, wanted, stands) => {
    const now = await end('four-machines', query);
    list(now.highest).forEach((height, i) =>
      assert.ok(Math.abs(height - wanted[i]) < 6e-6, `${query}: ${height}, not ${wanted[i]}`),
    );
    assert.deepEqual(list(now.stands), stands, query);
    list(now.y).forEach((y, i) => assert.equal(y, stands[i] * now.ledge, `${query}: ${y}`));
  };
  await heights('', [1.40113, 1.35867, 1.31621, 1.29163], [1, 1, 0, 0]);
  await heights('method=fixed', [1.31507, 1.31621, 1.31621, 1.31611], [0, 0, 0, 0]);
  assert.deepEqual(list((await end('four-machines', 'method=follow&late=d')).stands), [1, 1, 0, 1]);
  assert.deepEqual(list((await end('four-machines', 'late=all&at=0.35')).stands), [1, 1, 1, 1]);
  assert.deepEqual(list((await end('four-machines', 'late=all&method=fixed')).stands), [0, 0, 0, 0]);
  await heights('method=follow&late=none&ledge=1.3', [1.40113, 1.35867, 1.31621, 1.29163], [1, 1, 1, 0]);
});

test('a runner leaps in his newest state, is a step late when blended, and is in the wall when extrapolated', async () => {
  for (const [rate, speed] of [
    [20, 3],
    [60, 3],
    [10, 6],
  ]) {
    const { t, frames, still, behind, beyond } = await end('runner', `rate=${rate}&speed=${speed}`);
    const way = speed / rate;
    const said = JSON.stringify({ rate, speed, t, frames, still, behind, beyond });
    assert.ok(Math.abs(frames - 144 * t) < 1e-6 && Math.abs(frames - still - rate * t) < 1, said);
    assert.ok(Math.abs(behind / way - 1) < 1e-9 && beyond > 0.2 * way && beyond < way, said);
    const off = await tab.evaluate(() => {
      const { trace } = globalThis.Live.opened.runner.run;
      return ['newest', 'blended', 'extrapolated'].map(name => Math.max(...trace[`${name} off`]));
    });
    assert.ok(
      off[0] < 1 + 1e-9 && Math.abs(off[1] - 1) < 1e-9 && Math.abs(off[2] - (2 * beyond) / way) < 1e-9,
      `${off}`,
    );
  }
});

test('the term with half a h squared is exact without air, and worse than Euler in air', async () => {
  const error = async (air, method) => (await end('thrown-ball', `air=${air}&method=${method}&rate=20`)).error;
  assert.ok((await error('none', 'constant_acceleration')) < 1e-12);
  const h = 1 / 20,
    g = 9.81;
  assert.ok(Math.abs((await error('none', 'euler')) - (g * h * 2) / 2) < 1e-9);
  assert.ok((await error('drag', 'constant_acceleration')) > (await error('drag', 'euler')));
});

test('in the race each method ends as the front page says, and the true shuttle flies as it is thrown', async () => {
  const now = await end('race', '');
  assert.deepEqual([...now.crashed], [0, 0, 0, 0, 1, 1, 0, 0]);
  assert.ok(now['euler length'] > 3, `${now['euler length']}`);
  assert.ok(Math.abs(now['rk4 length'] - 0.8) < 0.01, `${now['rk4 length']}`);
  assert.ok(Math.abs(now['heun length'] - 2.7) < 0.1, `${now['heun length']}`);
  const dearer = await end('race', 'price=60');
  const [rk4, ...others] = ['rk4', 'euler', 'midpoint', 'heun', 'velocity_verlet', 'symplectic_euler'].map(
    name => dearer[`${name} error`],
  );
  assert.ok(rk4 < 0.5 && others.every(error => error > 2 * rk4), `${rk4} ${others}`);
  // On a circle of five metres: mu is ten cubed times the square of a turn's 2 pi over 8 s.
  const round = await end('race', `throw%20y=${Math.sqrt((1000 * (Math.PI / 4) ** 2) / 5)}`);
  assert.ok(Math.abs(Math.hypot(round['true x'], round['true y']) - 5) < 1e-9);
  // Thrown aside, too, its ellipse goes through its start; two of the 120 points are less than half a metre apart.
  const aside = await end('race', 'throw%20x=3&throw%20y=9');
  const near = Math.min(...[...aside['path x']].map((x, i) => Math.hypot(x - 5, aside['path y'][i])));
  assert.ok(near < 0.25, `${near}`);
});

test('a dot under its line dies away, one above it grows, and the line is where the chapters have it', async () => {
  const root = Math.sqrt(2);
  for (const [name, method, zeta, limit] of [
    ['spring-limit', '', 0.3, 0.6],
    ['spring-limit', '', 1.5, 2 * (1.5 - Math.sqrt(1.25))],
    ['rk4-limits', 'method=rk4&', 0, 2 * root],
    ['damped', 'method=symplectic_euler&', 1, 2 * (root - 1)],
    ['damped', 'method=linear_damping_implicit_last&', 0.5, 2 * (Math.sqrt(1.25) + 0.5)],
  ]) {
    const under = await end(name, `${method}zeta=${zeta}&homega=${limit - 0.01}`);
    const over = await end(name, `${method}zeta=${zeta}&homega=${limit + 0.01}`);
    assert.ok(under.factor < 1 && over.factor > 1, `${name}: ${under.factor} ${over.factor}`);
    const zetas = [...under.zetas];
    const edge = [...under[`${method.slice(7, -1) || 'euler'} edge`]];
    const at = zetas.findIndex(one => Math.abs(one - zeta) < 1e-9);
    if (at >= 0) assert.ok(Math.abs(edge[at] - limit) < 1e-3, `${name}: ${edge[at]} instead of ${limit}`);
  }
});
