// The films: pages of their own, each written by a program play*.cpp of a chapter, and shown in the chapter.
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { copyChangeFilms } from './change-box.mjs';
import { isCompiledInPage } from './page-sources.mjs';
import { readPictures, stillHtml } from './film-still.mjs';
import { otherColours, readLooks } from './method-looks.mjs';
import { nameOneOf } from './problems.mjs';
import { isMark } from './snippets.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml, smarten } from './text.mjs';

const figureScript = fileURLToPath(new URL('../theme/figure.gp', import.meta.url));

// { play: { name, source, page, prints, shape } } of a chapter: its programs that make a film, where the film is, and what they print.
export function readFilms(source, folder, build) {
  const there = join(source, folder);
  const programs = (existsSync(there) ? readdirSync(there) : []).filter(file => /^play\w*\.cpp$/.test(file)).sort();
  return new Map(
    programs.map(file => {
      const name = file.slice(0, -4);
      return [
        name,
        {
          name,
          source: `${folder}/${file}`,
          page: join(build, 'films', `${name}.html`),
          prints: join(build, 'films', `${name}.txt`),
        },
      ];
    }),
  );
}

export function checkFilm({ book, page, piece, report }) {
  const { films = new Map(), folder } = book.programs.get(page.owner) ?? {};
  piece.film = films.get(piece.program);
  if (!piece.film) {
    report(
      `there is no ${folder}/${piece.program}.cpp that makes the film "${piece.program}".${nameOneOf(piece.program, films.keys())}`,
    );
    return;
  }
  piece.film.shown = true;
  piece.film.title = piece.args[1];
  if (!existsSync(piece.film.page)) report(`${piece.film.source} has not made its film; is the chapter built?`);
}

// All of a program that makes a film stands in its chapter, cut into listings, but for its licence and its heading.
export function checkPrograms(book) {
  for (const { films, page } of book.programs.values()) {
    for (const film of films.values()) {
      if (!film.shown)
        book.problems.add(film.source, 1, `no \\film{${film.name}, Title} in ${page.file} shows this film`);
      const shown = new Set(
        page.pieces
          .filter(piece => piece.name === 'listing' && piece.args[0] === film.source)
          .flatMap(piece => piece.snippet?.lines ?? [])
          .map(({ number }) => number),
      );
      const lines = readFileSync(join(book.config.source, film.source), 'utf8').split('\n');
      lines.forEach((line, i) => {
        if (line.trim() && !isMark(line) && !shown.has(i + 1) && !/^\/\/ /.test(line))
          book.problems.add(film.source, i + 1, `no \\listing of ${page.file} shows this line`);
      });
    }
  }
}

// What a program prints, but for where its film is.
export const printsOf = film =>
  existsSync(film.prints)
    ? readFileSync(film.prints, 'utf8')
        .replace(/^Open .*\n/m, '')
        .trim()
    : null;

// A fence `prints` quotes one of the chapter's programs to the letter; in "Change it" stands what a changed one prints.
export function checkPrints(book) {
  for (const { films, page } of book.programs.values()) {
    const printed = new Map([...films.values()].map(film => [printsOf(film), film.name]));
    for (const piece of page.pieces) {
      const quotes = piece.name === 'fence' && piece.language === 'prints' && piece.box?.name !== 'change';
      if (!quotes) continue;
      piece.printedBy = printed.get(piece.code.trim());
      if (piece.printedBy) continue;
      const files = [...films.keys()].map(name => `${name}.txt`).join(', ');
      book.problems.add(page.file, piece.line, `no program of the chapter prints this; they print films/${files}`);
    }
  }
}

const fileName = (page, film) => `films/${page.name}-${film.name}.html`;

// As high as its pictures want, and the slider below them; and the still, which stands for it on paper and without scripts.
export function filmHtml(page, { film, args: [, title] }, book) {
  const { config } = book;
  const words = escapeHtml(smarten(title));
  const pictures = readPictures(readFileSync(film.page, 'utf8'));
  const [left, bottom, right, top] = pictures.view;
  const href = fileName(page, film);
  const still = stillHtml(pictures, coloursOf(config), words);
  const edited = config.compiler && !isCompiledInPage(book, film.source) ? '' : ` data-source="${film.source}"`;
  const html =
    `<div class="film" style="--shape:${((right - left) / (top - bottom)).toFixed(3)}">` +
    `<iframe src="${href}" data-program="${film.name}"${edited} title="${words}" loading="lazy"></iframe>${still}</div>`;
  return { html, still, href };
}

// The N of --plot-N for each name that a program calls a colour by.
function coloursOf({ methods }) {
  const others = new Map(otherColours(readFileSync(figureScript, 'utf8')));
  const looks = readLooks(join(methods, 'methods.csv')).map(({ name, colour }) => [name, colour]);
  return new Map([...looks, ['true', others.get('EXACT')], ['scenery', others.get('CONTEXT')]]);
}

export const filmSources = (page, { film }) =>
  `<p class="sources">Made by <a href="${sourceHref(film.source)}">${film.source.split('/').pop()}</a>. <a href="${fileName(page, film)}">By itself</a></p>`;

export function copyFilms(book, out) {
  mkdirSync(join(out, 'films'), { recursive: true });
  for (const { films, page } of book.programs.values())
    for (const film of films.values()) writeFileSync(join(out, fileName(page, film)), inTheBook(film));
  mkdirSync(join(out, 'changes'), { recursive: true });
  for (const page of book.pages) copyChangeFilms(page, out);
}

// The page of a film with the title of its figure, and in the book's letters.
export const inTheBook = ({ page, title }) =>
  readFileSync(page, 'utf8').replace(
    /<title>.*<\/title>/,
    () =>
      `<title>${escapeHtml(smarten(title))}</title>\n<style>@font-face { font-family: "Book Sans"; font-weight: 100 900; src: url(../fonts/inter-latin-wght-normal.woff2) }</style>`,
  );
