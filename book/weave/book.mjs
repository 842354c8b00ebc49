// Everything the weaver knows, read from the sources and from what the chapters' programs wrote.
import { existsSync, readdirSync } from 'node:fs';
import { dirname, join, relative } from 'node:path';
import { readCards } from './cards.mjs';
import { readPromises } from './promises.mjs';
import { readClaims } from './claims.mjs';
import { readMadeChanges } from './change-box.mjs';
import { readFilms } from './films.mjs';
import { readLive } from './live.mjs';
import { readAllTimes } from './measured-times.mjs';
import { readNumbers } from './numbers.mjs';
import { readPage } from './page.mjs';
import { createProblems } from './problems.mjs';
import { createSnippets } from './snippets.mjs';
import { readTables } from './tables.mjs';
import { readWords } from './words.mjs';
import { slug } from './text.mjs';

// The folder of the start page, its program and its figures, among the chapters'. A chapter's has a number in front; any other is a
// page behind the chapters.
const OPENING = 'front';

// The pages before and after the chapters, book/NAME.md each.
const BEFORE = ['preface'];
const AFTER = ['checked', 'talks', 'teaching', 'glossary', 'references'];

// What a chapter has measured, told in short at the book's beginning.
const IN_SHORT = ['two-minutes'];

// The pages beside a chapter, for whoever wants more of one of its things: each Markdown file that lies beside chapter.md.
const besideChapter = (source, folder) =>
  (existsSync(join(source, folder)) ? readdirSync(join(source, folder)) : [])
    .filter(file => file.endsWith('.md') && file !== 'chapter.md')
    .map(file => file.slice(0, -3))
    .sort();

// All but what lies beside the way through the book.
export const onTheWay = ({ isAside, beside }) => !isAside && !beside;

// The pages before and after one, on the way.
export const pagesAround = ({ pages }, { order, isAside }) =>
  isAside ? {} : { previous: pages.slice(0, order).findLast(onTheWay), next: pages.slice(order + 1).find(onTheWay) };

export function readBook(config) {
  const problems = createProblems();
  const sources = findSources(config);
  const book = {
    config,
    problems,
    chapters: new Map(),
    programs: new Map(),
    pages: [],
    labels: new Map(),
    references: new Map(),
    claims: new Map(),
    sources,
    words: readWords(config),
    cards: readCards(config.cards, problems),
    promises: readPromises(config.shelf, problems),
    times: readAllTimes(config.times, problems),
    live: readLive(config, problems),
    snippet: createSnippets(config.source, sources),
    short: path => relative(config.source, path),
  };
  for (const entry of config.chapters) {
    const chapter = readChapter(book, entry);
    book.programs.set(chapter.name, chapter);
    if (chapter.number) book.chapters.set(chapter.name, chapter);
  }
  readPages(book);
  book.title = book.pages[0].title;
  for (const chapter of book.programs.values()) registerClaims(book, chapter);
  return book;
}

// Files that get a page of their own: what is compiled, and what draws.
function findSources({ source }) {
  const found = new Set();
  const walk = (folder, only) => {
    const entries = existsSync(join(source, folder)) ? readdirSync(join(source, folder), { withFileTypes: true }) : [];
    for (const entry of entries.sort((a, b) => a.name.localeCompare(b.name))) {
      const path = `${folder}/${entry.name}`;
      if (entry.isDirectory()) walk(path, only);
      else if (only ? only.includes(entry.name) : /\.(h|hpp|cpp|gp)$/.test(entry.name)) found.add(path);
    }
  };
  for (const folder of ['code', 'chapters', 'book/theme', 'book/live']) walk(folder);
  walk('exercises', ['starter.h', 'given.h']); // the tests work out what a student is asked for
  return found;
}

function readChapter(book, { name, folder, build }) {
  const { source } = book.config;
  const program = join(build, 'program');
  const numbersFile = join(build, 'data', 'numbers.csv');
  if (!existsSync(numbersFile))
    book.problems.add(
      `${folder}/program.cpp`,
      1,
      `the program has not written ${book.short(numbersFile)}; build the chapter first`,
    );
  const claims = readClaims(join(build, 'claims.xml'), {
    source,
    build: dirname(book.config.output),
    command: book.short(join(build, 'claims')),
  });
  if (claims.fault) book.problems.add(`${folder}/claims.cpp`, 1, claims.fault);
  const figures = new Map(
    (existsSync(join(source, folder)) ? readdirSync(join(source, folder)) : [])
      .filter(file => file.endsWith('.gp'))
      .sort()
      .map(file => {
        const figure = file.slice(0, -3);
        const drawn = suffix => join(build, 'figures', `${figure}${suffix}.svg`);
        return [figure, { name: figure, script: `${folder}/${file}`, wide: drawn(''), narrow: drawn('-narrow') }];
      }),
  );
  return {
    name,
    folder,
    number: Number(name.match(/^\d+/)),
    href: `${name}.html`,
    program: `${folder}/program.cpp`,
    command: book.short(program),
    data: join(build, 'data'),
    films: readFilms(source, folder, build),
    changes: readMadeChanges(build),
    numbers: readNumbers(numbersFile),
    tables: readTables(join(build, 'data')),
    tests: claims.tests,
    figures,
  };
}

function readPages(book) {
  const { source } = book.config;
  const add = (file, about) => {
    const page = readPage(join(source, file), {
      file,
      order: book.pages.length,
      exercises: join(source, 'exercises'),
      problems: book.problems,
      ...about,
    });
    book.pages.push(page);
    return page;
  };
  const addAround = name => add(`book/${name}.md`, { name, href: `${name}.html` });
  const start = add(`chapters/${OPENING}/chapter.md`, { name: 'index', href: 'index.html', owner: OPENING });
  const addBeside = ({ folder, name: owner }, wanted) =>
    besideChapter(source, folder)
      .filter(wanted)
      .map(name => add(`${folder}/${name}.md`, { name, href: `${name}.html`, owner }));
  for (const program of book.programs.values()) addBeside(program, name => IN_SHORT.includes(name));
  BEFORE.forEach(addAround);
  for (const chapter of book.chapters.values()) {
    chapter.page = add(`${chapter.folder}/chapter.md`, { ...chapter, owner: chapter.name });
    chapter.title = chapter.page.title;
    for (const page of addBeside(chapter, name => !IN_SHORT.includes(name))) page.beside = chapter;
  }
  for (const program of book.programs.values()) {
    if (program.number) continue;
    if (program.name === OPENING) Object.assign(program, { page: start, title: 'The start page', href: start.href });
    else {
      program.page = add(`${program.folder}/chapter.md`, {
        name: program.name,
        href: program.href,
        owner: program.name,
      });
      program.title = program.page.title;
      addBeside(program, name => !IN_SHORT.includes(name));
    }
  }
  AFTER.forEach(addAround);
  // Not on the way through the book: the page about this copy leads there.
  add('CHANGELOG.md', { name: 'changelog', href: 'changelog.html' }).isAside = true;
}

function registerClaims(book, chapter) {
  for (const test of chapter.tests) {
    const other =
      book.claims.get(test.name) ?? [...book.claims.values()].find(claim => slug(claim.test.name) === slug(test.name));
    if (other)
      book.problems.add(
        test.file,
        test.line,
        `the test name "${test.name}" is taken by ${other.test.file}:${other.test.line}; names are unique in the book, by their letters and digits`,
      );
    else book.claims.set(test.name, { test, chapter, cited: [] });
  }
}
