// A page's body: Doxygen's XML with the book's marks, boxes and formulas put in.
import { join } from 'node:path';
import { keepTogether } from './keep_together.mjs';
import { boxHtml } from './boxes.mjs';
import { inlineHtml, inlineText } from './inline.mjs';
import { blockHtml } from './blocks.mjs';
import { doxygenLabel, TOKEN } from './prose.mjs';
import { escapeHtml, smarten, textOfHtml } from './text.mjs';
import { createXmlToHtml, loadXml } from './xml.mjs';

// Returns { html, sections: [{ id, title, text }] }; `held` keeps heavy pieces of HTML out of the text for the search.
export function renderPage(book, page, xml) {
  const held = [];
  const hold = html => `\ue002${held.push(html) - 1}\ue003`;
  const piece = n => page.pieces[Number(n)];
  const report = (line, message) => book.problems.add(page.file, line, message);
  const context = { book, page, hold };
  const { flow } = createXmlToHtml({
    opens: n => piece(n).type === 'open',
    closes: n => piece(n).type === 'close',
    isBlock: n => piece(n).type === 'block',
    isTableStart: n => piece(n).type === 'tablestart',
    block: n => blockHtml(context, piece(n)),
    box: (n, html) => boxHtml(context, piece(n).opens ?? piece(n), html),
    heading: html => headingHtml(piece(html.match(/\d+/)?.[0] ?? -1) ?? page.sections[0]),
    code: code => `<code>${escapeHtml(code)}</code>`,
    verbatim: code =>
      report(lineOf(page, code), 'code by indentation; put it between ``` lines, or indent it less if it is no code') ??
      '',
    formula: () => '',
    link: (refid, html) => link(book, refid, html),
    fault: (message, n, excerpt) => report(n === undefined ? lineOf(page, excerpt) : piece(n).line, message),
    stray: n => strayToken(report, piece(n)),
  });
  const $ = loadXml(join(xml, `${doxygenLabel(page)}.xml`));
  const raw = flow($('doxygen > compounddef > detaileddescription').get(0)?.children ?? []);
  findLeftovers(page, raw, report);
  const expand = html => html.replace(/\ue002(\d+)\ue003/g, (_, n) => held[n]);
  return {
    html: expand(countClaims(keepTogether(raw, n => inlineHtml(context, piece(n)), piece))),
    sections: sectionsOf(page, raw, n => inlineText(piece(n))),
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

function link(book, refid, html) {
  const href = book.api.hrefs.get(refid);
  return href ? `<a href="${href}"><code>${html}</code></a>` : `<code>${html}</code>`;
}

function strayToken(report, piece) {
  if (piece.type === 'tablestart')
    report(
      piece.line,
      'this table came out as a paragraph; check that each of its rows starts and ends with | and that the line above it is empty',
    );
  else if (piece.type !== 'inline')
    report(piece.line, `\\${piece.name} landed inside a paragraph; put an empty line before and after it`);
}

function headingHtml(heading) {
  const level = `h${heading.level}`;
  const number = heading.number ? `<span class="secno">${heading.number}</span> ` : '';
  const text = heading.text
    .split(/(`[^`]+`)/)
    .map(part => (/^`.+`$/.test(part) ? `<code>${escapeHtml(part.slice(1, -1))}</code>` : escapeHtml(smarten(part))))
    .join('');
  return `<${level} id="${heading.id}">${number}${text} <a class="anchor-link" href="#${heading.id}" aria-label="Link to this section">#</a></${level}>`;
}

function sectionsOf(page, raw, expand) {
  const words = html =>
    textOfHtml(html.replace(/\ue002\d+\ue003/g, ' '))
      .replace(TOKEN, (_, n) => expand(n))
      .replace(/\s+/g, ' ')
      .replace(/ (?=[.,;:!?])/g, '');
  const [intro, ...rest] = raw.split(/(?=<h2 )/);
  return [
    { id: '', title: '', text: words(intro) },
    ...rest.map(part => {
      const section = page.sections.find(s => part.startsWith(`<h2 id="${s.id}"`));
      return { id: section.id, title: section.text.replace(/`/g, ''), text: words(part.slice(part.indexOf('</h2>'))) };
    }),
  ];
}

// Markup that Doxygen did not take for markup.
function findLeftovers(page, raw, report) {
  const text = raw.replace(/<code>[^<]*<\/code>/g, '').replace(/<[^>]*>/g, ' ');
  const strayTable = [...text.matchAll(TOKEN)].some(([, n]) => page.pieces[n].type === 'tablestart');
  for (const [all, found] of text.matchAll(
    /[^\n\ue000-\ue003]{0,12}(\*\*|\*(?=\w)|(?<=\w)\*|\]\(|\]\[|\[\^|\||`|@ref|\\\w+)[^\n\ue000-\ue003]{0,12}/g,
  )) {
    if (found === '|' && strayTable) continue;
    report(
      lineOf(page, all.trim()),
      `"${found}" was left standing in "${all.trim()}": Doxygen did not take it for markup; write \\${found[0]} if it is meant so`,
    );
  }
}

// The excerpt went through Doxygen, which joins lines, and has quotes and dashes of the page's kind.
function lineOf(page, excerpt) {
  const words = excerpt.match(/[\w*`\\]{3,}[^\ue000-\ue003\n]*/)?.[0].trim() ?? excerpt;
  const pattern = words
    .split('\n')[0]
    .replace(/[^\w\s]/g, '[^\\w\\s]{1,3}')
    .replace(/\s+/g, '\\s+');
  const at = page.source.search(new RegExp(pattern));
  return at < 0 ? 1 : page.source.slice(0, at).split('\n').length;
}
