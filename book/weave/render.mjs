// A page's body: its prose with the book's marks, boxes and formulas put in.
import { keepTogether } from './keep_together.mjs';
import { boxHtml } from './boxes.mjs';
import { inlineHtml, inlineText } from './inline.mjs';
import { blockHtml } from './blocks.mjs';
import { proseHtml } from './prose-html.mjs';
import { placesOf } from './places.mjs';
import { escapeHtml, smarten } from './text.mjs';

// Returns { html, places }, of which the search knows; `held` keeps heavy pieces of HTML out of their text.
export function renderPage(book, page) {
  const held = [];
  const hold = html => `\ue002${held.push(html) - 1}\ue003`;
  const piece = n => page.pieces[n];
  const context = { book, page, hold };
  const raw = proseHtml(page.tokens, {
    block: one => blockHtml(context, one),
    box: (one, html) => boxHtml(context, one, html),
    heading: headingHtml,
    fault: (message, { line }) => book.problems.add(page.file, line, message),
  });
  const expand = html => html.replace(/\ue002(\d+)\ue003/g, (_, n) => held[n]);
  return {
    html: expand(countClaims(keepTogether(raw, n => inlineHtml(context, piece(n)), piece))),
    places: placesOf(page, raw, n => inlineText(piece(n))),
  };
}

// A phone shows the check marks of a paragraph below it, one beside the other: each has to know how many come before it.
function countClaims(html) {
  let n = 0;
  return html.replace(/<(?:p|li|td|dd|div)\b|<a class="claim"/g, tag => {
    if (tag.startsWith('<a')) return `${tag} style="--n:${n++}"`;
    n = 0;
    return tag;
  });
}

// The title stands in the template.
function headingHtml(heading) {
  if (heading.level === 1) return '';
  const level = `h${heading.level}`;
  const number = heading.number ? `<span class="secno">${heading.number}</span> ` : '';
  const text = heading.text
    .split(/(`[^`]+`)/)
    .map(part => (/^`.+`$/.test(part) ? `<code>${escapeHtml(part.slice(1, -1))}</code>` : escapeHtml(smarten(part))))
    .join('');
  return `<${level} id="${heading.id}">${number}${text} <a class="anchor-link" href="#${heading.id}" aria-label="Link to this section">#</a></${level}>`;
}
