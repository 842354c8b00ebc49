// The page for the wall: answers that fold out, and what they end in: a method, the steps that it needs, lines to copy.
import { basename } from 'node:path';
import { value } from './cards.mjs';
import { readRecords } from './csv.mjs';
import { highlightLines } from './highlight.mjs';
import { linker } from './api.mjs';
import { numberHtml } from './numbers.mjs';
import { didYouMean } from './problems.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml, slug, smarten } from './text.mjs';

// In the page's folder, where the lines stand that are to be copied: compiled, and called by its claims. And the table of the steps.
const CALLS = 'calls.h';
const RATES = 'rates';

// The clock of a game, a header to copy as well.
export const CLOCK = 'code/frames/fixed_step.h';

// What a \take{function, tag, Name} names, looked up before Doxygen runs.
export function checkTake({ book, page, piece, report }) {
  const [name, tag] = piece.args;
  piece.card = book.cards.get(name);
  if (!piece.card) report(`there is no card of a function "${name}".${didYouMean(name, book.cards.keys())}`);
  const { folder, tables } = book.programs.get(page.owner) ?? {};
  if (!folder) {
    report('this page has no program that could say how many steps a method needs');
    return;
  }
  piece.path = `${folder}/${CALLS}`;
  piece.snippet = book.snippet(piece.path, tag);
  if (piece.snippet.fault) report(piece.snippet.fault);
  const table = tables.get(RATES);
  if (!table) report(`the program of this page writes no table "${RATES}"`);
  piece.rates = table && readRecords(table.path).find(row => row.function === name);
}

export const choiceHtml = (html, { args: [name, title] }) =>
  `<details class="choice" id="${slug(name)}"><summary>${escapeHtml(smarten(title))}</summary><div>${html}</div></details>`;

export function takeHtml({ book, hold }, { args: [name, , title], card, path, snippet, rates }) {
  const { href } = book.api.names.get(`integrate::${name}`);
  const code = snippet.lines.map(line => line.text).join('\n');
  const files = headersOf(book, name, code);
  const downloads = files.map(file => `<a href="headers/${file}" download>${file}</a>`).join(', ');
  const included = /integrate::/.test(code) ? `${files.map(file => `#include "${file}"`).join('\n')}\n\n` : '';
  // A line that is too long for a phone goes on in the next, further in.
  const lines = highlightLines(included + code, 'cpp', linker(book.api, path)).map(
    (line, i) => `<span class="l${i < included.split('\n').length - 1 ? ' included' : ''}">${line}\n</span>`,
  );
  return hold(
    `<div class="take"><p class="method"><strong>${escapeHtml(smarten(title))}</strong> <span>copy ${downloads}</span> ` +
      `<a href="${href}">its page</a></p>${rates ? ratesHtml(rates) : ''}` +
      `<div class="codebox"><pre><code>${lines.join('')}</code></pre></div>` +
      `<p class="facts">${rates ? `<span class="label">Measured:</span> ${facts(card).join('; ')}. ` : ''}<a href="${sourceHref(path)}#L${snippet.lines[0].number}">${CALLS}</a></p></div>`,
  );
}

// The headers that the lines need, the method's own first.
function headersOf({ api }, name, code) {
  const named = [name, ...[...code.matchAll(/integrate::(\w+)/g)].map(([, used]) => used)];
  const homes = named.map(
    used =>
      [...api.headers.values()].find(({ functions, types }) =>
        [...functions, ...types].some(entry => entry.name === used),
      ).name,
  );
  return [...new Set(/frames::/.test(code) ? [...homes, basename(CLOCK)] : homes)];
}

// Columns of the table, and what they are called here.
const COLUMNS = [
  ['stands', 'not to explode'],
  ['to 10 %', 'to 10\u202f%'],
  ['to 1 %', 'to 1\u202f%'],
  ['to 0.1 %', 'to 0.1\u202f%'],
];

function ratesHtml(rates) {
  const heads = COLUMNS.map(([, head]) => `<th scope="col">${head}</th>`);
  const cells = COLUMNS.map(([column, head]) => {
    const steps = Number(rates[column]);
    return `<td data-steps="${steps}" data-for="${head}">${steps === 0 ? 'any' : numberHtml(steps, 2)}</td>`;
  });
  return (
    `<table class="rates"><thead><tr><td>for ten swings</td>${heads.join('')}</tr></thead>` +
    `<tbody><tr><th scope="row">steps a swing</th>${cells.join('')}</tr></tbody></table>`
  );
}

// What the card says, in a few words each.
function facts({ rows }) {
  const row = name => rows.find(r => r.name === name);
  const is = (name, words) => row(name)?.measured === words;
  const order = value(row('order'), 1),
    drag = value(row('drag-order'), 1),
    asks = Number(row('evaluations').measured);
  const said = [
    `order ${order}${drag === order ? '' : `, ${drag} with drag`}`,
    (['no evaluation', '1 evaluation'][asks] ?? `${asks} evaluations`) + (row('solves') ? ' and a solve' : ''),
    is('spring-limit', 'any step') ? 'stable for any step' : `stable to <i>hω</i> = ${value(row('spring-limit'))}`,
  ];
  if (!is('spring-limit', 'any step'))
    said[2] += is('drag-limit', 'any step') ? ' and any drag' : `, <i>ch</i> = ${value(row('drag-limit'))}`;
  if (row('fall') && Math.round(Number(row('fall').measured)) !== 50)
    said.push(`falls ${value(row('fall'), 2)} <i>gh</i>² for 50`);
  if (is('energy', 'kept')) said.push(`energy kept to ${value(row('energy-off'))}`);
  else if (is('energy', 'falls'))
    said.push(`takes ${value(row('energy-step'), 2).replace(/^−/, '')} of the energy a step`);
  return said;
}

// Seen only where scripts run, which fill in what it makes of each table.
export const rateHtml = () => {
  const input = (name, start, label) =>
    `<input type="number" name="${name}" value="${start}" min="0" step="any" inputmode="decimal" autocomplete="off" aria-label="${label}">`;
  return (
    `<div class="your-spring" role="group" aria-label="Your spring and your game" hidden><p>My spring swings ${input('swings', 3, 'Swings a second')} times a second ` +
    `(<i>ω</i> = ${input('omega', 18.85, 'ω, radians per second')}), and my game ticks ${input('ticks', 60, 'Ticks a second')} times.</p><p class="facts"><output></output> <a href="#what-the-answers-say">What is my <i>ω</i>?</a></p></div>`
  );
};
