// The card of each method: what the program `cards` measured of it, as tables with the names of the functions.
import { existsSync, readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { readRecords } from './csv.mjs';
import { aboutTimes, isTime, timeHtml } from './measured-times.mjs';
import { numberHtml, unitHtml } from './numbers.mjs';
import { didYouMean } from './problems.mjs';
import { onShelf } from './namespaces.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml } from './text.mjs';

export const MEASURED_BY = 'code/measure/every_card.cpp';
export const LISTED_IN = 'code/measure/methods';

// Map of function name to its rows { name, about, asked, measured, digits, unit } and what it is for.
export function readCards(folder, problems) {
  const list = join(folder, 'tables.csv');
  if (!existsSync(list)) {
    problems.add(
      MEASURED_BY,
      1,
      'the cards of the methods are not measured yet; build the target measured_cards first',
    );
    return new Map();
  }
  const names = [...new Set(readRecords(list).map(({ table }) => table))];
  return new Map(names.map(name => [name, readCard(name, readRecords(join(folder, `${name}.csv`)))]));
}

function readCard(name, records) {
  const words = wanted => records.find(row => row.about === 'card' && row.name === wanted)?.measured ?? '';
  return { name, suits: words('suits'), note: words('note'), rows: records.filter(row => row.about !== 'card') };
}

// A function that moves its first argument on is one that steps.
export const steps = member =>
  member.kind === 'function' && /^(Position|Vec) ?&$/.test(member.parameters[0]?.type ?? '');

export const stepping = api =>
  [...api.headers.values()].filter(header => !onShelf(header)).flatMap(header => header.functions.filter(steps));

export function checkCards(book) {
  const known = stepping(book.api);
  for (const { name, file, line } of known) {
    if (!book.cards.has(name)) book.problems.add(file, line, `${name} steps and has no card; list it in ${LISTED_IN}`);
  }
  for (const name of book.cards.keys()) {
    if (!known.some(member => member.name === name))
      book.problems.add(
        ...placeOf(book, name),
        `a card of "${name}", which is no function in code/integrate that steps.${didYouMean(
          name,
          known.map(m => m.name),
        )}`,
      );
  }
}

// Where a method says which function it is.
function placeOf({ config }, name) {
  for (const file of readdirSync(join(config.source, LISTED_IN))) {
    const lines = readFileSync(join(config.source, LISTED_IN, file), 'utf8').split('\n');
    const line = lines.findIndex(text => text.includes(`function = "${name}"`)) + 1;
    if (line) return [`${LISTED_IN}/${file}`, line];
  }
  return [MEASURED_BY, 1];
}

// `title` is the HTML of the head. Of several cards in a chapter the first says how the times were taken.
export function cardHtml(card, times, title, isFirst = true) {
  const parts = [...new Set(card.rows.map(row => row.about))].map(
    about =>
      `<div class="part"><p class="label">${variables(about)}</p><dl>${card.rows
        .filter(row => row.about === about)
        .map(row => line(row, times))
        .join('')}</dl></div>`,
  );
  const timed = isFirst
    ? aboutTimes(
        times,
        card.rows.map(row => row.measured),
      )
    : '';
  const note = card.note ? `<p class="note">${escapeHtml(card.note)}</p>` : '';
  return `<div class="card" role="note" aria-label="Card of ${escapeHtml(card.name)}">
<div class="cardhead"><p>${title}</p><p class="sources"><a href="data/cards/${card.name}.csv">${card.name}.csv</a>, <a href="${sourceHref(MEASURED_BY)}">every_card.cpp</a></p></div>
<div class="parts">${parts.join('\n')}</div>
${note}${timed}</div>`;
}

const line = (row, times) =>
  `<div><dt>${variables(row.asked)}</dt><dd>${isTime(row.measured) ? `${timeHtml(times, row.measured)}\u202fns` : value(row)}</dd></div>`;

export function value({ about, measured, digits, unit }, shown = Number(digits)) {
  const number = Number(measured.replace(/^([-+]?)inf$/, '$1Infinity'));
  if (Number.isNaN(number)) return escapeHtml(measured);
  const written = /stable up to/i.test(about) ? roundedDown(number, shown) : number;
  return numberHtml(written, shown) + (unit === '1' ? '' : `\u202f${unitHtml(unit)}`);
}

// A limit is rounded down, since a step as long as what is written must hold. What was found by halving may be a little short of 2.
function roundedDown(limit, digits) {
  const last = 10 ** (Math.floor(Math.log10(limit)) - digits + 1);
  return Math.floor((limit * (1 + 1e-5)) / last) * last;
}

// What stands for a number in a line is set like a variable of a formula.
const variables = text => escapeHtml(text).replace(/(?<![\p{L}\d])(c?h²?ω?|gh²|g\/c|ζ)(?![\p{L}\d])/gu, '<i>$1</i>');
