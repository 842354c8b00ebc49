// The films: pages of their own, each written by a program play*.cpp of a chapter, and shown in the chapter.
import { copyFileSync, existsSync, mkdirSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { nameOneOf } from './problems.mjs';
import { isMark } from './snippets.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml, smarten } from './text.mjs';

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
const printsOf = film =>
  existsSync(film.prints)
    ? readFileSync(film.prints, 'utf8')
        .replace(/^Open .*\n/m, '')
        .trim()
    : null;

// A fence `prints` quotes one of the chapter's programs to the letter; in "Change it" stands what a changed one prints, which
// the tests compile.
export function checkPrints(book) {
  for (const { films, page } of book.programs.values()) {
    const printed = [...films.values()].map(printsOf);
    for (const piece of page.pieces) {
      const quotes = piece.name === 'fence' && piece.language === 'prints' && piece.box?.name !== 'change';
      if (!quotes || printed.includes(piece.code.trim())) continue;
      const files = [...films.keys()].map(name => `${name}.txt`).join(', ');
      book.problems.add(page.file, piece.line, `no program of the chapter prints this; they print films/${files}`);
    }
  }
}

const fileName = (page, film) => `films/${page.name}-${film.name}.html`;

// As high as its pictures want, and the slider below them.
function shapeOf(film) {
  const [left, bottom, right, top] = readFileSync(film.page, 'utf8')
    .match(/const view = \[([^\]]*)\]/)[1]
    .split(',')
    .map(Number);
  return (right - left) / (top - bottom);
}

export function filmHtml(page, { film, args: [, title] }) {
  const words = escapeHtml(smarten(title));
  return `<div class="film" style="--shape:${shapeOf(film).toFixed(3)}"><iframe src="${fileName(page, film)}" title="${words}" loading="lazy"></iframe></div>`;
}

export const filmSources = (page, { film }) =>
  `<p class="sources">Made by <a href="${sourceHref(film.source)}">${film.source.split('/').pop()}</a>. <a href="${fileName(page, film)}">By itself</a></p>`;

export function copyFilms(book, out) {
  mkdirSync(join(out, 'films'), { recursive: true });
  for (const { films, page } of book.programs.values())
    for (const film of films.values()) copyFileSync(film.page, join(out, fileName(page, film)));
}
