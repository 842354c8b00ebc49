// What needs no browser, in one process, which reads each page once:  node files.test.mjs BUILD SOURCE
const NAMES = [
  'links',
  'cards',
  'edition',
  'colours',
  'cast',
  'ticks',
  'figure-scripts',
  'readme-figure',
  'terms',
  'head',
];
for (const name of NAMES) await import(`./${name}.test.mjs`);
