// Headers that stand alone: a page for each, with how to take it and how to call what is in it, and lists of them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { cardHtml, stepping, steps, value } from './cards.mjs';
import { highlightLines } from './highlight.mjs';
import { brief, details, entryHeading, fields, include, memberSection, signature, templateLine, where } from './reference-entries.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml } from './text.mjs';

export function headerPages(book) {
  const headers = [...book.api.headers.values()];
  for (const header of headers) checkExample(book, header);
  return headers.map(header => headerPage(book, header));
}

// The page is enough to use a header: each function is called in its example, or one that takes the same arguments.
function checkExample(book, header) {
  const source = readFileSync(join(book.config.source, header.file), 'utf8');
  const words = new Set([...source.matchAll(/^\/\/\/ @code\n([\s\S]*?)@endcode/gm)].flatMap(([, code]) => code.match(/\w+/g)));
  const { functions, types } = header;
  const shown = functions.filter(({ name }) => words.has(name)).map(argumentsOf);
  const missing = (functions.length ? functions : types).filter(entry => !words.has(entry.name) && !shown.includes(argumentsOf(entry)));
  for (const { name, file, line } of missing) book.problems.add(file, line, `no example shows how ${name} is used; put one between @code and @endcode into the first comment of ${header.name}`);
}

const argumentsOf = ({ parameters = [{}] }) => parameters.map(({ type, name }) => `${type} ${name}`).join(', ');

function headerPage(book, header) {
  const functions = [...header.functions.filter(steps), ...header.functions.filter(member => !steps(member))];
  const members = [...functions, ...header.constants].map(member => memberSection(book, member, { level: 2, card: cardFor(book, member) }));
  const types = header.types.map(type => typeSection(book, type));
  return {
    href: header.href, title: header.name, titleHtml: `<code>${escapeHtml(header.name)}</code>`, kind: 'api', kicker: header.file.replace(/\/[^/]*$/, ''),
    body: [`<p class="lead">${brief(book, header)}</p>`, take(book, header), usage(book, header), ...members, ...types].join('\n'),
    sections: [...functions, ...header.constants, ...header.types].map(({ name, anchor }) => ({ id: anchor, title: name })),
  };
}

function cardFor(book, member) {
  const card = steps(member) && book.cards.get(member.name);
  return card ? cardHtml(card, `<b>Measured</b> for ${escapeHtml(card.suits)}`) : '';
}

function take(book, header) {
  const lines = readFileSync(join(book.config.source, header.file), 'utf8').trimEnd().split('\n');
  const libraries = [...new Set(lines.map(line => line.match(/^#include <(\w+)\//)?.[1]).filter(Boolean))];
  return `<p class="take">Take <a href="headers/${header.name}" download>${escapeHtml(header.name)}</a>, <a href="${sourceHref(header.file)}">${lines.length} lines</a> `
    + `under MIT-0, which owe you nothing. It needs C++17${libraries.length ? ` and ${libraries.join(' and ')}` : ' and nothing else'}.${vectors(header, libraries)}</p>`;
}

function vectors({ functions }, libraries) {
  if (libraries.includes('Eigen')) return ' Its <code>Vec</code> is an Eigen vector of all unknowns.';
  if (!functions.some(steps)) return '';
  return ' A <code>Vec</code> is whatever has <code>Vec + Vec</code> and <code>h * Vec</code>: a number, <code>glm::vec3</code>, an Eigen vector, a struct of yours. '
    + 'Bodies that pull at each other go into one <code>Vec</code>, and one call moves them all.';
}

// The first example starts with the line that brings the header in.
function usage(book, header) {
  const line = highlightLines(`#include "${header.name}"`, 'cpp').join('');
  return details(book, header).replace(/<pre><code>(?=(.*))/, (start, next) => `${start}${line}\n${next.includes('#include') ? '' : '\n'}`);
}

function typeSection(book, type) {
  const own = kind => type.members.filter(m => m.kind === kind);
  const variables = own('variable');
  const inside = [...own('typedef').filter(m => m.documented), ...own('function')];
  return `<section class="member">${entryHeading(type, 2)}
${signature(book, `${templateLine(type.templates)}${type.kind} ${type.name};`, type.file)}
<p class="brief">${brief(book, type)}</p>
${[details(book, type), variables.length ? fields(book, variables) : '', where(type), ...inside.map(m => memberSection(book, m))].filter(Boolean).join('\n')}</section>`;
}

// Each header and what is in it.
export function headerList(book, headers) {
  const entry = ({ name, href }) => `<a href="${href}"><code>${escapeHtml(name)}</code></a>`;
  const items = headers.map(header => {
    const inside = [...header.functions, ...header.types].filter((e, i, all) => all.findIndex(other => other.name === e.name) === i);
    return `<dt>${entry(header)}</dt><dd>${brief(book, header)}<br><span class="inside">${inside.map(entry).join(', ')}</span></dd>`;
  });
  return `<dl class="summary">${items.join('\n')}</dl>`;
}

// What the list of methods says of each: the words over the column, those beside the value on a phone, the value.
const COLUMNS = [
  ['alone', 'order', row => `${row('order', 1)}${row('order-velocity', 1) === row('order', 1) ? '' : `, ${row('order-velocity', 1)}`}`],
  ['with drag', 'order with drag', row => row('drag-order', 1)],
  ['', 'evaluations', row => row('evaluations')],
  ['drag, <i>ch</i>', 'drag: <i>ch</i> up to', row => row('drag-limit')],
  ['spring, <i>hω</i>', 'spring: <i>hω</i> up to', row => row('spring-limit')],
  ['', 'energy of a spring', row => row('energy')],
];

const HEAD = `<thead>
<tr><th scope="col" rowspan="2">Method</th><th scope="colgroup" colspan="2">Order</th><th scope="col" rowspan="2">Evalu­ations</th><th scope="colgroup" colspan="2">Stable up to</th><th scope="col" rowspan="2">Energy</th></tr>
<tr>${COLUMNS.filter(([head]) => head).map(([head]) => `<th scope="col">${head}</th>`).join('')}</tr>
</thead>`;

const ABOUT = `<p>Each is measured, and its page has the rest of the measurements. The order is that of the position; where the velocity has
another, it stands behind. Evaluations of the acceleration are counted per step. A step of <i>h</i> seconds explodes above its limit: on drag, where the speed
falls at the rate <i>c</i>, and on an undamped spring that swings with <i>ω</i>. The last column is what becomes of the energy of that spring.</p>
<p>A mass <i>m</i> on one spring of stiffness <i>k</i> swings with <i>ω</i> = √(<i>k</i>/<i>m</i>). In a rope of many, count with 2√(<i>k</i>/<i>m</i>), that of its
shortest wave. With a damper the limit is another, mostly lower: see the page. And all of this holds for forces that are linear: a rope
that swings explodes under the trapezoid rule, whatever its row says, and not under backward Euler.</p>`;

// Each function that steps with what its card says, one table for each kind of thing that they are for.
export function methodTables(book) {
  const members = new Map(stepping(book.api).map(member => [member.name, member]));
  const cards = [...book.cards.values()].filter(({ name }) => members.has(name));
  const kinds = [...new Set(cards.map(card => card.suits))];
  const table = kind => `<h3>For ${escapeHtml(kind)}</h3>\n<table class="methods">${HEAD}`
    + `<tbody>\n${cards.filter(card => card.suits === kind).map(card => methodRow(book, card, members.get(card.name))).join('\n')}\n</tbody></table>`;
  const beside = [...book.api.headers.values()].filter(header => !header.functions.some(steps));
  return `${ABOUT}\n${kinds.map(table).join('\n')}\n${beside.length ? `<h3>Linear systems for the implicit methods</h3>\n${headerList(book, beside)}` : ''}`;
}

function methodRow(book, card, member) {
  const row = (name, shown) => {
    const found = card.rows.find(r => r.name === name);
    return found ? value(found, shown) : '–';
  };
  const cells = COLUMNS.map(([, words, cell]) => `<td><span class="head">${words}</span> ${cell(row)}</td>`);
  return `<tr><th scope="row"><a href="${member.href}"><code>${escapeHtml(member.name)}</code></a> <span>${brief(book, member)}</span></th>${cells.join('')}</tr>`;
}
