// The built book as files. Every test is called with the build tree as its first argument.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join, resolve } from 'node:path';
import * as cheerio from 'cheerio';

export const build = resolve(process.argv[2] ?? 'build');
export const folder = join(build, 'book');
if (!existsSync(join(folder, 'index.html'))) {
  console.error(`There is no book in ${folder}; build it first: cmake --workflow --preset book`);
  process.exit(1);
}

// Not that of an old address, which leads on at once.
export const pages = readdirSync(folder)
  .filter(file => file.endsWith('.html') && file !== 'wall.html')
  .sort();

const texts = new Map();

export function read(page) {
  if (!texts.has(page)) texts.set(page, readFileSync(join(folder, page), 'utf8'));
  return texts.get(page);
}

const parsed = new Map();

export function parse(page) {
  if (!parsed.has(page)) parsed.set(page, cheerio.load(read(page)));
  return parsed.get(page);
}

// Read and not parsed: a test that needs a few pages need not wait for all.
export const kind = page => read(page).match(/^<body class="([^"]*)"/m)?.[1];
export const chapters = pages.filter(page => kind(page) === 'chapter');

// The words that a reader reads: no code, no formulas, no pictures.
export function prose(page) {
  const main = parse(page)('main').clone();
  main.find('code, pre, .katex, svg, nav, script, template').remove();
  main.find('*').append(' ');
  return main.text();
}
