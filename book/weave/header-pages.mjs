// Headers that stand alone: a page for each, with how to take it and how to call what is in it, and lists of them.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { linker } from './api.mjs';
import { cardHtml, steps } from './cards.mjs';
import { highlightLines } from './highlight.mjs';
import {
  brief,
  details,
  entryHeading,
  fields,
  include,
  memberSection,
  signature,
  templateLine,
  where,
} from './reference-entries.mjs';
import { onShelf } from './namespaces.mjs';
import { promisesHtml } from './promises.mjs';
import { tryAttribute } from './page-sources.mjs';
import { isMark } from './snippets.mjs';
import { escapeHtml } from './text.mjs';

export function headerPages(book) {
  const headers = [...book.api.headers.values()];
  for (const header of headers) checkExample(book, header);
  return headers.map(header => headerPage(book, header));
}

// The page is enough to use a header: each function is called in its example, or one that takes the same arguments.
function checkExample(book, header) {
  const source = readFileSync(join(book.config.source, header.file), 'utf8');
  const words = new Set(
    [...source.matchAll(/^\/\/\/ @code\n([\s\S]*?)@endcode/gm)].flatMap(([, code]) => code.match(/\w+/g)),
  );
  const { functions, types } = header;
  const shown = functions.filter(({ name }) => words.has(name) || isOperator(name)).map(argumentsOf);
  const missing = (functions.length ? functions : types).filter(
    entry => !words.has(entry.name) && !isOperator(entry.name) && !shown.includes(argumentsOf(entry)),
  );
  for (const { name, file, line } of missing)
    book.problems.add(
      file,
      line,
      `no example shows how ${name} is used; put one between @code and @endcode into the first comment of ${header.name}`,
    );
}

const isOperator = name => /^operator\W/.test(name); // stands in an example by its sign

const argumentsOf = ({ parameters = [{}] }) => parameters.map(({ type, name }) => `${type} ${name}`).join(', ');

function headerPage(book, header) {
  const lines = linesOf(book, header);
  const functions = [...header.functions.filter(steps), ...header.functions.filter(member => !steps(member))];
  const members = [...functions, ...header.constants].map(member =>
    memberSection(book, member, { level: 2, card: cardFor(book, member) }),
  );
  const types = header.types.map(type => typeSection(book, type));
  return {
    href: header.href,
    title: header.name,
    titleHtml: `<code>${escapeHtml(header.name)}</code>`,
    kind: 'api',
    kicker: header.file.replace(/\/[^/]*$/, ''),
    body: [
      `<p class="lead">${brief(book, header)}</p>`,
      take(header, lines),
      beforeCard(promisesHtml(book, header, usage(book, header)), wholeHtml(book, header, lines)),
      ...members,
      ...types,
    ].join('\n'),
    sections: [...functions, ...header.constants, ...header.types].map(({ name, anchor }) => ({
      id: anchor,
      title: name,
    })),
  };
}

function cardFor(book, member) {
  const card = steps(member) && book.cards.get(member.name);
  return card ? cardHtml(card, book.times, `<b>Measured</b> for ${escapeHtml(card.suits)}`) : '';
}

const linesOf = (book, { file }) =>
  readFileSync(join(book.config.source, file), 'utf8')
    .trimEnd()
    .split('\n')
    .filter(line => !isMark(line));

// All that there is to copy.
function wholeHtml(book, header, lines) {
  const code = highlightLines(lines.join('\n'), 'cpp', linker(book.api, header.file)).join('\n');
  return (
    `<figure class="listing${lines.length > 80 ? ' long' : ''}" id="${WHOLE}"><figcaption><span class="head"><span class="caption">All of it</span></span>` +
    `<a class="file" href="headers/${header.name}" download>${escapeHtml(header.name)}</a></figcaption>` +
    `<pre tabindex="0" aria-label="${escapeHtml(header.name)}"><code>${code}</code></pre></figure>`
  );
}
const WHOLE = 'all-of-it';

// What a header promises stands within its text, and what a function does behind it.
const beforeCard = (html, piece) =>
  html.includes(CARD) ? html.replace(CARD, () => piece + CARD) : `${html}\n${piece}`;
const CARD = '<div class="card promises"';

function take(header, lines) {
  const libraries = [...new Set(lines.map(line => line.match(/^#include <(\w+)\//)?.[1]).filter(Boolean))];
  return (
    `<p class="take">Take <a href="headers/${header.name}" download>${escapeHtml(header.name)}</a>, <a href="#${WHOLE}">${lines.length} lines</a> ` +
    `under MIT-0, which owe you nothing. It needs C++17${libraries.length ? ` and ${libraries.join(' and ')}` : ' and nothing else'}.${vectors(header, libraries)}</p>`
  );
}

// What the vectors of raylib and of Chipmunk lack.
export const RAYLIB_OPERATOR = 'inline Vector3 operator*(float s, Vector3 v) { return v * s; }';
export const CHIPMUNK_OPERATOR = 'inline cpVect operator*(cpFloat s, cpVect v) { return v * s; }';
const VECTORS =
  ' A <code>Vec</code> is whatever has <code>Vec + Vec</code> and <code>h * Vec</code>: a number, <code>glm::vec3</code>, an Eigen vector, a struct of yours.';
const RAYLIB = ` raylib lacks one operator, which is <code>${RAYLIB_OPERATOR}</code>`;

function vectors(header, libraries) {
  const { functions, types } = header;
  const has = (entry, name) =>
    (entry.templates ?? []).some(template => `${template.type} ${template.name}`.includes(name));
  if (libraries.includes('Eigen')) return ' Its <code>Vec</code> is an Eigen vector of all unknowns.';
  if (onShelf(header)) return [...functions, ...types].some(entry => has(entry, 'Vec')) ? VECTORS + RAYLIB : '';
  if (!functions.some(steps)) return '';
  const place = functions.some(entry => has(entry, 'Position'))
    ? ' A <code>Position</code> is the same, or of a type of its own that <code>x + h * v</code> moves: a pose that a twist turns.'
    : '';
  return (
    VECTORS +
    ' Bodies that pull at each other go into one <code>Vec</code>, and one call moves them all.' +
    place +
    RAYLIB
  );
}

// The first example starts with the line that brings the header in, and can be tried in the page.
function usage(book, header) {
  const line = highlightLines(`#include "${header.name}"`, 'cpp').join('');
  return details(book, header)
    .replace(/<pre><code>(?=(.*))/, (start, next) => `${start}${line}\n${next.includes('#include') ? '' : '\n'}`)
    .replace('<div class="codebox"', start => `${start}${tryAttribute(book, header)}`);
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
    const inside = [...header.functions, ...header.types].filter(
      (e, i, all) => all.findIndex(other => other.name === e.name) === i,
    );
    return `<dt>${entry(header)}</dt><dd>${brief(book, header)} <a href="headers/${header.name}" download>${header.name}</a><br><span class="inside">${inside.map(entry).join(', ')}</span></dd>`;
  });
  return `<dl class="summary">${items.join('\n')}</dl>`;
}
