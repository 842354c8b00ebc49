// What each header of the shelf promises, and what the program `shelf_cards` measured of each promise.
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { value } from './cards.mjs';
import { readRecords } from './csv.mjs';
import { onShelf } from './namespaces.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml } from './text.mjs';

const MEASURED_IN = 'code/measure/shelf';

// Map of a header's name without its ending to its rows { promise, kept, measured, digits, unit }. A book may have no shelf.
export function readPromises(folder, problems) {
  if (!folder) return new Map();
  const list = join(folder, 'tables.csv');
  if (!existsSync(list)) {
    problems.add(
      'code/measure/shelf_card.h',
      1,
      'what the shelf promises is not measured yet; build the target measured_shelf first',
    );
    return null;
  }
  const names = [...new Set(readRecords(list).map(({ table }) => table))];
  return new Map(names.map(name => [name, readRecords(join(folder, `${name}.csv`))]));
}

const stem = ({ name }) => name.replace(/\.h$/, '');

export function checkPromises(book) {
  if (!book.promises) return;
  for (const header of [...book.api.headers.values()].filter(onShelf)) {
    const rows = book.promises.get(stem(header));
    if (!rows)
      book.problems.add(
        header.file,
        1,
        `nothing is measured of ${header.name}; write ${MEASURED_IN}/${stem(header)}.cpp`,
      );
    for (const { promise, measured } of rows?.filter(({ kept }) => kept !== 'yes') ?? [])
      book.problems.add(header.file, 1, `a promise is not kept: "${promise}"; measured: ${measured}`);
  }
}

const measured = ({ measured: found, digits, unit }) => value({ about: '', measured: found, digits, unit });

// A header is plain text: powers stand in it as 10^-12, as 1e-12 and as h^2.
const wordsHtml = words =>
  escapeHtml(words)
    .replace(/\b1e-(\d+)/g, '10^-$1')
    .replace(/\b(\d[\d.]*)e-(\d+)/g, '$1 × 10^-$2')
    .replace(/\^(-?\d+)/g, (_, power) => `<sup>${power.replace('-', '−')}</sup>`);

// The list of promises that stands in a header's text becomes a card.
export function promisesHtml(book, header, html) {
  const name = stem(header);
  const rows = book.promises?.get(name);
  if (!rows) return html;
  const lines = rows.map(row => `<div><dt>${wordsHtml(row.promise)}</dt><dd>${measured(row)}</dd></div>`);
  const source = `${MEASURED_IN}/${name}.cpp`;
  const card = `<div class="card promises" role="note" aria-label="What ${escapeHtml(header.name)} promises">
<div class="cardhead"><p><b>Promised</b> and measured</p><p class="sources"><a href="data/shelf/${name}.csv">${name}.csv</a>, <a href="${sourceHref(source)}">${name}.cpp</a></p></div>
<dl>${lines.join('\n')}</dl></div>`;
  return html.replace(
    /<p>Promises:\s*<\/p>\s*<ul>[\s\S]*?<\/ul>|<p>Promises:\s*<ul>[\s\S]*?<\/ul>\s*(<\/p>)?/,
    () => card,
  );
}
