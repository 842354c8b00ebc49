// The page to pick a method: answers that fold out, and what they end in: a method, the steps that it needs, lines to copy.
import { tryAttribute } from './page-sources.mjs';
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
const ORBITS = 'orbits';

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
  const orbits = tables.get(ORBITS);
  piece.orbits = orbits ? readRecords(orbits.path).filter(row => row.function === name) : [];
}

export const choiceHtml = (html, { args: [name, title] }) =>
  `<details class="choice" id="${slug(name)}"><summary>${escapeHtml(smarten(title))}</summary><div>${html}</div></details>`;

export function takeHtml({ book, hold }, { args: [name, , title], card, path, snippet, rates, orbits }) {
  const { href } = book.api.names.get(`integrate::${name}`);
  const code = snippet.lines.map(line => line.text).join('\n');
  const files = headersOf(book, name, code);
  const downloads = files.map(file => `<a href="headers/${file}" download>${file}</a>`).join(', ');
  const included = [...files.map(file => `"${file}"`), ...(/std::/.test(code) ? ['<cmath>'] : [])];
  const before = included.map(file => `#include ${file}\n`).join('') + (included.length ? '\n' : '');
  // A line that is too long for a phone goes on in the next, further in.
  const lines = highlightLines(before + code, 'cpp', linker(book.api, path)).map(
    (line, i) => `<span class="l${i < before.split('\n').length - 1 ? ' included' : ''}">${line}\n</span>`,
  );
  const [own] = [...book.api.headers.values()].filter(({ name: header }) => header === files[0]);
  const tried = own ? tryAttribute(book, own) : '';
  const header = files.length ? `<span>copy ${downloads}</span> <a href="${href}">its page</a> ` : '';
  return hold(
    `<div class="take" data-function="${name}"><p class="method"><strong>${escapeHtml(smarten(title))}</strong> ${header}` +
      `<a href="${sourceHref(path)}#L${snippet.lines[0].number}">${CALLS}</a></p>${rates ? ratesHtml(rates, orbits) : ''}` +
      `<div class="codebox"${tried}><pre><code>${lines.join('')}</code></pre></div>` +
      `${rates ? `<details class="measured"><summary>Measured, for readers of the chapters</summary><p class="facts">${facts(card).join('; ')}.</p></details>` : ''}</div>`,
  );
}

// The headers that the lines need, the method's own first; none, where the lines stand for themselves.
function headersOf({ api }, name, code) {
  const used = [...code.matchAll(/(?:integrate|shelf)::(\w+)/g)].map(([, called]) => called);
  if (!used.length) return [];
  const homes = [name, ...used].map(
    wanted =>
      [...api.headers.values()].find(({ functions, types }) =>
        [...functions, ...types].some(entry => entry.name === wanted),
      ).name,
  );
  return [...new Set(homes)];
}

// Columns of the table, and what they are called here.
const COLUMNS = [
  ['stands', 'not to explode'],
  ['to 10 %', 'to 10\u202f%'],
  ['to 1 %', 'to 1\u202f%'],
  ['to 0.1 %', 'to 0.1\u202f%'],
];

function ratesHtml(rates, orbits) {
  const heads = COLUMNS.map(([, head]) => `<th scope="col">${head}</th>`);
  const cell = (text, head) => {
    if (text === undefined) return '<td>–</td>';
    const steps = Number(text);
    return `<td data-steps="${steps}" data-for="${head}">${steps === 0 ? 'any' : numberHtml(steps, 2)}</td>`;
  };
  const row = (title, values) =>
    `<tr><th scope="row">${title}</th>${COLUMNS.map(([column, head]) => cell(values[column], head)).join('')}</tr>`;
  return (
    `<table class="rates"><thead><tr><td>for ten ${orbits.length ? 'swings or turns' : 'swings'}</td>${heads.join('')}</tr></thead>` +
    `<tbody>${row('steps a swing', rates)}${orbits.map(values => row(`a turn, ${escapeHtml(values.orbit)}`, values)).join('')}</tbody></table>`
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
    said.push(`in ten steps it falls ${value(row('fall'), 2)} <i>gh</i>², and should fall 50`);
  if (is('energy', 'kept')) said.push(`energy within ${value(row('energy-off'))} at <i>hω</i> = 0.1`);
  else if (is('energy', 'falls')) said.push(`energy ${value(row('energy-step'), 2)} a step at <i>hω</i> = 0.1`);
  return said;
}

// Seen only where scripts run, which put it above the steps of the answer that is open and fill in what it makes of them.
export const rateHtml = () => {
  const input = (name, start, label) =>
    `<input type="number" name="${name}" value="${start}" min="0" step="any" inputmode="decimal" autocomplete="off" aria-label="${label}">`;
  return (
    `<div class="your-spring" role="group" aria-label="Your spring and your game" hidden><p>It swings ${input('swings', 3, 'Swings a second')} times a second ` +
    `(<i>ω</i> = ${input('omega', 18.85, 'ω, radians per second')}), and my game ticks ${input('ticks', 60, 'Ticks a second')} times.</p><p class="facts"><output></output> <a href="#what-the-answers-say">What is my <i>ω</i>?</a></p></div>`
  );
};
