// The terms of the book: a chapter, or a page beside one, that introduces one sets it in italics, and the glossary leads there.
const ITALICS = /(?<![\\*])\*(?=[^\s*])([^*]+)(?<=[^\s\\*])\*(?!\*)/g;

const plain = words => words.replace(/\s+/g, ' ').toLowerCase();
const inItalics = page =>
  [...page.source.replaceAll('align*', 'align ').matchAll(ITALICS)].map(({ index, 1: words }) => ({
    index,
    words: plain(words),
  }));

const teaching = ({ pages }) => pages.filter(({ number, beside }) => number || beside);

export const italics = book => teaching(book).flatMap(page => inItalics(page).map(({ words }) => words));

// The page and the section in which one first says it in italics, or nothing.
export function introduction(book, term) {
  for (const page of teaching(book)) {
    const found = inItalics(page).find(({ words }) => words === plain(term));
    if (!found) continue;
    const line = page.source.slice(0, found.index).split('\n').length;
    return { page, section: page.sections.findLast(section => section.line < line) };
  }
  return null;
}
