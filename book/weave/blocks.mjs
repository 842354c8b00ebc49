// What the marks that stand alone become: listings, fences, displayed formulas, rows of a table, cards, the list of chapters.
import { cardHtml } from './cards.mjs';
import { highlightLines, languageOf } from './highlight.mjs';
import { headerCalled } from './inline.mjs';
import { linker } from './api.mjs';
import { sourceHref } from './source-pages.mjs';
import { tableHtml } from './tables.mjs';
import { escapeHtml, smarten } from './text.mjs';
import { rateHtml, takeHtml } from './pick-a-method.mjs';
import { sketchHtml } from './sketch.mjs';

export function blockHtml(context, piece) {
  return {
    listing,
    fence,
    display,
    rows,
    card,
    contents,
    outline,
    pause,
    take: takeHtml,
    rate: rateHtml,
    sketch: sketchHtml,
  }[piece.name](context, piece);
}

export function codeLines(lines, numbers, { id = () => '', gaps = true } = {}) {
  const before = i => numbers.slice(0, i).findLast(number => number !== null);
  const leftOut = i => gaps && i > 0 && numbers[i] !== null && numbers[i] !== before(i) + 1;
  return lines
    .map(
      (line, i) =>
        `<span class="ln${leftOut(i) ? ' gap' : ''}"${id(numbers[i])} data-n="${numbers[i] ?? ''}"></span>${line}`,
    )
    .join('\n');
}

function listing({ book, hold }, piece) {
  const [path, , caption = ''] = piece.args;
  const { lines } = piece.snippet;
  const words = caption && `<span class="caption">${escapeHtml(smarten(caption))}</span>`;
  return (
    `<figure class="listing" id="${piece.id}"><figcaption><span class="head"><span class="num">Listing ${piece.number}</span> ${words}</span>` +
    `<a class="file" href="${sourceHref(path)}#L${lines[0].number}">${escapeHtml(path).replace(/\//g, '/<wbr>')}</a></figcaption>` +
    `<pre><code>${hold(listingCode(book, path, lines))}</code></pre></figure>`
  );
}

/** @param lines [{ text, number, sign? }, ...]: with the signs of a diff, the lines of a change. */
export function listingCode(book, path, lines) {
  const html = highlightLines(lines.map(({ text }) => text).join('\n'), 'cpp', linker(book.api, path));
  const marked = html.map((line, i) => signed(line, lines[i].sign));
  return codeLines(
    marked,
    lines.map(({ number }) => number),
  );
}

/** A line as gone or come, by the sign of a diff. */
export function signed(html, sign) {
  const as = CHANGED[sign];
  return as ? `<${as}>${html}</${as}>` : html;
}

const CHANGED = { '-': 'del', '+': 'ins' };

function fence({ hold }, { language, code, printedBy }) {
  const diff = language === 'diff';
  const kind = languageOf(language) === 'bash' ? ' terminal' : diff ? ' diff' : '';
  const lines = diff ? diffLines(code) : highlightLines(code, language);
  const by = printedBy ? ` data-printed-by="${printedBy}"` : '';
  return `<div class="codebox${kind}"${by}><pre><code>${hold(lines.join('\n'))}</code></pre></div>`;
}

// What a reader takes out of a program and puts in.
const diffLines = code =>
  code.split('\n').map(line => {
    const as = CHANGED[line[0]];
    return as ? `<${as}>${escapeHtml(line)}</${as}>` : escapeHtml(line);
  });

const display = ({ hold }, piece) => `<div class="math-block">${hold(piece.html)}</div>`;

const rows = ({ book }, piece) =>
  `<div class="tablescroll">${tableHtml(piece.table, book.times, field => headerCalled(book, field)?.href)}</div>`;

function card({ book, page, hold }, piece) {
  const { card: measured } = piece;
  const isFirst = page.pieces.find(({ name }) => name === 'card') === piece;
  const { name } = measured;
  const { href } = book.api.names.get(`integrate::${name}`);
  return hold(
    cardHtml(measured, book.times, `<b><a href="${href}"><code>${escapeHtml(name)}</code></a></b> measured`, isFirst),
  );
}

// The place to stop for whoever doesn't read a chapter in one sitting.
function pause({ page }, piece) {
  const [before, all] = [page.minutes(piece), page.minutes()];
  return `<p class="pause">A good place to stop. So far it took about ${before} minutes; the rest takes ${all - before}, and then come the exercises.</p>`;
}

function contents({ book }) {
  return contentsHtml([...book.chapters.values()]);
}

// The subsections of a long page, under the names of their sections.
function outline({ page }) {
  const link = ({ id, text }) => `<a href="#${id}">${escapeHtml(smarten(text))}</a>`;
  const groups = page.sections.reduce(
    (all, section) => (section.level === 2 ? [...all, [section]] : [...all.slice(0, -1), [...all.at(-1), section]]),
    [],
  );
  const html = groups
    .filter(([, ...below]) => below.length)
    .map(([head, ...below]) => `<dt>${link(head)}</dt><dd>${below.map(link).join('')}</dd>`);
  return `<dl class="outline">${html.join('\n')}</dl>`;
}

export function contentsHtml(pages) {
  const items = pages.map(
    ({ href, number, title }) =>
      `<li><a href="${href}"><span class="no">${number || ''}</span><span class="title">${escapeHtml(smarten(title))}</span></a></li>`,
  );
  return `<ol class="contents">\n${items.join('\n')}\n</ol>`;
}
