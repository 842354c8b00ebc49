// What the search looks through: a section of a chapter, an entry of the reference, a claim is one document each.
export function searchScript(documents) {
  const entries = documents.filter(d => d.title).map((d, id) => ({ id, ...d }));
  return `window.BOOK_SEARCH = ${JSON.stringify(entries).replace(/</g, '\\u003c')};\n`;
}

export function chapterDocuments(page, title, sections) {
  const place = page.number ? `Chapter ${page.number}` : '';
  return sections.map(section => ({
    title: section.title || title,
    place: section.title && place ? `${place}, ${title}` : place,
    url: page.href + (section.id && `#${section.id}`),
    text: section.text,
  }));
}

export function apiDocuments(book) {
  return [...book.api.names].map(([name, { href }]) => ({
    title: name,
    place: 'Code reference',
    url: href,
    text: name.split('::').at(-1).replace(/_/g, ' '),
  }));
}

export function claimDocuments(book, claimId) {
  return [...book.claims.keys()].map(name => ({
    title: name,
    place: 'Claim',
    url: `claims.html#${claimId(name)}`,
    text: '',
  }));
}
