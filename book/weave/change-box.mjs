// The box "Change it": the lines of a program to change, and, made by the build, what they do: the listings with them, what the
// changed program prints, and its film.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { listingCode } from './blocks.mjs';
import { inTheBook, printsOf } from './films.mjs';
import { escapeHtml, slug, smarten } from './text.mjs';

/** What the build made of the changes of a chapter: { name: { name, title, program, edits, page, prints } }. */
export function readMadeChanges(build) {
  const index = join(build, 'changes', 'films.json');
  const changes = existsSync(index) ? JSON.parse(readFileSync(index, 'utf8')) : [];
  const file = (name, kind) => join(build, 'changes', `${name}.${kind}`);
  return new Map(
    changes.map(change => [
      change.name,
      { ...change, page: file(change.name, 'html'), prints: file(change.name, 'txt') },
    ]),
  );
}

/** The box quotes to the letter what the changed program prints. */
export function checkChange({ book, page, piece, report }) {
  const { changes, films } = book.programs.get(page.owner);
  const change = changes.get(slug(piece.args[0]));
  if (!change) {
    report('the program has not been changed so and run; is the chapter built?');
    return;
  }
  piece.change = { ...change, film: films.get(change.program) };
  const quotes = page.pieces.filter(
    ({ name, language, box }) => name === 'fence' && language === 'prints' && box === piece,
  );
  const printed = printsOf(change);
  if (quotes.length !== 1 || quotes[0].code.trim() !== printed)
    report(`the changed program prints ${JSON.stringify(printed)}, which its box should quote`);
}

const addressOf = (page, change) => `changes/${page.name}-${change.name}.html`;

export function changeHtml(html, { change, args: [title] }, context) {
  const { book, page, hold } = context;
  const listings = page.pieces
    .filter(piece => piece.name === 'listing' && piece.args[0] === change.film.source)
    .map(piece => ({ piece, lines: changedLines(piece.snippet.lines, change.edits) }))
    .filter(({ lines }) => lines);
  const templates = listings.map(
    ({ piece, lines }) =>
      `<template data-for="${piece.id}">${hold(listingCode(book, change.film.source, lines))}</template>`,
  );
  return (
    `<div class="change" id="change-${change.name}" data-program="${change.program}" data-film="${addressOf(page, change)}">` +
    `<p class="label">${escapeHtml(smarten(title))}</p>${html}${templates.join('')}</div>`
  );
}

// The lines of a listing with those that a change takes out and puts in; nothing if it touches none of them.
export function changedLines(lines, edits) {
  const at = number => lines.findIndex(line => line.number === number);
  const changed = lines.map(line => ({ ...line }));
  let touched = false;
  for (const { line, rows } of [...edits].reverse()) {
    const numbered = number(rows, line);
    const first = at(numbered.find(({ sign }) => sign !== '+').number);
    if (first < 0) continue;
    touched = true;
    const there = numbered.filter(row => row.sign !== '+');
    const deeper = indentOf(there[0].code) - indentOf(lines[first].text);
    changed.splice(
      first,
      there.length,
      ...numbered.map(({ sign, code, number }) => ({ text: code.slice(deeper), number, sign })),
    );
  }
  return touched ? changed : null;
}

const indentOf = line => line.match(/^ */)[0].length;

// Each row with the number that its line has in the file; a line that is new has none.
function number(rows, first) {
  let next = first;
  return rows.map(row => ({ ...row, number: row.sign === '+' ? null : next++ }));
}

/** The film of each change that a page shows. */
export function copyChangeFilms({ pieces, ...page }, out) {
  for (const { change, args } of pieces.filter(({ name, change }) => name === 'change' && change))
    writeFileSync(join(out, addressOf(page, change)), inTheBook({ page: change.page, title: args[0] }));
}
