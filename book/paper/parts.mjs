// The pages that the whole book is made of, read from the woven ones.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import * as cheerio from 'cheerio';

// Lists of what stands elsewhere, to look things up on a screen.
const LISTS = ['snippets.html', 'exercises.html', 'claims.html', 'reference.html'];

// { version, address, parts: [{ href, name, kind, number, title, $ }] }: the front page, and then in the order of its menu the
// pages that are read. `address` is where the book will be found, or ''.
export function readParts(book) {
  const front = load(book, 'index.html');
  const menu = front('nav.side .toc a')
    .get()
    .map(a => ({ href: front(a).attr('href'), number: front(a).find('.no').text() }))
    .filter(({ href }) => !LISTS.includes(href));
  const parts = [{ href: 'index.html', number: '', $: front }, ...menu].map(part => readPart(book, part));
  return {
    version: front('main > footer')
      .text()
      .match(/\d+\.\d+\.\d+/)[0],
    address: front('link[rel=canonical]').attr('href') ?? '',
    parts,
  };
}

function readPart(book, { href, number, $ = load(book, href) }) {
  $('main h1 .kicker').remove();
  return {
    href,
    number,
    name: href.replace('.html', ''),
    kind: $('body').attr('class'),
    title: $('main h1').text().trim(),
    $,
  };
}

const load = (book, href) => cheerio.load(readFileSync(join(book, href), 'utf8'));
