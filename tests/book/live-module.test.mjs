// The compiled figures: small, in need of nothing, loaded where they are wanted only, and in the browser to the bit what they are here.
//   node live-module.test.mjs BUILD [others]
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { gzipSync } from 'node:zlib';
import { STEPS, cases } from '../../book/live/cases.mjs';
import { build, folder, pages, read } from './book.mjs';
import { openTab, visit } from './browser.mjs';
import { figures, module } from './live.mjs';

const scripts = page => [...read(page).matchAll(/<script\b[^>]* src="([^"]*)"/g)].map(([, src]) => src);
const isLive = page => /<\w[^>]* data-live="/.test(read(page));

test('the module needs nothing from outside but the step that a reader writes', async () =>
  assert.deepEqual(WebAssembly.Module.imports(await WebAssembly.compile(module)), [
    { module: 'reader', name: 'step', kind: 'function' },
  ]));

test('what a page loads of the module, compressed and in Base64, has less than 5 kB for each figure', () => {
  const { length } = gzipSync(module).toString('base64');
  assert.ok(length < 5e3 * figures.length, `${length} bytes for ${figures.length} figures`);
});

test('a page loads the live scripts if it has a live figure, and only then', () => {
  for (const page of pages)
    assert.equal(
      scripts(page).some(src => src.startsWith('live/')),
      isLive(page),
      page,
    );
  assert.ok(pages.some(isLive));
});

test('all scripts of a page have less than 400 kB', () => {
  for (const page of pages.filter(isLive)) {
    const bytes = scripts(page).reduce((sum, src) => sum + readFileSync(join(folder, src)).length, 0);
    assert.ok(bytes < 400e3, `${page}: ${bytes} bytes`);
  }
});

test('numbers are written as in the book', async () => {
  const { Live } = (await import('../../book/live/page/words.js'), globalThis);
  const fixed = [
    [1.25, 1, '1.3'],
    [-0.04, 1, '0.0'],
    [-0.05, 2, '\u22120.05'],
    [9999, 0, '9999'],
    [12345.6, 1, '12\u202f345.6'],
    [-1234567, 0, '\u22121.2 × 10⁶'],
    [4.13e12, 2, '4.1 × 10¹²'],
  ];
  for (const [value, digits, text] of fixed) assert.equal(Live.fixed(value, digits), text);
  const metres = [
    [1, '1.0 m'],
    [0.72, '72 cm'],
    [0.0078, '7.8 mm'],
    [3e-7, '300 nm'],
    [41335, '41\u202f335 m'],
  ];
  for (const [value, text] of metres) assert.equal(Live.metres(value).replace(/\u202f(?=[a-zµ])/, ' '), text);
});

test('the choices on the page are those of the program', async () => {
  const { Live } = (await import('../../book/live/page/module.js'), globalThis);
  for (const { name, controls, handle, frames } of figures) {
    const { own, ...settings } = (await Live.open(await WebAssembly.compile(module), name)).settings;
    const offered = Object.keys(controls.find(({ chips }) => chips)?.choices ?? {});
    assert.deepEqual(
      offered.filter(mistake => !own.includes(mistake)),
      [],
      name,
    );
    const computed = controls.filter(({ page, chips }) => !page && !chips);
    const described = Object.fromEntries(computed.map(control => [control.name, Object.keys(control.choices ?? {})]));
    for (const { set } of handle ? [handle.x, handle.y] : []) if (set) described[set] = [];
    if (frames) described[frames] = [];
    assert.deepEqual(described, settings, name);
  }
});

test('one step looks where its method says, and ends where its formula does', async () => {
  const { Live } = globalThis;
  const code = await WebAssembly.compile(module);
  const [omega, h, r] = [Math.PI / 4, 0.7, 10];
  const w = h * omega;
  const near = (value, wanted) => assert.ok(Math.abs(value - wanted) < 1e-9, `${value}, not ${wanted}`);
  for (const [name, times, x, y] of [
    ['tangent', [0], r, r * w],
    ['midpoint-step', [0, h / 2], r * (1 - w ** 2 / 2), r * w],
    ['four-looks', [0, h / 2, h / 2, h], r * (1 - w ** 2 / 2 + w ** 4 / 24), r * (w - w ** 3 / 6)],
    ['from-the-end', [h], r / (1 + w ** 2), (r * w) / (1 + w ** 2)],
  ]) {
    const opened = await Live.open(code, name);
    opened.set('step', h);
    const now = opened.start();
    assert.deepEqual(
      [now['look t']].flatMap(one => (one.length ? [...one] : [one])),
      times,
      name,
    );
    assert.equal(now.seconds, times.length + 1);
    near(now['end x'], x);
    near(now['end y'], y);
    near(now.error, Math.hypot(x - r * Math.cos(w), y - r * Math.sin(w)));
  }
});

// What the build compared them with: all runs, or the first of each choice, with its sliders where they stand.
const all = cases();
const native = readFileSync(join(build, 'weave/live/same-bits.txt'), 'utf8')
  .split('\n')
  .flatMap(line => line.match(/ ([0-9a-f]{16}) [0-9a-f]{16} same$/)?.[1] ?? []);
const asked = [...all.keys()].filter(i => (i % 3 === 0) !== process.argv.includes('others'));

test(`${STEPS} steps of every figure have the same bits in Chromium as in the native program`, async () => {
  assert.equal(native.length, all.length);
  const tab = await openTab();
  await visit(tab, figures[0].page);
  const browser = await tab.evaluate(
    async ([runs, steps]) => {
      const compiled = await Live.compile(Live.compiled);
      const found = [];
      for (const { figure, settings } of runs) {
        const opened = await Live.open(compiled, figure);
        for (const [name, value] of Object.entries(settings)) opened.set(name, value);
        found.push(opened.fingerprint(steps));
      }
      return found;
    },
    [asked.map(i => all[i]), STEPS],
  );
  const said = (i, bits) => `${all[i].figure} ${JSON.stringify(all[i].settings)} ${bits}`;
  assert.deepEqual(
    asked.map((i, n) => said(i, browser[n])),
    asked.map(i => said(i, native[i])),
  );
});
