// What the marks within a sentence become, for the page and for the search.
import { NUMBERED } from './marks.mjs';
import { fullText, quantityHtml, quantityText } from './numbers.mjs';
import { setHtml } from './set-links.mjs';
import { beforeColon, escapeHtml, slug, smarten } from './text.mjs';

export function inlineHtml({ book, page }, piece) {
  return HTML[piece.name]?.(piece, page, book) ?? '';
}

const address = (target, page) => (target.page === page ? '' : target.page.href) + `#${target.piece.id}`;

export const claimId = name => `claim-${slug(name)}`;

// `euler.h` or `code/integrate/euler.h`
export const headerCalled = ({ api }, code) =>
  [...api.headers.values()].find(({ name, file }) => code === name || code === file);

const HTML = {
  math: piece => piece.html,
  code: (piece, page, book) => {
    const named = /::/.test(piece.code) ? book.api.names.get(piece.code) : headerCalled(book, piece.code);
    const { href } = named ?? {};
    const code = `<code>${escapeHtml(piece.code)}</code>`;
    return href ? `<a href="${href}">${code}</a>` : code;
  },
  ref: ({ target, args: [name] }) => `<a href="${target.href}"><code>${escapeHtml(name)}</code></a>`,
  number: ({ value }) => {
    const tip = `${value.name} = ${fullText(value)}, from ${value.chapter.program}`;
    return `<data class="number" value="${escapeHtml(value.written)}" data-tip="${escapeHtml(tip)}">${quantityHtml(value)}</data>`;
  },
  claim: ({ claim, id }) => {
    const name = escapeHtml(smarten(claim.test.name));
    return `<a class="claim" id="${id}" href="claims.html#${claimId(claim.test.name)}" aria-label="Tested: ${name}" data-tip="Tested: ${name}"></a>`;
  },
  tested: ({ claim, id }) =>
    `<a class="tested" id="${id}" href="claims.html#${claimId(claim.test.name)}">${escapeHtml(smarten(claim.test.name))}</a>`,
  set: setHtml,
  figref: ({ target }, page) => `<a href="${address(target, page)}">${label(target)}</a>`,
  tabref: ({ target }, page) => `<a href="${address(target, page)}">${label(target)}</a>`,
  exerciseref: ({ target }, page) => `<a href="${address(target, page)}">${label(target)}</a>`,
  lstref: ({ target }, page) => `<a href="${address(target, page)}">${label(target)}</a>`,
  eqref: ({ target }, page) => `<a href="${address(target, page)}">(${target.piece.number})</a>`,
  citep: (piece, page, book) =>
    `[${piece.args.map(key => `<a href="references.html#bib-${slug(key)}">${escapeHtml(book.references.get(key).piece.args[1])}</a>`).join('; ')}]`,
  bibitem: ({ args: [key, name] }) => `<span class="bibkey" id="bib-${slug(key)}">[${escapeHtml(name)}]</span>`,
  term: ({ id, args: [name], target }) =>
    `<dfn id="${id}">${escapeHtml(smarten(name))}</dfn> ` +
    `<a class="introduced" href="${target.page.href}${target.section ? `#${target.section.id}` : ''}" aria-label="${escapeHtml(smarten(name))}: ${place(target)}">${target.page.beside ? place(target) : (target.section?.number ?? target.page.number)}</a>`,
  chapterref: ({ target }) =>
    `<a href="${target.href}">Chapter ${target.number}, <em>${escapeHtml(smarten(beforeColon(target.title)))}</em></a>`,
  minutes: ({ target }) => `${target.page.minutes()}\u202fmin`,
  graded: ({ target }) => graded(target.page),
  sectionref: ({ target, section }, page) =>
    `<a href="${target.page === page ? '' : target.href}#${section.id}">section ${section.number}</a>`,
};

// How many exercises of a chapter are graded, and how long their tasks say that they take.
function graded(page) {
  const minutes = [...page.tasks.values()].map(task => Number(task.minutes));
  return `${minutes.length} in ${minutes.reduce((sum, each) => sum + each, 0)}\u202fmin`;
}

const place = ({ page, section }) =>
  page.beside
    ? `beside chapter ${page.beside.number}`
    : section
      ? `section ${section.number}`
      : `chapter ${page.number}`;
const label = ({ piece }) => `${NUMBERED[piece.name]} ${piece.number}`;

export function inlineText(piece) {
  if (piece.name === 'number') return quantityText(piece.value);
  if (piece.name === 'minutes') return `${piece.target.page.minutes()}\u202fmin`;
  if (piece.name === 'graded') return graded(piece.target.page);
  if (piece.name === 'set') return piece.args[1];
  if (piece.name === 'code') return piece.code;
  if (piece.name === 'math') return mathText(piece.html);
  if (['citep', 'bibitem', 'term', 'tested', 'ref'].includes(piece.name)) return piece.args.join(' ');
  return '';
}

// A formula in one line, as far as letters go: what KaTeX wrote for screen readers, without its tags.
const mathText = html =>
  html
    .replace(/<annotation[\s\S]*$/, '')
    .replace(/<[^>]*>/g, '')
    .replace(/&lt;/g, '<')
    .replace(/&gt;/g, '>')
    .replace(/&amp;/g, '&');
