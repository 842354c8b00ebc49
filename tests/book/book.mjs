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

export const pages = readdirSync(folder)
  .filter(file => file.endsWith('.html'))
  .sort();

const parsed = new Map();

export function parse(page) {
  if (!parsed.has(page)) parsed.set(page, cheerio.load(readFileSync(join(folder, page), 'utf8')));
  return parsed.get(page);
}

export const kind = page => parse(page)('body').attr('class');
export const chapters = pages.filter(page => kind(page) === 'chapter');

// The words that a reader reads: no code, no formulas, no pictures.
export function prose(page) {
  const main = parse(page)('main').clone();
  main.find('code, pre, .katex, svg, nav').remove();
  main.find('*').append(' ');
  return main.text();
}
