// The page that lists every claim of the book with the test that proves it.
import { claimId } from './inline.mjs';
import { sourceHref } from './source-pages.mjs';
import { escapeHtml, smarten } from './text.mjs';

export function claimsPage(book) {
  const chapters = [...book.programs.values()].filter(chapter => chapter.tests.length);
  const total = book.claims.size;
  const body =
    `<p class="lead">Each sentence below is the name of a test that runs whenever the book is built. ` +
    `If one of the ${total} fails, there is no book. A check mark in the text leads here, and from here to the test.</p>\n` +
    chapters.map(chapter => section(book, chapter)).join('\n');
  return {
    href: 'claims.html',
    title: 'Claims',
    kind: 'claims',
    body,
    sections: chapters.map(chapter => ({ id: chapter.name, title: chapter.title })),
  };
}

function section(book, chapter) {
  const claims = chapter.tests.map(test => book.claims.get(test.name));
  return (
    `<h2 id="${chapter.name}">${chapter.number ? `<span class="secno">${chapter.number}</span> ` : ''}${escapeHtml(smarten(chapter.title))}</h2>\n` +
    `<ul class="claims">\n${claims.map(claim => item(book, claim)).join('\n')}\n</ul>`
  );
}

function placeOf({ number, name, title }) {
  if (number) return `chapter ${number}`;
  if (name === 'index') return 'the start page';
  return name.includes('-') ? `the page ${escapeHtml(title)}` : `the ${name}`;
}

// Words for the screen stand in a book with live figures alone.
const isShown = (book, { piece }) => book.config.live || piece.box?.name !== 'screen';

function item(book, { test, cited }) {
  const shown = cited.filter(place => isShown(book, place));
  const places = shown.map(({ page, piece }, i) => {
    const words = i
      ? page === shown[i - 1].page
        ? 'and again'
        : `and in ${placeOf(page)}`
      : `said in ${placeOf(page)}`;
    return `<a href="${page.href}#${piece.id}">${words}</a>`;
  });
  if (!places.length) places.push('not said in the text');
  return (
    `<li id="${claimId(test.name)}"><span class="sentence">${escapeHtml(smarten(test.name))}</span>` +
    `<span class="proof"><span class="passed">passed</span> <a href="${sourceHref(test.file)}#L${test.line}"><code>${escapeHtml(test.file)}:${test.line}</code></a> <span>${places.join(', ')}</span></span></li>`
  );
}
