// A last look at the finished pages: every link and fragment leads somewhere, no id stands twice.
import { allTokens } from './prose.mjs';

export function checkLinks(book, pages, files) {
  const ids = new Map(pages.map(({ href, html, file }) => [href, idsOf(book, file, href, html)]));
  for (const { href, html, file } of pages) {
    for (const [, url] of html.matchAll(/<a [^>]*?href="([^"]*)"/g)) {
      if (/^(https?:|mailto:)/.test(url)) continue;
      const [path, fragment] = url.split('#');
      const target = path || href;
      if (!ids.has(target) && !files.has(target))
        book.problems.add(file, lineOf(book, file, url), `a link to nothing: ${url}`);
      else if (fragment && ids.has(target) && !ids.get(target).has(fragment))
        book.problems.add(file, lineOf(book, file, url), `a link to nothing: ${target} has no "#${fragment}"`);
    }
  }
}

function idsOf(book, file, href, html) {
  const ids = new Set();
  for (const [, id] of html.matchAll(/<[^>]*? id="([^"]*)"/g)) {
    const named = book.pages.find(page => page.file === file)?.pieces.findLast(piece => piece.id === id);
    if (ids.has(id))
      book.problems.add(file, named?.line ?? 1, `the id "${id}" stands twice in ${href}; rename the section or box`);
    ids.add(id);
  }
  return ids;
}

function lineOf(book, file, url) {
  const tokens = allTokens(book.pages.find(page => page.file === file)?.tokens ?? []);
  return tokens.find(({ type, attrs }) => type === 'link_open' && attrs[0][1] === url)?.map[1] ?? 1;
}
