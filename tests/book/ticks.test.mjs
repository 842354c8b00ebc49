// The numbers on the axes of every figure stand where they belong.
import assert from 'node:assert/strict';
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { build } from './book.mjs';
import { quantities } from './quantities.mjs';
import { checkTicks } from './ticks.mjs';

const chapters = join(build, 'chapters');
const folders = readdirSync(chapters)
  .map(chapter => join(chapters, chapter, 'figures'))
  .filter(existsSync);
const figures = folders.flatMap(folder =>
  readdirSync(folder)
    .filter(file => file.endsWith('.svg'))
    .map(file => join(folder, file.slice(0, -4))),
);
let read = 0;

for (const figure of figures) {
  test(figure.slice(chapters.length + 1), () => {
    const { labels, faults } = checkTicks(
      readFileSync(`${figure}.svg`, 'utf8'),
      JSON.parse(readFileSync(`${figure}.axes.json`, 'utf8')),
    );
    assert.ok(!faults.length, faults.join('\n'));
    read += labels;
  });
}

test('most figures have numbers on both axes', () =>
  assert.ok(read > 5 * figures.length, `${read} numbers on ${figures.length} figures`));

test('labels are read', () => {
  const value = label => quantities(label).map(quantity => quantity.value);
  const labels = {
    '1': [1],
    ' 0.5': [0.5],
    '−2': [-2],
    '10^{-3}': [1e-3],
    '−10^{4}': [-1e4],
    '10⁻³': [1e-3],
    '5×10^{6}': [5e6],
    '12 000': [12000],
    '10,000': [10000],
    'π': [Math.PI],
    '−2π': [-2 * Math.PI],
    'π/2': [Math.PI / 2],
    '3π/2': [(3 * Math.PI) / 2],
    '1/512': [1 / 512],
    '10 cm': [0.1],
    '1 m, 1 m/s': [1, 1],
    '20 %': [0.2],
    'Jupiter': [],
  };
  for (const [label, values] of Object.entries(labels)) assert.deepEqual(value(label), values, label);
});

// A row of labels below an axis that gnuplot would draw from x = 100 to x = 500.
function sketch(ticks) {
  const tick = ([at, label]) =>
    `<g><path d='M${at},300 L${at},306  '/><g transform="translate(${at},330)" font-size="15.00" text-anchor="middle"><text>${label}</text></g></g>`;
  const y = { min: 0, max: 1, pixel_min: 300, pixel_max: 50 };
  const x = { min: 20, max: 200000, pixel_min: 100, pixel_max: 500 };
  return checkTicks(`<svg xmlns="http://www.w3.org/2000/svg">${ticks.map(tick).join('')}</svg>`, { x, y });
}
const power = n => `<tspan>10</tspan><tspan font-size="12.0" dy="-7.50px">${n}</tspan><tspan dy="7.50"></tspan>`;

test('a good logarithmic axis passes', () => {
  assert.deepEqual(
    sketch([
      [169.9, power(2)],
      [269.9, power(3)],
      [369.9, power(4)],
    ]),
    { labels: 3, faults: [] },
  );
});

test('gnuplot\'s "set xtics 10" on a logarithmic axis, which starts in the wrong place, is caught', () => {
  assert.equal(
    sketch([
      [200, power(2)],
      [300, power(3)],
      [400, power(4)],
    ]).faults.length,
    3,
  );
});

test('a single label in a wrong place is caught', () => {
  assert.deepEqual(
    sketch([
      [169.9, power(2)],
      [269.9, power(3)],
      [371.9, power(4)],
    ]).faults,
    ['x axis: "10^{4}" stands at 371.9, its value belongs to 369.9'],
  );
});

// Two panels side by side, on axes from 0 to 1: one counts from 0 to 10, the other from 0 to 100.
function panels(second) {
  const label = (at, written) =>
    `<g transform="translate(${at},310)" font-size="15.00" text-anchor="middle"><text>${written}</text></g>`;
  const x = { min: 0, max: 1, pixel_min: 100, pixel_max: 500 };
  const y = { min: 0, max: 1, pixel_min: 300, pixel_max: 50 };
  const panel = (left, right, to) => ({ left, right, bottom: 0, top: 1, x: [0, to], y: [0, 1] });
  return checkTicks(
    `<svg xmlns="http://www.w3.org/2000/svg">${label(190, '5')}${label(280, '10')}${label(410, second)}</svg>`,
    { x, y, panels: [panel(0, 0.45, 10), panel(0.55, 1, 100)] },
  );
}

test('each panel of a figure has its own axes', () => {
  assert.deepEqual(panels('50'), { labels: 3, faults: [] });
  assert.deepEqual(panels('5').faults, ['x axis: "5" stands at 410.0, its value belongs to 329.0']);
});
