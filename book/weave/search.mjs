// What the search looks through. Each document has its kind: a page, section, exercise, choice, word, header, claim, a name of the
// reference or literature. What its words are to readers who call the thing by another name stands in book/search.json.
import { nameOneOf } from './problems.mjs';
import { claimId } from './inline.mjs';
import { brief } from './reference-entries.mjs';
import { smarten, textOfHtml } from './text.mjs';
import { WORDS } from './words.mjs';

// Of each page of prose the places that renderPage() found.
export function proseDocuments(page, places) {
  return places.map(place => ({
    kind: page.name === 'references' ? 'literature' : place.kind,
    title: smarten(place.title || page.title),
    place: whereOf(page, place),
    url: page.href + (place.id && `#${place.id}`),
    text: place.text,
    called: place.kind === 'exercise' ? `exercise ${place.number.replace(/.*\./, '')} of chapter ${page.number}` : '',
  }));
}

function whereOf(page, { kind, number }) {
  const title = smarten(page.title);
  if (kind === 'page') return page.number ? `Chapter ${page.number}` : 'Page';
  if (kind === 'section') return number ? `Section ${number}, ${title}` : title;
  if (kind === 'exercise') return `Exercise ${number}, ${title}`;
  return title;
}

// What of the code a reader copies: the headers, and the names in them.
export function codeDocuments(book) {
  const headers = [...book.api.headers.values()];
  const copied = ({ functions, types }) => [...functions, ...types];
  const documents = headers.map(header => ({
    kind: 'header',
    title: header.name,
    place: 'Header to copy',
    url: header.href,
    text: textOfHtml(brief(book, header)),
    called: copied(header)
      .map(({ name }) => spaced(name))
      .join(', '),
  }));
  const addresses = new Set(headers.flatMap(copied).map(({ href }) => href));
  for (const [name, { href }] of book.api.names)
    if (addresses.has(href))
      documents.push({
        kind: 'name',
        title: name,
        place: 'Code reference',
        url: href,
        text: spaced(name.split('::').at(-1)),
      });
  return documents;
}

const spaced = name => name.replace(/_/g, ' ');

// A page that is made of the code, by its sections.
export function madeDocuments({ href, title, body }) {
  return body.split(/(?=<h2 id=")/).map(part => {
    const [, id, name] = part.match(/^<h2 id="([^"]*)">(.*?)<\/h2>/) ?? [];
    const sentences = part.match(/<(p|li|dd|th)\b[^>]*>[^]*?<\/\1>/g) ?? [];
    return {
      kind: 'section',
      title: id ? textOfHtml(name) : title,
      place: id ? title : 'Page',
      url: id ? `${href}#${id}` : href,
      text: textOfHtml(sentences.join(' ')),
    };
  });
}

export const claimDocuments = book =>
  [...book.claims.keys()].map(name => ({
    kind: 'claim',
    title: smarten(name),
    place: 'Claim',
    url: `claims.html#${claimId(name)}`,
    text: '',
  }));

// The script that the search loads: the documents, and the words of its readers.
export function searchScript(book, documents) {
  const { called, same, idle, titles, lineOf } = book.words;
  const urls = documents.map(({ url }) => url);
  for (const url of [...Object.keys(called), ...Object.keys(titles)]) {
    if (!urls.includes(url))
      book.problems.add(WORDS, lineOf(url), `there is no place "${url}" in the book.${nameOneOf(url, urls)}`);
  }
  const entries = documents.map((document, id) => ({
    id,
    ...document,
    called: called[document.url] ?? document.called,
  }));
  return `window.BOOK_SEARCH = ${JSON.stringify({ documents: entries, same, idle }).replace(/</g, '\\u003c')};\n`;
}
