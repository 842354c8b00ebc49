// A last look at the finished pages: every link and fragment leads somewhere, no id stands twice.
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
  const page = book.pages.find(p => p.file === file);
  if (!page) return 1;
  const ways = [url, url.replace(page.href, '')].flatMap(way => [`(${way})`, `"${way}"`, `<${way}>`]);
  const at = ways.map(way => page.source.indexOf(way)).find(found => found >= 0) ?? 0;
  return page.source.slice(0, at).split('\n').length;
}
