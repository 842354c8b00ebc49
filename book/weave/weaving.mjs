// Weaves a book, from its sources to its pages on the disk.
import { existsSync, mkdirSync, readFileSync, readdirSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { join, relative } from 'node:path';
import { readApi } from './api.mjs';
import { copyAssets } from './assets.mjs';
import { pagesAround, readBook } from './book.mjs';
import { checkCards } from './cards.mjs';
import { checkPromises } from './promises.mjs';
import { checkBook, checkReferencesToCode } from './check.mjs';
import { aboutPage, lostPage } from './about-page.mjs';
import { claimsPage } from './claims-page.mjs';
import { runDoxygen } from './doxygen.mjs';
import { exercisesPage } from './exercises-page.mjs';
import { checkLinks } from './links.mjs';
import { referencePages } from './reference-pages.mjs';
import { sitemap } from './head.mjs';
import { renderPage } from './render.mjs';
import { claimDocuments, codeDocuments, madeDocuments, proseDocuments, searchScript } from './search.mjs';
import { snippetsPage } from './snippets-page.mjs';
import { slidesPages } from './slides-pages.mjs';
import { sourcePages } from './source-pages.mjs';
import { stopwatch, summary } from './summary.mjs';
import { pageHtml } from './template.mjs';

// A book that is not woven: the message has all that is to be mended.
export class Faults extends Error {}

// Returns a few lines about the book; throws Faults. `config` is what book/CMakeLists.txt writes.
export function weave(config) {
  const watch = stopwatch();
  const book = watch('check', () => {
    const read = readBook(config);
    checkBook(read);
    return read;
  });
  giveUpOn(book);
  const xml = watch('Doxygen', () => runDoxygen(book));
  giveUpOn(book);
  book.api = readApi(xml, config.source);
  checkReferencesToCode(book);
  checkCards(book);
  checkPromises(book);
  giveUpOn(book);
  const { pages, documents } = watch('pages', () => makePages(book));
  giveUpOn(book);
  watch('write', () => writeBook(book, pages, documents));
  giveUpOn(book);
  return summary(book, pages, watch);
}

function giveUpOn({ problems, config }) {
  if (!problems.any) return;
  const n = problems.list.length;
  const old = existsSync(config.output) ? 'The book of the last build stays as it was.' : '';
  throw new Faults(`${problems.text()}The book is not woven: ${n} ${n === 1 ? 'mistake' : 'mistakes'} to mend. ${old}`);
}

const kickerOf = ({ number, beside }) =>
  number ? `Chapter ${number}` : beside ? `Beside chapter ${beside.number}` : '';

function makePages(book) {
  const documents = [];
  const prose = book.pages.map(page => {
    const { html, places } = renderPage(book, page);
    documents.push(...proseDocuments(page, places));
    page.words = places.reduce((sum, { text }) => sum + text.split(/\s+/).filter(Boolean).length, 0);
    return {
      href: page.href,
      file: page.file,
      title: page.title,
      number: page.number,
      kind: page.number ? 'chapter' : page.name,
      body: html,
      kicker: kickerOf(page),
      ...pagesAround(book, page),
      sections: places.filter(({ level }) => level === 2).map(({ id, title }) => ({ id, title })),
    };
  });
  const [snippets, exercises, about] = [snippetsPage(book), exercisesPage(book), aboutPage(book)];
  documents.push(
    ...madeDocuments(snippets),
    ...madeDocuments(about),
    ...madeDocuments(exercises).slice(0, 1),
    ...codeDocuments(book),
    ...claimDocuments(book),
  );
  const made = [
    claimsPage(book),
    snippets,
    exercises,
    about,
    ...referencePages(book),
    ...sourcePages(book),
    ...slidesPages(book, prose),
    lostPage(book),
  ].map(page => ({
    ...page,
    file: page.kind === 'source' ? page.title : `page ${page.href}`,
  }));
  const pages = [...prose, ...made].map(page => ({ ...page, html: pageHtml(book, page) }));
  return { pages, documents };
}

// Written beside the old book and put in its place only when whole.
function writeBook(book, pages, documents) {
  const { output } = book.config;
  const fresh = `${output}.new`,
    old = `${output}.old`;
  rmSync(fresh, { recursive: true, force: true });
  try {
    mkdirSync(fresh, { recursive: true });
    copyAssets(book, fresh);
    writeFileSync(join(fresh, 'search-index.js'), searchScript(book, documents));
    for (const { href, html } of pages) writeFileSync(join(fresh, href), html);
    if (book.config.url) writeFileSync(join(fresh, 'sitemap.xml'), sitemap(book, pages));
    checkLinks(book, pages, new Set(filesIn(fresh)));
    if (book.problems.any) return;
    rmSync(old, { recursive: true, force: true });
    if (existsSync(output)) renameSync(output, old);
    renameSync(fresh, output);
    rmSync(old, { recursive: true, force: true });
  } finally {
    rmSync(fresh, { recursive: true, force: true });
  }
}

function filesIn(folder, top = folder) {
  return readdirSync(folder, { withFileTypes: true }).flatMap(entry => {
    const path = join(folder, entry.name);
    return entry.isDirectory() ? filesIn(path, top) : [relative(top, path)];
  });
}
